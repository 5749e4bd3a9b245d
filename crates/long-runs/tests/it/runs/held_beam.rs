//! A straight beam that stretches, clamped at both ends and struck: implicit rules with forces that hold the tip.

use catena::Error;
use catena::loading::Loading;
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Runs;
use catena::time::Rule;
use catena_oracle::{has_order, near};
use core::f64::consts::PI;

const K: usize = 6;
const L: f64 = 1.5;
/// End of the blow (s), and times at which errors are measured: at a single one a leading term may vanish.
const BLOW: f64 = 0.1;
const TIMES: [f64; 4] = [0.08, 0.16, 0.24, 0.32];

type Clamp = Clamped<[f64; 2], f64>;
type Chain = Segments<f64, [(Slider<f64, Spring<f64>>, ElasticHinge<Spring<f64>>, Rod<f64>); K]>;
type Held = System<f64, Clamp, Chain, Clamp>;

/// Deflection of the middle (m), and force and torque of the ground on the tip (N, N·m), at each of the times.
fn run<X, M>(beam: &Held, blow: &X, rule: Rule<M, f64>) -> Result<[[f64; 4]; 4], Error>
where
    X: Loading<Planar<f64>>,
    Held: Runs<X, Planar<f64>, Clamp, Chain, Clamp>,
    M: for<'s> Method<&'s Held, X> + Copy,
{
    let mut motion = beam.motion();
    let mut read = [[0.0; 4]; 4];
    for (time, read) in TIMES.into_iter().zip(&mut read) {
        motion = beam.simulation(rule).loads(blow).run(motion, time, |_| ())?.motion;
        let [x, y, torque] = *motion.multipliers();
        let bodies = beam.body_motions(&motion).unwrap();
        *read = [bodies.get(K / 2).unwrap().centre().place.y, x, y, torque];
        // The tip stays where it is held.
        let tip = beam.stations(&motion, blow).unwrap().tip().frame;
        near(tip.place.x, L, 1e-13);
        near(tip.place.y, 0.0, 1e-13);
        near(tip.turn.angle, 0.0, 1e-13);
    }
    Ok(read)
}

#[test]
fn rules_have_their_order_on_a_beam_held_at_both_ends() -> Result<(), Error> {
    let chain = Beam::new(L, 2.0, 0.8).with_extension(500.0).segments::<K>();
    let beam = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Clamped::at(L, 0.0, 0.0))?;
    let middle = [0.5 * L / K as f64, 0.0];
    // Smooth in time.
    let blow = Loads::none().on_bodies(|time: f64, body, motion: &BodyMotion<f64>| {
        let force = if body == K / 2 && time < BLOW { 20.0 * (PI * time / BLOW).sin().powi(4) } else { 0.0 };
        motion.force_at(middle, [0.0, force])
    });
    let exact = run(&beam, &blow, Dop853::tolerance(1e-13))?;
    println!("deflection, force and torque: {exact:.6?}");
    // It is large: the pull is of the size of the push.
    assert!(exact.iter().any(|now| now[1].abs() > 1.0));
    let errors = |found: [[f64; 4]; 4], k: usize| {
        exact.iter().zip(found).map(|(exact, found)| (exact[k] - found[k]).powi(2)).sum::<f64>().sqrt()
    };
    let names = ["deflection", "force along", "force across", "torque"];
    let mut points = [const { vec![] }; 4];
    for h in [0.001, 0.0005, 0.00025] {
        let found = run(&beam, &blow, GeneralizedAlpha::new(0.8).step(h))?;
        (0..4).for_each(|k| points[k].push((h, errors(found, k))));
    }
    for (name, points) in names.iter().zip(&points) {
        has_order(&format!("generalised-alpha, {name}"), 2.0, 1e-12, points);
    }
    let mut points = [const { vec![] }; 4];
    for h in [0.002, 0.001, 0.0005] {
        let found = run(&beam, &blow, Sdirk4::new().step(h))?;
        (0..4).for_each(|k| points[k].push((h, errors(found, k))));
    }
    for (name, points) in names.iter().zip(&points) {
        has_order(&format!("SDIRK4, {name}"), 4.0, 1e-12, points);
    }
    Ok(())
}
