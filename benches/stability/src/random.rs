//! Ten thousand scenes at random, a thousand of each of ten kinds, by every rule: is what comes out finite, does it balance, is the energy
//! that of the start?
//!
//! *Balance*: the torque at each joint, found from the bodies' accelerations inward, less that of its spring, as a share of the largest
//! force times the length of the chain; held tips must not accelerate. *Energy*: its change, as a share of the largest kinetic energy on the
//! way. Springs have no dampers, the ground rests. Runs take 0.2 s, under error control at 1e-8.

mod plane;
mod space;

use crate::table::Table;
use catena::loading::Unloaded;
use catena::simulate::Method;
use catena::system::{Element, MotionOf, Root, Runs, Space, System, Tip};
use catena::time::Rule;
use catena_oracle::Noise;

const END: f64 = 0.2;

/// What came of a kind of scene under a rule.
struct Tally {
    kind: &'static str,
    rule: &'static str,
    tried: usize,
    refused: Vec<(String, u64)>,
    /// Not finite, and no error returned.
    silent: Vec<u64>,
    /// The largest of each, and the seed.
    balance: (f64, u64),
    energy: (f64, u64),
}

#[derive(Default)]
struct Tallies(Vec<Tally>);

impl Tallies {
    fn of(&mut self, kind: &'static str, rule: &'static str) -> &mut Tally {
        if let Some(at) = self.0.iter().position(|tally| (tally.kind, tally.rule) == (kind, rule)) {
            return &mut self.0[at];
        }
        let (refused, silent) = (vec![], vec![]);
        self.0.push(Tally { kind, rule, tried: 0, refused, silent, balance: (0.0, 0), energy: (0.0, 0) });
        let last = self.0.len() - 1;
        &mut self.0[last]
    }
}

/// One run of one scene.
#[allow(clippy::too_many_arguments, clippy::type_complexity)] // what is run, by what, who it is; types are those of the scene
fn trial<S, R, C, P, M>(
    tallies: &mut Tallies,
    kind: &'static str,
    name: &'static str,
    seed: u64,
    scene: &System<S, R, C, P>,
    start: &MotionOf<S, R, C, P>,
    rule: Rule<M, f64>,
    balance: &dyn Fn(&System<S, R, C, P>, &MotionOf<S, R, C, P>) -> Result<f64, catena::Error>,
) where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    M: for<'s> Method<&'s System<S, R, C, P>, Unloaded>,
{
    let tally = tallies.of(kind, name);
    tally.tried += 1;
    let outcome = || -> Result<Option<[f64; 2]>, catena::Error> {
        let before = scene.budget(start)?;
        let mut most = 0.0_f64;
        let run = scene.simulation(rule).run(start.clone(), END, |now| most = most.max(now.budget().kinetic))?;
        let end = scene.with_accelerations(run.motion, &Unloaded)?;
        let drift = (scene.budget(&end)?.energy() - before.energy()).abs() / most;
        let off = balance(scene, &end)?;
        Ok((end.is_finite() && drift.is_finite() && off.is_finite()).then_some([off, drift]))
    };
    match outcome() {
        Err(error) => {
            // Without numbers, so that equal faults are counted together.
            let text: String = format!("{:?}", error.fault).chars().take_while(|c| c.is_alphanumeric()).collect();
            tally.refused.push((text, seed));
        }
        Ok(None) => tally.silent.push(seed),
        Ok(Some([balance, energy])) => {
            let more = |worst: &mut (f64, u64), found: f64| {
                if found > worst.0 {
                    *worst = (found, seed);
                }
            };
            more(&mut tally.balance, balance);
            more(&mut tally.energy, energy);
        }
    }
}

/// What a motion is out of balance by, the worst of what the block hands to `note`, in torques over the largest force times the farthest
/// place; of a tip that is held, its acceleration, too, over the largest.
macro_rules! worst {
    ($scene:expr, $motion:expr, $held:expr, |$stations:ident, $note:ident| $joints:block) => {{
        let $stations = $scene.stations($motion, &Unloaded)?;
        let (mut force, mut reach) = (1e-300_f64, 1e-300_f64);
        for station in $stations.iter().chain([$stations.root(), $stations.tip()]) {
            force = force.max(station.internal.force.norm());
            reach = reach.max(station.frame.place.norm());
        }
        let mut worst = 0.0;
        let mut more = |off: f64| worst = if off.is_nan() || off > worst { off } else { worst };
        let mut $note = |torque: f64| more(torque / (force * reach));
        $joints
        if $held {
            let tip = $stations.tip().frame.acceleration.linear.norm();
            let bodies = $scene.body_motions($motion)?;
            let most = bodies.iter().map(|body| body.outboard().acceleration.linear.norm()).fold(1e-300_f64, f64::max);
            more(tip / most);
        }
        Ok(worst)
    }};
}
use worst;

