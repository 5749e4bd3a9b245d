//! A joint of one's own with two coordinates: a pendulum in space on a gimbal, whose motors have rotors behind different gears.
//!
//! ```text
//! cargo run --release --example own_gimbal
//! ```

mod common;
#[path = "elements/geared.rs"]
mod geared;
#[path = "elements/gimbal.rs"]
mod gimbal;

use catena::extend::check_element;
use catena::spatial::*;
use common::{BLUE, Drawn, GREY, line};
use geared::Geared;
use gimbal::Gimbal;
use std::error::Error;
use std::path::PathBuf;

/// How long the pendulum swings (s), its angles at the start (rad), inertia of its rotors (kg·m²) and their gears.
const END: f64 = 10.0;
const START: [f64; 2] = [0.3, 0.2];
const ROTOR: f64 = 1e-4;
const GEARS: [f64; 2] = [20.0, 60.0];
/// Axes of the gimbal. The rod hangs along x.
const AXES: [[f64; 3]; 2] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Where the tip goes, across and across (m).
type Path = Vec<(f64, f64)>;

/// A pendulum: angular frequencies (rad/s), by how much energy drifts (J), the tip's path.
struct Found {
    frequencies: Vec<f64>,
    drift: f64,
    path: Path,
}

/// Runs the same story for each joint.
macro_rules! swing {
    ($joint:expr) => {{
        let rod = Rod::uniform(1.0, 0.02, 1.0);
        let scene = System::new(Clamped::origin(), ($joint, rod), Free)?.with_gravity([9.81, 0.0, 0.0]);
        check_element(&scene, 10)?;
        let frequencies = scene.modes(&scene.motion(), &Unloaded)?.frequencies().collect();
        let start = scene.at_rest(&START)?;
        let (energy, mut drift, mut path) = (scene.budget(&start)?.energy(), 0.0_f64, vec![]);
        scene.simulation(Dop853::tolerance(1e-13)).every(0.01).run(start.clone(), END, |now| {
            let tip = now.stations().tip().frame.place;
            path.push((tip.y, tip.z));
        })?;
        // At the ends of steps energy is kept better than at samples between them.
        scene.simulate(start, Dop853::tolerance(1e-13), END, |now| drift = drift.max((now.energy() - energy).abs()))?;
        Found { frequencies, drift, path }
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    let [first, second] = [0, 1].map(|k| {
        let kinematics = Revolute::about(AXES[k]);
        Geared { kinematics, rotor: ROTOR, ratio: GEARS[k], friction: 0.0 }
    });
    let (geared, bare) = (swing!(Gimbal::of(first, second)), swing!(Universal::about(AXES[0], AXES[1])));

    let [one, two] = GEARS;
    println!("A rod of 1 m and 1 kg hangs on a gimbal with motors of gears {one} : 1 and {two} : 1\n");
    let heads = [("joint", 9), ("ω₁ (rad/s)", 10), ("ω₂ (rad/s)", 10), ("energy drifts by (J)", 20)];
    common::heads(&heads);
    for (name, Found { frequencies, drift, .. }) in [("gimbal", &geared), ("universal", &bare)] {
        let [one, two] = [0, 1].map(|k| frequencies.get(k).copied().unwrap_or(f64::NAN));
        println!("  {name:9}  {one:10.6}  {two:10.6}  {drift:20.1e}");
        assert!(*drift < 1e-11);
    }

    // By hand, where it hangs: ω² = m g ℓ/2 / (m ℓ²/3 + m r²/4 + n² J), about each axis.
    let mut by_hand = GEARS.map(|gear| (9.81 / 2.0 / (1.0 / 3.0 + 0.02 * 0.02 / 4.0 + gear * gear * ROTOR)).sqrt());
    by_hand.sort_by(f64::total_cmp);
    println!("  {:9}  {:10.6}  {:10.6}", "by hand", by_hand[0], by_hand[1]);
    for (found, expected) in geared.frequencies.iter().zip(by_hand) {
        assert!((found - expected).abs() < 1e-10 * expected);
    }
    println!("\nPicture: {}", draw(&geared.path, &bare.path)?.display());
    Ok(())
}

/// The path of the tip, from below.
fn draw(geared: &Path, bare: &Path) -> Drawn<PathBuf> {
    common::picture("own_gimbal", (620, 560), |area| {
        let subtitle = "Rotors make one axis slower than the other; without them it swings nearly in a plane.";
        let area = common::heading(area, "A pendulum on a gimbal", subtitle)?;
        let points = || geared.iter().chain(bare);
        let across = common::range(points().map(|point| point.0), 0.08);
        let along = common::range(points().map(|point| point.1), 0.08);
        let mut chart = common::chart(&area, "Path of the tip, z (m)", "y (m)", across, along)?;
        common::legend(&area, &[("with motors", BLUE), ("universal joint", GREY)])?;
        common::curve(&mut chart, bare.iter().copied(), line(GREY, 1.4))?;
        common::curve(&mut chart, geared.iter().copied(), line(BLUE, 1.6))
    })
}
