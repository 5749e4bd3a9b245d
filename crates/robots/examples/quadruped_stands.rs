//! A quadruped is dropped, pushed, and stands: twelve joints and a floating trunk from a description (URDF), feet that touch the ground.
//!
//! Its joints have the description's damping, dry friction and stops as laws; a controller makes springs and dampers of its motors, 500
//! times a second, within what these can give. Contacts are compliant, with friction, and taken linearly implicitly: steps are as long as
//! the controller's, while friction at rest alone would ask for steps two hundred times shorter.
//!
//! ```text
//! cargo run --release -p catena-robots --example quadruped_stands
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;
#[path = "pictures/quadruped_stands.rs"]
mod pictures;

use catena::Fault;
use catena::robot::*;
use catena::system::MotionOf;
use catena_robots::quadruped;
use common::Drawn;
use std::time::Instant;

type Scene = quadruped::Scene<f64>;
type State = MotionOf<Spatial<f64>, Free, quadruped::Chain<f64>, Free>;

const CYCLE: f64 = 2e-3; // (s)
const END: f64 = 10.0; // (s)
const DROP: f64 = 0.25; // of the feet above the ground (m)
/// Angles at which it stands: hip, thigh and knee of each leg; the last knee is written the other way around.
const STANCE: [f64; 12] = [0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, -0.7, -1.4];
const SPRING: f64 = 300.0; // (N·m/rad)
const DAMPER: f64 = 6.0; // (N·m·s/rad)
/// A push of the trunk: when it begins and ends (s), and its force (N).
const PUSH: [f64; 2] = [1.6, 1.8];
const FORCE: [f64; 3] = [20.0, 110.0, 0.0];
const FILMED: f64 = 3.2; // (s)

type Ground = Contacts<[(usize, [f64; 3]); 4], Plane<f64>, Contact<f64>>;

/// Feet of the legs: left and right in front, left and right behind. One that is part of the ground has no body: contacts refuse it.
fn feet() -> Ground {
    use quadruped::frame::{LF_FOOT, LH_FOOT, RF_FOOT, RH_FOOT};
    let points = [LF_FOOT, RF_FOOT, LH_FOOT, RH_FOOT].map(|foot| (foot.body.unwrap_or(usize::MAX), foot.place));
    // Stiffness (N/m) that sets in over a depth (m), damping (s/m), coefficient of friction and the speed of creeping (m/s).
    Contacts::of(points, Plane::level(0.0), Contact::new(1e5, 2e-4).damped(1.0).rubbing(0.8, 1e-4))
}

/// What acts on bodies: the ground on the feet, and a push on the trunk.
#[derive(Clone, Copy)]
struct Acting {
    ground: Ground,
    push: [f64; 3],
}

impl LoadLaw<BodyMotion<f64>> for Acting {
    type Value = Yielding<f64>;
    fn at(&self, time: f64, number: usize, body: &BodyMotion<f64>) -> Yielding<f64> {
        let contact = self.ground.at(time, number, body);
        let push = if number == 0 { body.force_at([0.0; 3], self.push) } else { Wrench::default() };
        contact + Yielding::new(push, Block::zero(), Block::zero())
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        self.ground.check(bodies)
    }
}

/// Torques that hold the stance, as far as motors can give them.
fn torques(now: &State) -> Result<[f64; 12], catena::Error> {
    let (mut q, mut v, motors) = ([0.0; 19], [0.0; 18], quadruped::motors::<f64>());
    now.coordinates_into(&mut q)?;
    now.rates_into(&mut v)?;
    Ok(core::array::from_fn(|k| {
        let wanted = -SPRING * (q[7 + k] - STANCE[k]) - DAMPER * v[6 + k];
        motors[k].map_or(wanted, |motor| motor.torque(wanted, v[6 + k]))
    }))
}

/// What is seen of an instant.
struct Sample {
    time: f64,
    trunk: [f64; 3],
    feet: [[f64; 3]; 4],
    /// Forces on the feet (N).
    forces: [[f64; 3]; 4],
    /// Corners of the trunk, then hip, knee and foot of each leg.
    frame: Vec<Vec<[f64; 3]>>,
}