/// Runs a scene by every rule; where it says so by Taylor series as well.
macro_rules! rules {
    (@ $name:literal, $rule:expr; $tallies:ident, $kind:expr, $seed:ident, $scene:ident, $start:ident, $balance:expr) => {
        trial($tallies, $kind, $name, $seed, &$scene, &$start, $rule, $balance);
    };
    (taylor $($what:tt)*) => {
        rules!(@ "Taylor 16", catena::planar::Taylor::<16>::tolerance(1e-8); $($what)*);
        rules!($($what)*);
    };
    ($($what:tt)*) => {
        rules!(@ "RK4 of 0.5 ms", catena::time::Rk4::step(5e-4); $($what)*);
        rules!(@ "DOPRI5", catena::time::Dopri5::tolerance(1e-8); $($what)*);
        rules!(@ "DOP853", catena::time::Dop853::tolerance(1e-8); $($what)*);
        rules!(@ "Adams", catena::time::Adams::tolerance(1e-8); $($what)*);
        rules!(@ "Vcabm", catena::time::Vcabm::default().tolerance(1e-8); $($what)*);
        rules!(@ "generalised-alpha", catena::time::GeneralizedAlpha::new(0.8).tolerance(1e-8); $($what)*);
        rules!(@ "SDIRK4", catena::time::Sdirk4::new().tolerance(1e-8); $($what)*);
    };
}

pub(crate) use rules;

/// Parameters over two decades.
fn size(noise: &mut Noise) -> f64 {
    10_f64.powf(noise.between(-1.0, 1.0))
}

/// What is read of a tally: a number, and what there is to say.
type Reading = fn(&Tally) -> (f64, String);
const READINGS: [(&str, Reading); 4] = [
    ("balance", |tally| (tally.balance.0, format!("seed {}", tally.balance.1))),
    ("energy", |tally| (tally.energy.0, format!("seed {}", tally.energy.1))),
    ("share refused", |tally| {
        let mut faults: Vec<(&str, usize, u64)> = vec![];
        for (fault, seed) in &tally.refused {
            match faults.iter_mut().find(|(text, ..)| text == fault) {
                Some((_, count, _)) => *count += 1,
                None => faults.push((fault, 1, *seed)),
            }
        }
        let said = faults.iter().map(|(fault, count, seed)| format!("{count} {fault}, first seed {seed}"));
        (tally.refused.len() as f64 / tally.tried as f64, said.collect::<Vec<String>>().join("; "))
    }),
    ("share not finite without an error", |tally| {
        let said = tally.silent.first().map_or(String::new(), |seed| format!("first seed {seed}"));
        (tally.silent.len() as f64 / tally.tried as f64, said)
    }),
];

/// A kind of scene by its number among the ten.
type Kind = fn(&mut Tallies, u64) -> Result<(), catena::Error>;

pub fn run(table: &mut Table, quick: bool) {
    const KINDS: [(&str, Kind); 10] = [
        ("plates on pins", plane::plates),
        ("rods on springs", plane::springs),
        ("trees on pins", plane::trees),
        ("pins, tip held", plane::held),
        ("networks of pins", plane::networks),
        ("floating plates", plane::floating),
        ("bodies on balls", space::balls),
        ("bodies on revolutes", space::revolutes),
        ("floating bodies", space::floating),
        ("balls, tip held", space::held),
    ];
    let each = if quick { 10 } else { 1000 };
    let mut all = Tallies::default();
    for (name, kind) in KINDS {
        let mut unmade: Vec<(u64, String)> = vec![];
        for seed in 0..each {
            if seed % 10 == 0 {
                crate::progress(&format!("random, {name}, {seed} of {each}"));
            }
            if let Err(error) = kind(&mut all, seed) {
                unmade.push((seed, error.to_string()));
            }
        }
        let share = unmade.len() as f64 / each as f64;
        table.add("random", name, "scenes", each as f64, "no start found", "f64", Ok(share));
        if let Some((seed, text)) = unmade.first() {
            table.note(format!("{} scenes; the first {seed}: {text}", unmade.len()));
        }
        for (axis, read) in READINGS {
            for tally in all.0.iter().filter(|tally| tally.kind == name) {
                let (outcome, note) = read(tally);
                table.add("random", name, axis, tally.tried as f64, tally.rule, "f64", Ok(outcome));
                table.note(note);
            }
        }
    }
}
