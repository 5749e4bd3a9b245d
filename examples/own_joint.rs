//! A joint of one's own: an arm with geared motors, in the plane and in space, whose rotors have more inertia than its links.
//!
//! ```text
//! cargo run --release --example own_joint
//! ```

mod common;
#[path = "elements/geared.rs"]
mod geared;

use catena::extend::check_element;
use catena::{planar, spatial};
use common::{BLUE, Drawn, GREY, line};
use geared::Geared;
use std::error::Error;
use std::path::PathBuf;

/// How long arms fall (s), and angles of their links at the start (rad).
const END: f64 = 10.0;
const START: [f64; 2] = [-0.4, 0.9];

/// A rotor of 2e-4 kg·m² that turns 60 times as fast as the joint has 0.72 kg·m² there.
fn motor<K>(kinematics: K) -> Geared<f64, K> {
    Geared { kinematics, rotor: 2e-4, ratio: 60.0, friction: 0.0 }
}

/// What is found of an arm: how far energy drifts (J), frequencies (rad/s) with rotors and without.
struct Found {
    drift: f64,
    with: Vec<f64>,
    without: Vec<f64>,
}

/// Times (s) and angles of the upper link (rad).
type Way = Vec<(f64, f64)>;

fn main() -> Result<(), Box<dyn Error>> {
    let (plane, ways) = in_the_plane()?;
    println!(
        "An arm of two rods, 1 m and 1 kg each, on motors with gears of 60 : 1; it falls and swings for {END} s\n"
    );
    let heads = [("arm", 8), ("energy drifts by (J)", 20), ("ω₁ (rad/s)", 10), ("ω₂ (rad/s)", 10)];
    common::heads(&[&heads[..], &[("ω₁ without rotors", 17), ("ω₂ without rotors", 17)]].concat());
    for (name, Found { drift, with, without }) in [("in plane", plane), ("in space", in_space()?)] {
        let [[a, b], [c, d]] = [&with, &without].map(|list| [list[0], list[1]]);
        println!("  {name}  {drift:20.1e}  {a:10.6}  {b:10.6}  {c:17.6}  {d:17.6}");
        assert!(drift < 1e-11 && with[1] < without[1]);
    }
    println!("\nPicture: {}", draw(&ways)?.display());
    Ok(())
}

fn in_the_plane() -> Result<(Found, [Way; 2]), Box<dyn Error>> {
    use planar::*;
    let (rod, hinge) = (Rod::uniform(1.0, 1.0), motor(Revolute::smooth()));
    let arm = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod, hinge, rod), Free)?.with_gravity(9.81);
    check_element(&arm, 10)?;
    let start = arm.at_rest(&START)?;
    let (energy, mut drift) = (arm.budget(&start)?.energy(), 0.0_f64);
    let (mut geared, mut free) = (vec![], vec![]);
    arm.simulation(Dop853::tolerance(1e-13)).every(0.02).run(start, END, |now| {
        drift = drift.max((now.energy() - energy).abs());
        geared.push((now.time(), now.angles().get(0).copied().unwrap_or(f64::NAN)));
    })?;
    let bare = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    bare.simulation(Dop853::tolerance(1e-13)).every(0.02).run(bare.at_rest(&START)?, END, |now| {
        free.push((now.time(), now.angles().get(0).copied().unwrap_or(f64::NAN)));
    })?;
    let down = -std::f64::consts::FRAC_PI_2;
    let with = arm.modes(&arm.at_rest(&[down; 2])?, &Unloaded)?.frequencies().collect();
    let without = bare.modes(&bare.at_rest(&[down; 2])?, &Unloaded)?.frequencies().collect();
    Ok((Found { drift, with, without }, [geared, free]))
}

fn in_space() -> Result<Found, Box<dyn Error>> {
    use spatial::*;
    let (rod, axis) = (Rod::uniform(1.0, 0.02, 1.0), Revolute::about([0.0, 0.6, 0.8]));
    let (smooth, hinge) = (axis, motor(axis));
    let arm = System::new(Clamped::origin(), (hinge, rod, hinge, rod), Free)?.with_gravity([9.81, 0.0, 0.0]);
    check_element(&arm, 10)?;
    let start = arm.at_rest(&START)?;
    let (energy, mut drift) = (arm.budget(&start)?.energy(), 0.0_f64);
    arm.simulate(start, Dop853::tolerance(1e-13), END, |now| drift = drift.max((now.energy() - energy).abs()))?;
    let bare = System::new(Clamped::origin(), (smooth, rod, smooth, rod), Free)?.with_gravity([9.81, 0.0, 0.0]);
    let with = arm.modes(&arm.at_rest(&[0.0; 2])?, &Unloaded)?.frequencies().collect();
    let without = bare.modes(&bare.at_rest(&[0.0; 2])?, &Unloaded)?.frequencies().collect();
    Ok(Found { drift, with, without })
}

/// The upper link with motors and without.
fn draw([geared, free]: &[Way; 2]) -> Drawn<PathBuf> {
    common::picture("own_joint", (860, 420), |area| {
        let subtitle =
            "Two rods of 1 m and 1 kg fall and swing; rotors behind gears of 60 : 1 make it slow, and smooth.";
        let area = common::heading(area, "An arm with geared motors", subtitle)?;
        let range = common::range(geared.iter().chain(free).map(|point| point.1), 0.08);
        let mut chart = common::chart(&area, "Angle of the upper rod (rad)", "time (s)", 0.0..END, range)?;
        common::legend(&area, &[("with motors", BLUE), ("on pins", GREY)])?;
        common::curve(&mut chart, free.iter().copied(), line(GREY, 1.4))?;
        common::curve(&mut chart, geared.iter().copied(), line(BLUE, 1.8))
    })
}
