//! Taylor series around loops in the plane: coefficients, runs, closures and forces, beside what knows no series.
//!
//! Coefficients are those of `series_loops.csv`, whose head says how they were found.

use super::by_series::{
    Drive, apart, are_coefficients_of, beside_dop853, beside_dop853_with_forces, closed_beside_dop853,
    ends_in_single_precision, errors_within_steps, expansion, goes_on, hangs_at_odd_quarters, move_alike,
};
use catena::planar::*;
use catena::{Error, Scalar};
use catena_oracle::has_order;

const G: f64 = 9.81;

/// A rod of one kilogram a metre.
fn rod<T: Scalar>(length: T) -> Rod<T> {
    Rod::uniform(length, length)
}

/// A four-bar linkage on the ground whose coupler has a length.
macro_rules! four_bar {
    ($n:expr, $coupler:expr) => {{
        let n = $n;
        let (crank, follower) = ((Pin, rod(n(0.5)), Pin, rod($coupler)), (Pin, rod(n(0.9))));
        let rocker = (RigidBody::massless([n(1.0), n(0.0)]), follower.0, follower.1);
        System::new(Clamped::at(n(0.0), n(0.0), n(0.0)), Network::new(crank, rocker, Pin), Free)?.with_gravity(n(G))
    }};
}

/// A loop in an arm of another, a rod before them and one behind.
macro_rules! nested {
    () => {{
        let inner = Network::new((Pin, rod(0.6), Pin, rod(0.5)), (Pin, rod(0.45), Pin, rod(0.55)), Pin);
        let net = Network::new((inner, Pin, rod(0.4)), (Pin, rod(0.7), Pin, rod(0.8)), Pin);
        System::new(Pinned::origin(), (rod(0.8), net, Pin, rod(0.5)), Free)?.with_gravity(G)
    }};
}

/// A loop with a slider that a weld closes, on a tip that is held.
macro_rules! tracked {
    () => {{
        let track = Slider::along(0.3).with(Spring::new(50.0).damped(0.5).resting_at(0.1));
        let side = (Pin, rod(0.45), track, rod(0.3), Pin, rod(0.4));
        let net = Network::new((Pin, rod(0.6), Pin, rod(0.5)), side, Weld::at(0.3));
        System::new(Pinned::origin(), (rod(0.8), net, Pin, rod(0.7)), Pinned::at(1.0, -0.9))?.with_gravity(G)
    }};
}

/// A carriage with a loop of its own, an arm in it and a rod behind.
macro_rules! carriage {
    () => {{
        let hinge = ElasticHinge::rotary(3.0).damped(0.1).resting_at(0.2);
        let arm = (Pin, rod(0.5), Branch((hinge, PointMass::new(0.3, 0.2))), hinge, rod(0.5), Pin, rod(0.5));
        let swing = ClosedLoop::ending_at([0.8, 0.0], arm, Pin);
        let carriage = RigidBody::new(2.0, 0.1, [0.2, 0.0], [0.0, 0.0]);
        System::new(Pinned::origin(), (rod(0.4), Pin, carriage, swing, Pin, rod(0.3)), Free)?.with_gravity(G)
    }};
}

/// Cranks of mass 0.5 and a coupler of mass 0.8.
macro_rules! parallelogram {
    () => {{
        let (crank, coupler) = (Rod::uniform(0.6, 0.5), Rod::uniform(1.0, 0.8));
        let net = Network::new((Pin, crank, Pin, coupler), (RigidBody::massless([1.0, 0.0]), Pin, crank), Pin);
        System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(G)
    }};
}

const OF_FOUR_BAR: [f64; 3] = [1.05, 0.32, 1.12];
const OF_NESTED: [f64; 9] = [-1.0, -0.5, -2.1, -1.97, -0.62, -0.7, -0.4, -1.2, -0.7];

#[test]
fn coefficients_are_those_of_equations_with_multipliers() -> Result<(), Error> {
    /// Ends of loops need not be where they are held: coefficients are those of what closures demand of accelerations.
    macro_rules! expand {
        ($name:literal, $scene:expr, $coordinates:expr, $rates:expr) => {{
            let scene = $scene;
            let mut start = scene.motion();
            start.set_coordinates(&$coordinates)?;
            let start = scene.with_rates(start, &$rates)?;
            let (found, _) = expansion!(20, scene, start, Unloaded, 1e-6);
            are_coefficients_of(include_str!("series_loops.csv"), $name, &found, 1e-13);
        }};
    }
    let rates = [0.8, -1.5, 0.4, 0.3, -0.6, 1.0, -0.2, 0.5, 0.9];
    // The massless body that reaches to the rocker has no coordinate of its own.
    expand!("four-bar", four_bar!(f64::from, 1.2), OF_FOUR_BAR, rates[..3]);
    expand!("nested", nested!(), OF_NESTED, rates);
    expand!("tracked", tracked!(), [-1.0, -0.5, -0.9, -0.7, 0.15, -0.4, -0.3], rates[..7]);
    Ok(())
}

#[test]
fn loops_move_as_under_dop853() -> Result<(), Error> {
    macro_rules! compare {
        ($name:literal, $scene:expr, $coordinates:expr, $loads:expr) => {{
            let scene = $scene;
            let mut start = scene.motion();
            start.set_coordinates(&$coordinates)?;
            closed_beside_dop853!($name, scene, $loads, start, 0.7, abs);
        }};
    }
    compare!("four-bar", four_bar!(f64::from, 1.2), OF_FOUR_BAR, Unloaded);
    let torques = Loads::none().torques([0.2, 1.0, 0.4, -0.5, 0.3]);
    compare!("four-bar under torques", four_bar!(f64::from, 1.2), OF_FOUR_BAR, torques);
    compare!("nested", nested!(), OF_NESTED, Loads::none().in_joints_over_time(Drive));
    compare!("tracked", tracked!(), [-1.0, -0.5, -0.9, -0.7, 0.15, -0.4, -0.3], Unloaded);
    compare!("carriage", carriage!(), [-0.3, 0.2, -1.2, 0.5, 0.9, 0.1, 0.4], Unloaded);
    Ok(())
}

