//! Taylor series in space where a tip is held or a loop is closed: runs, closures and forces, beside rules that know no series.
//!
//! Coefficients are those of `series_closed_in_space.csv`, whose head says how they were found.

use super::by_series::{
    apart, are_coefficients_of, beside_dop853, beside_dop853_with_forces, closed_beside_dop853, expansion, goes_on,
    move_alike,
};
use catena::Error;
use catena::spatial::*;

const G: [f64; 3] = [0.0, 0.0, -9.81];

/// A rod of one kilogram a metre.
fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, 0.05, length)
}

fn body() -> RigidBody<f64> {
    let tensor = [[0.05, 0.01, 0.0], [0.01, 0.04, 0.0], [0.0, 0.0, 0.06]];
    RigidBody::new(0.8, tensor, [0.2, 0.1, 0.05], [0.4, -0.1, 0.02])
}

fn hinge() -> Revolute<f64, Spring<f64, f64, f64>> {
    Revolute::about([0.3, 1.0, 0.2]).with(Spring::new(3.0).damped(0.1).resting_at(0.2))
}

/// Two rods and a body on balls, between two of them.
macro_rules! bridge {
    () => {
        System::new(Pinned::origin(), (rod(1.0), Ball, rod(0.7), Ball, body()), Pinned::at([1.5, 0.2, 0.1]))?
            .with_gravity(G)
    };
}
const OF_BRIDGE: [f64; 9] = [0.1, 0.9, 0.2, 0.3, -0.1, 0.1, 0.2, -0.8, 0.4];

/// A loop that a ball closes, a rod before it and one behind.
macro_rules! ring {
    () => {{
        let net = Network::new((Ball, rod(0.6), Ball, rod(0.5)), (Ball, rod(0.45), hinge(), body()), Ball);
        System::new(Pinned::origin(), (rod(0.8), net, Ball, rod(0.5)), Free)?.with_gravity(G)
    }};
}
const OF_RING: [f64; 16] = [0.1, 0.9, 0.2, 0.3, -0.1, 0.1, 0.2, 0.8, 0.4, 0.3, 0.2, 0.1, 0.4, 0.2, 0.3, 0.5];

/// Two rods, a body on a ball and one on a hinge, to a tip that is held.
macro_rules! held {
    ($tip:expr) => {{
        let chain = (rod(1.0), Ball, body(), hinge(), rod(0.6), Ball, rod(0.7));
        System::new(Pinned::origin(), chain, $tip)?.with_gravity(G)
    }};
}
const OF_HELD: [f64; 10] = [0.1, 0.9, 0.2, 0.3, -0.1, 0.1, 0.2, -0.8, 0.4, 0.3];

const RATES: [f64; 16] = [0.5, -0.4, 0.9, -0.3, 0.6, 0.7, -0.8, 0.4, 0.1, -0.5, 0.3, 0.2, -0.6, 0.8, -0.1, 0.4];

#[test]
fn coefficients_are_those_of_equations_with_multipliers() -> Result<(), Error> {
    /// Ends need not be where they are held: coefficients are those of what closures demand of accelerations.
    macro_rules! expand {
        ($name:literal, $scene:expr, $angles:expr) => {{
            let scene = $scene;
            let start = scene.with_rates(scene.at_rest(&$angles)?, &RATES[..scene.motion().rates().len()])?;
            let (found, _) = expansion!(20, scene, start, Unloaded, 1e-6);
            are_coefficients_of(include_str!("series_closed_in_space.csv"), $name, &found, 1e-12);
        }};
    }
    expand!("bridge", bridge!(), OF_BRIDGE);
    expand!("hinged", held!(Hinged::at([1.2, 0.2, 0.1], [0.2, 1.0, 0.0])), OF_HELD);
    expand!("clamped", held!(Clamped::at([1.2, 0.2, 0.1], Rotation::from_angles([0.1, 0.2, 0.3]))), OF_HELD);
    expand!("ring", ring!(), OF_RING);
    Ok(())
}

