//! Taylor series of chains whose tips are held: runs, closures and what holds them, beside rules that know no series.
//!
//! Coefficients are those of `series_held.csv`, whose head says how they were found.

use super::by_series::{apart, are_coefficients_of, beside_dop853, expansion, goes_on, move_alike};
use catena::Error;
use catena::planar::*;

const G: f64 = 9.81;

/// Three unlike rods between pins.
macro_rules! bridge {
    () => {{
        let chain = (Rod::uniform(1.0, 1.0), Pin, Rod::uniform(0.7, 0.4), Pin, Rod::uniform(0.9, 0.6));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(1.5, 0.2))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[-0.9, 0.1, 0.8])?, &Unloaded)?;
        (scene, start)
    }};
}

/// All bodies and joints that have series, with an arm, on a tip that is clamped.
macro_rules! clamped {
    () => {{
        let (rod, body) = (Rod::uniform(0.5, 0.5), RigidBody::new(0.8, 0.05, [0.2, 0.1], [0.4, -0.1]));
        let hinge = ElasticHinge::rotary(3.0).damped(0.1).resting_at(0.2);
        let arm = Branch((hinge, rod, Weld::at(0.4), body));
        let track = Slider::along(0.3).with(Spring::new(50.0).damped(0.5).resting_at(0.1));
        let chain = (body, arm, Pin, rod, track, PointMass::new(0.3, 0.2), hinge, body, Pin, rod);
        let scene = System::new(Pinned::origin(), chain, Clamped::at(1.2, 0.1, -0.4))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[0.3, -0.2, 0.5, 0.1, 0.7])?, &Unloaded)?;
        (scene, start)
    }};
}

/// A slider-crank whose piston keeps its angle.
macro_rules! crank {
    () => {{
        let chain = (
            Rod::uniform(0.4, 0.5),
            Pin,
            Rod::uniform(1.1, 0.8),
            Pin,
            RigidBody::new(0.6, 0.02, [0.0, 0.0], [0.0, 0.0]),
        );
        let scene = System::new(Pinned::origin(), chain, Guided::at(1.0, 0.1, 0.2))?.with_gravity(G);
        let start = scene.assembled(scene.at_rest(&[0.9, -0.2, 0.2])?, &Unloaded)?;
        (scene, start)
    }};
}

macro_rules! compare {
    ($name:literal, $scene:expr) => {{
        let (scene, start) = $scene;
        let (series, other) = beside_dop853!(20, scene, Unloaded, start, 1.0);
        let (a, b) = (&series.motion, &other.motion);
        let of_acceleration = apart(&a.accelerations(), &b.accelerations());
        let off = [apart(&a.coordinates(), &b.coordinates()), of_acceleration, apart(a.multipliers(), b.multipliers())];
        move_alike($name, [series.steps, other.steps], off);
    }};
}

#[test]
fn held_chains_move_as_under_dop853() -> Result<(), Error> {
    compare!("bridge", bridge!());
    compare!("clamped", clamped!());
    compare!("crank", crank!());
    Ok(())
}

#[test]
fn coefficients_are_those_of_equations_with_multipliers() -> Result<(), Error> {
    /// The tip need not be where it is held: coefficients are those of what closures demand of accelerations.
    macro_rules! expand {
        ($name:literal, $scene:expr, $angles:expr, $rates:expr) => {{
            let scene = $scene.with_gravity(G);
            let start = scene.with_rates(scene.at_rest(&$angles)?, &$rates)?;
            let mut stepper = scene.stepper(Taylor::<20>);
            assert!(stepper.propose(&start, &Unloaded, 1e-10).is_some() && stepper.error_order() < 20);
            let (found, _) = expansion!(20, scene, start, Unloaded, 1e-6);
            are_coefficients_of(include_str!("series_held.csv"), $name, &found, 1e-13);
        }};
    }
    let rods = || (Rod::uniform(1.0, 1.0), Pin, Rod::uniform(0.7, 0.4), Pin, Rod::uniform(0.9, 0.6));
    let bridge = System::new(Pinned::origin(), rods(), Pinned::at(1.5, 0.2))?;
    expand!("bridge", bridge, [-0.9, 0.1, 0.8], [0.8, -1.5, 0.4]);
    let piston = RigidBody::new(0.6, 0.02, [0.0, 0.0], [0.0, 0.0]);
    let chain = (Rod::uniform(0.4, 0.5), Pin, Rod::uniform(1.1, 0.8), Pin, piston);
    let crank = System::new(Pinned::origin(), chain, Guided::at(1.0, 0.1, 0.2))?;
    expand!("crank", crank, [0.9, -0.2, 0.2], [0.8, -1.5, 0.4]);
    let chain = (rods(), Pin, Rod::uniform(0.5, 0.3));
    let frozen = System::new(Pinned::origin(), chain, Clamped::at(1.5, 0.2, -0.4))?;
    expand!("frozen", frozen, [-0.9, 0.1, 0.8, -0.4], [0.8, -1.5, 0.4, 0.0]);
    Ok(())
}

#[test]
fn readings_within_a_step_are_closed() -> Result<(), Error> {
    let (scene, start) = bridge!();
    let ((mut most, mut sampled), mut bare) = ((0.0_f64, 0), 0.0_f64);
    let run = scene.simulation(Taylor::<20>::tolerance(1e-10)).every(0.01).run(start, 1.0, |now| {
        sampled += 1;
        let tip = scene.stations(now.motion(), &Unloaded).map(|stations| stations.tip().frame.place);
        most = tip.map_or(f64::NAN, |tip| (tip.x - 1.5).abs().max((tip.y - 0.2).abs())).max(most);
        bare = bare.max(now.motion().multipliers()[0].abs());
    })?;
    println!("{} steps, {sampled} samples, missed by {most:.1e}", run.steps);
    assert!(sampled > 90 && most < 1e-14 && bare > 0.1 && run.sweeps > run.steps);
    Ok(())
}

#[test]
fn a_run_goes_on_as_if_it_had_not_stopped() -> Result<(), Error> {
    let (scene, start) = bridge!();
    goes_on!(20, scene, start, coordinates, multipliers);
    Ok(())
}