fn sample(scene: &Scene, now: &State, ground: &Ground) -> Result<Sample, catena::Error> {
    let bodies = scene.body_motions(now)?;
    let nowhere = [f64::NAN; 3];
    let at = |body: usize, place| bodies.get(body).map_or(nowhere, |body| body.point(place).place.into());
    let points: [(usize, [f64; 3]); 4] = core::array::from_fn(|k| ground.points()[k]);
    let (x, y) = (0.25, 0.07);
    let trunk = [[x, y, 0.0], [x, -y, 0.0], [-x, -y, 0.0], [-x, y, 0.0], [x, y, 0.0]];
    // Body 0 is the trunk, then come hip, thigh and shank of each leg.
    let leg = |k: usize| {
        vec![at(3 * k + 1, [0.0; 3]), at(3 * k + 2, [0.0; 3]), at(3 * k + 3, [0.0; 3]), at(points[k].0, points[k].1)]
    };
    Ok(Sample {
        time: now.time(),
        trunk: at(0, [0.0; 3]),
        feet: points.map(|(body, place)| at(body, place)),
        forces: core::array::from_fn(|k| bodies.get(points[k].0).map_or(nowhere, |body| ground.force(k, body))),
        // Those on the far side first, so that what is nearer is drawn over them.
        frame: vec![leg(0), leg(2), trunk.map(|place| at(0, place)).to_vec(), leg(1), leg(3)],
    })
}

fn main() -> Drawn {
    let (scene, ground) = (quadruped::scene::<f64>()?, feet());
    let mut now = scene.motion();
    let list: Vec<f64> = [0.0, 0.0, 0.406 + DROP, 1.0, 0.0, 0.0, 0.0].into_iter().chain(STANCE).collect();
    now.set_coordinates(&list)?;
    let mass: f64 = scene.body_motions(&now)?.iter().map(|body| body.inertia.mass).sum();
    let (mut next, weight) = (now, 9.81 * mass);
    let mut log = vec![sample(&scene, &now, &ground)?];
    let (mut stepper, started, mut worked) = (scene.stepper(Sdirk4::new()), Instant::now(), 0.0);
    for cycle in 0..(END / CYCLE).round() as usize {
        let time = cycle as f64 * CYCLE;
        let push = if (PUSH[0]..PUSH[1]).contains(&time) { FORCE } else { [0.0; 3] };
        let loads = Loads::none().on_bodies_by(Acting { ground, push }).efforts(quadruped::efforts(torques(&now)?));
        let begun = started.elapsed().as_secs_f64();
        stepper.step(&now, &loads, CYCLE, &mut next)?;
        worked += started.elapsed().as_secs_f64() - begun;
        core::mem::swap(&mut now, &mut next);
        log.push(sample(&scene, &now, &ground)?);
    }

    let pushed = PUSH[1] - PUSH[0];
    println!("A quadruped of {mass:.1} kg falls {DROP} m, is pushed by {FORCE:?} N for {pushed:.1} s, and stands.\n");
    println!("  time   trunk at x, y, z (m)          feet push (N)                  sum / weight");
    for sample in log.iter().step_by(500) {
        let [x, y, z] = sample.trunk;
        let [a, b, c, d] = sample.forces.map(|[_, _, up]| up);
        let share = (a + b + c + d) / weight;
        println!("{:6.2}  {x:9.4} {y:9.4} {z:8.4}  {a:7.2} {b:7.2} {c:7.2} {d:7.2}   {share:.9}", sample.time);
    }
    let calm = log.iter().filter(|sample| sample.time > 4.0);
    let ways = (0..8).map(|k| common::range(calm.clone().map(|sample| sample.feet[k / 2][k % 2]), 0.0));
    let drift = ways.map(|way| way.end - way.start).fold(0.0, f64::max);
    println!("\nFrom 4 s on no foot moves by more than {:.3} mm, in {:.0} s.", 1e3 * drift, END - 4.0);
    println!("{END} s take {worked:.2} s, {:.0} µs a step of {:.0} ms.", 1e6 * worked * CYCLE / END, 1e3 * CYCLE);
    let sum: f64 = log.last().map_or(f64::NAN, |sample| sample.forces.iter().map(|force| force[2]).sum());
    if drift.is_nan() || drift > 1e-3 || (sum / weight - 1.0).abs() > 1e-6 {
        return Err("it does not stand".into());
    }
    println!("{}", pictures::draw(&log)?.display());
    Ok(())
}