#[test]
fn closed_scenes_move_as_under_dop853() -> Result<(), Error> {
    macro_rules! compare {
        ($name:literal, $scene:expr, $angles:expr, $loads:expr) => {{
            let scene = $scene;
            closed_beside_dop853!($name, scene, $loads, scene.at_rest(&$angles)?, 0.5, norm);
        }};
    }
    compare!("bridge", bridge!(), OF_BRIDGE, Unloaded);
    let efforts =
        Loads::none().efforts([Effort([0.3, 0.1, 0.2]), Effort([-0.1, 0.2, 0.0]), Effort([0.1, 0.05, -0.03])]);
    compare!("bridge under efforts", bridge!(), OF_BRIDGE, efforts);
    let knee = Revolute::about([0.1, 0.2, 1.0]);
    let chain = (body(), hinge(), rod(0.6), Ball, rod(0.7), Ball, PointMass::new(0.3, 0.2), knee, body(), Ball, body());
    let clamp = Clamped::at([1.2, 0.2, 0.1], Rotation::from_angles([0.1, 0.2, 0.3]));
    let clamped = System::new(Hinged::origin([0.0, 1.0, 0.0]), chain, clamp)?.with_gravity(G);
    compare!("clamped", clamped, [0.1, 0.4, 0.2, 0.3, -0.1, 0.1, 0.2, -0.8, 0.4, 0.3, 0.2, 0.1], Unloaded);
    compare!("hinged", held!(Hinged::at([1.2, 0.2, 0.1], [0.2, 1.0, 0.0])), OF_HELD, Unloaded);
    compare!("ring", ring!(), OF_RING, Unloaded);
    let side = (Ball, rod(0.45), hinge(), body(), Ball, rod(0.3));
    let weld = Weld::at(Rotation::from_angles([0.1, 0.2, 0.3]));
    let net = Network::new((Ball, rod(0.6), Ball, rod(0.5)), side, weld);
    let frame = System::new(Pinned::origin(), (rod(0.8), net, Ball, rod(0.5)), Pinned::at([1.4, 0.2, -0.5]))?;
    let angles = [0.1, 0.9, 0.2, 0.3, -0.1, 0.1, 0.2, 0.8, 0.4, 0.3, 0.2, 0.1, 0.4, 0.2, 0.3, 0.5, 0.1, 0.2, 0.3];
    compare!("frame", frame.with_gravity(G), angles, Unloaded);
    Ok(())
}

#[test]
fn readings_within_a_step_are_closed() -> Result<(), Error> {
    let scene = bridge!();
    let start = scene.assembled(scene.at_rest(&OF_BRIDGE)?, &Unloaded)?;
    let ((mut most, mut sampled), mut drift) = ((0.0_f64, 0), 0.0_f64);
    let energy = scene.budget(&start)?.energy();
    let run = scene.simulation(Taylor::<24>::tolerance(1e-13)).every(0.01).run(start, 1.0, |now| {
        sampled += 1;
        drift = drift.max((now.energy() - energy).abs());
        let tip = scene.stations(now.motion(), &Unloaded).map(|stations| stations.tip().frame.place);
        most = tip.map_or(f64::NAN, |tip| apart(tip.as_slice(), &[1.5, 0.2, 0.1])).max(most);
    })?;
    println!("{} steps, {sampled} samples, missed by {most:.1e}, energy by {drift:.1e}", run.steps);
    assert!(sampled > 90 && most < 1e-14 && drift < 1e-11 && run.sweeps > run.steps);
    Ok(())
}

#[test]
fn a_run_goes_on_as_if_it_had_not_stopped() -> Result<(), Error> {
    let scene = ring!();
    let start = scene.assembled(scene.at_rest(&OF_RING)?, &Unloaded)?;
    goes_on!(16, scene, start, coordinates, rates, accelerations);
    Ok(())
}