#[test]
fn readings_within_a_step_are_closed() -> Result<(), Error> {
    let scene = nested!();
    let mut start = scene.motion();
    start.set_coordinates(&OF_NESTED)?;
    let start = scene.assembled(start, &Unloaded)?;
    let (mut most, mut sampled) = (0.0_f64, 0);
    let run = scene.simulation(Taylor::<20>::tolerance(1e-10)).every(0.01).run(start, 1.0, |now| {
        sampled += 1;
        let bodies =
            scene.body_motions(now.motion()).map_or_else(|_| vec![], |bodies| bodies.iter().copied().collect());
        let end = |k: usize| bodies.get(k).map_or([f64::NAN; 2], |body| body.outboard().place.into());
        // Bodies: 0 | 1 2, 3 4 | 5, 6 7 | 8.
        most = most.max(apart(&end(2), &end(4))).max(apart(&end(5), &end(7)));
    })?;
    println!("{} steps, {sampled} samples, missed by {most:.1e}", run.steps);
    assert!(sampled > 90 && most < 1e-14 && run.sweeps > run.steps);
    Ok(())
}

#[test]
fn orders_are_those_of_the_series() -> Result<(), Error> {
    let scene = four_bar!(f64::from, 1.2);
    let start = scene.assembled(scene.at_rest(&OF_FOUR_BAR)?, &Unloaded)?;
    let [within, rates] = errors_within_steps!(scene, start, [0.1, 0.09, 0.08, 0.07]);
    has_order("position within a step", 10.0, 1e-14, &within);
    has_order("rate within a step", 9.0, 1e-14, &rates);
    // Runs of the four-bar come to their order (7.3 to 7.9) just before rounding; those of a parallelogram show it earlier.
    let scene = parallelogram!();
    let start = scene.at_rest(&[-0.7, 0.0, -0.7])?;
    let exact = scene.simulate(start, Taylor::<30>::tolerance(1e-15), 0.3, |_| ())?.motion;
    let mut whole = vec![];
    for steps in [8.0, 10.0, 12.0, 15.0] {
        let run = scene.simulate(start, Taylor::<8>::step(0.3 / steps), 0.3, |_| ())?;
        whole.push((0.3 / steps, apart(&run.motion.coordinates(), &exact.coordinates())));
    }
    has_order("a run of steps of one size", 8.0, 1e-14, &whole);
    Ok(())
}

#[test]
fn a_parallelogram_swings_as_a_pendulum() -> Result<(), Error> {
    // Cranks of mass m and a coupler of mass M, l (2 m / 3 + M) θ̈ = −(m + M) g cos θ: quarters of K(sin ¼π) / ω take it from 45° above
    // the lowest place to it, by the arithmetic-geometric mean.
    let scene = parallelogram!();
    let lowest = -core::f64::consts::FRAC_PI_2;
    let amplitude = core::f64::consts::FRAC_PI_4;
    let start = scene.at_rest(&[lowest + amplitude, 0.0, lowest + amplitude])?;
    let first = scene.budget(&start)?.energy();
    let rate = ((0.5 + 0.8) * G / (0.6 * (2.0 * 0.5 / 3.0 + 0.8))).sqrt();
    let (mut a, mut b) = (1.0, (0.5 * amplitude).cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let quarter = core::f64::consts::FRAC_PI_2 / a / rate;
    let (mut found, mut drift) = (vec![], 0.0_f64);
    let run = scene
        .simulation(Taylor::<20>::tolerance(1e-14))
        .event(|now| now.motion().coordinates()[0] - lowest)
        .run(start, 7.5 * quarter, |now| {
            drift = drift.max((now.energy() - first).abs());
            if now.is_event() {
                found.push(now.time());
            }
        })?;
    println!("{} steps, events at {found:?}, a quarter is {quarter}, energy {drift:.1e}", run.steps);
    hangs_at_odd_quarters(&found, quarter);
    assert!(drift < 1e-12);
    Ok(())
}

#[test]
fn single_precision_keeps_its_digits() -> Result<(), Error> {
    let scene = four_bar!(f64::from, 1.2);
    let start = scene.assembled(scene.at_rest(&OF_FOUR_BAR)?, &Unloaded)?;
    let exact = scene.simulate(start, Taylor::<20>::tolerance(1e-14), 1.0, |_| ())?.motion.coordinates();
    let single = scene.lift(|x| x as f32);
    let start = single.assembled(single.at_rest(&OF_FOUR_BAR.map(|x| x as f32))?, &Unloaded)?;
    let run = single.simulate(start, Taylor::<8>::tolerance(1e-6), 1.0, |_| ())?;
    ends_in_single_precision(run.steps, run.motion.coordinates(), &exact);
    assert_eq!(run.rejected, 0);
    Ok(())
}

#[test]
fn a_run_goes_on_as_if_it_had_not_stopped() -> Result<(), Error> {
    let scene = nested!();
    let mut start = scene.motion();
    start.set_coordinates(&OF_NESTED)?;
    let start = scene.assembled(start, &Unloaded)?;
    goes_on!(20, scene, start, coordinates, rates, accelerations);
    Ok(())
}
