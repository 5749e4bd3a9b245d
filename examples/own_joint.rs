//! A joint of one's own: an arm with geared motors, in the plane and in space, whose rotors have more inertia than its links.
//!
//! ```text
//! cargo run --release --example own_joint
//! ```

#[path = "elements/geared.rs"]
mod geared;

use catena::extend::check_element;
use catena::{planar, spatial};
use geared::Geared;
use std::error::Error;

/// A rotor of 2e-4 kg·m² that turns 60 times as fast as the joint has 0.72 kg·m² there.
fn motor<K>(kinematics: K) -> Geared<f64, K> {
    Geared { kinematics, rotor: 2e-4, ratio: 60.0, friction: 0.0 }
}

fn main() -> Result<(), Box<dyn Error>> {
    let (plane, space) = (in_the_plane()?, in_space()?);
    for (name, drift, with, without) in [("plane", plane.0, plane.1, plane.2), ("space", space.0, space.1, space.2)] {
        println!("{name}: energy drifts by {drift:.1e} J in 10 s");
        println!("{name}: natural frequencies (rad/s) {with:.6?}, without rotors {without:.6?}");
        assert!(drift < 1e-11 && with[1] < without[1]);
    }
    Ok(())
}

/// How far energy drifts (J), and frequencies with rotors and without.
type Found = (f64, Vec<f64>, Vec<f64>);

fn in_the_plane() -> Result<Found, Box<dyn Error>> {
    use planar::*;
    let (rod, hinge) = (Rod::uniform(1.0, 1.0), motor(Revolute::smooth()));
    let arm = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod, hinge, rod), Free)?.with_gravity(9.81);
    check_element(&arm, 10)?;
    let start = arm.at_rest(&[-0.4, 0.9])?;
    let (energy, mut drift) = (arm.budget(&start)?.energy(), 0.0_f64);
    arm.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| drift = drift.max((now.energy() - energy).abs()))?;
    let bare = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let down = -std::f64::consts::FRAC_PI_2;
    let modes = arm.modes(&arm.at_rest(&[down; 2])?, &Unloaded)?;
    let others = bare.modes(&bare.at_rest(&[down; 2])?, &Unloaded)?;
    Ok((drift, modes.frequencies().collect(), others.frequencies().collect()))
}

fn in_space() -> Result<Found, Box<dyn Error>> {
    use spatial::*;
    let (rod, axis) = (Rod::uniform(1.0, 0.02, 1.0), Revolute::about([0.0, 0.6, 0.8]));
    let (smooth, hinge) = (axis, motor(axis));
    let arm = System::new(Clamped::origin(), (hinge, rod, hinge, rod), Free)?.with_gravity([9.81, 0.0, 0.0]);
    check_element(&arm, 10)?;
    let start = arm.at_rest(&[-0.4, 0.9])?;
    let (energy, mut drift) = (arm.budget(&start)?.energy(), 0.0_f64);
    arm.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| drift = drift.max((now.energy() - energy).abs()))?;
    let bare = System::new(Clamped::origin(), (smooth, rod, smooth, rod), Free)?.with_gravity([9.81, 0.0, 0.0]);
    let modes = arm.modes(&arm.at_rest(&[0.0; 2])?, &Unloaded)?;
    let others = bare.modes(&bare.at_rest(&[0.0; 2])?, &Unloaded)?;
    Ok((drift, modes.frequencies().collect(), others.frequencies().collect()))
}
