//! Chains of rods on pins, released from the horizontal (error of the last angle; of a hundred rods, whose end falls freely, of the first
//! one), and on balls, the first rod turning at 1 and 2 rad/s
//! about its own x and y (error of the height of the tip).
//!
//! References: of 2 and 20 rods on pins Taylor series of 30 digits, of 3 on balls DOP853 and another library; of the others two rules of
//! this one, whose difference is printed.

use catena::planar::{Free, Pin, Pinned, Rod, System, Unloaded};
use catena::{Real, Scalar, spatial};
use catena_precision::{Scene, is_wanted, reference, run_rules};
use std::error::Error;

/// Rods on pins, over a number.
macro_rules! pins {
    ($T:ident, $n:literal) => {{
        let share = (1.0 / $n as f64) as $T;
        let rod = Rod::uniform(share, share);
        let system = System::new(Pinned::origin(), (rod, [(Pin, rod); $n - 1]), Free)?.with_gravity(9.81 as $T);
        let start = system.at_rest(&[0.0; $n])?;
        (system, start)
    }};
}

macro_rules! run_pins {
    ($scene:ident, $T:ident, $n:literal, $rod:literal, $unit:expr, $finest:expr) => {{
        let (system, start) = pins!($T, $n);
        run_rules!(
            $scene,
            $T,
            $unit,
            $finest,
            (system, start, Unloaded),
            |system, motion| { system.angles(motion).ok()?.get($rod).map(|angle| angle.as_f64()) },
            taylor
        );
    }};
}

/// Rods on balls, over a number.
macro_rules! balls {
    ($T:ident, $n:literal) => {{
        use spatial::{Ball, Free, Pinned, Rod, System};
        let share = (1.0 / $n as f64) as $T;
        let rod = Rod::uniform(share, share / 10.0, share);
        let system = System::new(Pinned::origin(), (rod, [(Ball, rod); $n - 1]), Free)?;
        let system = system.with_gravity([0.0, -9.81 as $T, 0.0]);
        let mut rates = [0.0; 3 * $n];
        (rates[0], rates[1]) = (1.0, 2.0);
        let start = system.with_rates(system.at_rest(&[0.0; 3 * $n])?, &rates)?;
        (system, start)
    }};
}

macro_rules! run_balls {
    ($scene:ident, $T:ident, $n:literal, $unit:expr, $finest:expr) => {{
        let (system, start) = balls!($T, $n);
        run_rules!(
            $scene,
            $T,
            $unit,
            $finest,
            (system, start, Unloaded),
            |system, motion| {
                system.body_motions(motion).ok()?.iter().last().map(|body| body.outboard().place.y.real().as_f64())
            },
            taylor
        );
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    if is_wanted("2 rods on pins") {
        let mut scene = Scene::new("2 rods on pins", 2, 2.0, -0.9071302549910606, "rad");
        run_pins!(scene, f64, 2, 1, 0.02, 1e-13);
        run_pins!(scene, f32, 2, 1, 0.02, 1e-7);
        scene.finish()?;
    }
    if is_wanted("20 rods on pins") {
        let mut scene = Scene::new("20 rods on pins", 20, 0.5, -3.0330002988365, "rad");
        run_pins!(scene, f64, 20, 19, 0.002, 1e-13);
        run_pins!(scene, f32, 20, 19, 0.002, 1e-7);
        scene.finish()?;
    }
    if is_wanted("100 rods on pins") {
        let (system, start) = pins!(f64, 100);
        let reference = reference!("100 rods on pins", 0.2, (system, start, Unloaded), |system, motion| {
            system.angles(motion).ok()?.get(0).copied()
        });
        let mut scene = Scene::new("100 rods on pins", 100, 0.2, reference, "rad");
        run_pins!(scene, f64, 100, 0, 0.001, 1e-13);
        run_pins!(scene, f32, 100, 0, 0.001, 1e-7);
        scene.finish()?;
    }
    if is_wanted("3 rods on balls") {
        let mut scene = Scene::new("3 rods on balls", 3, 2.0, -0.28230043053974, "m");
        run_balls!(scene, f64, 3, 0.02, 1e-13);
        run_balls!(scene, f32, 3, 0.02, 1e-7);
        scene.finish()?;
    }
    if is_wanted("20 rods on balls") {
        let (system, start) = balls!(f64, 20);
        let reference = reference!("20 rods on balls", 0.5, (system, start, Unloaded), |system, motion| {
            system.body_motions(motion).ok()?.iter().last().map(|body| body.outboard().place.y)
        });
        let mut scene = Scene::new("20 rods on balls", 20, 0.5, reference, "m");
        run_balls!(scene, f64, 20, 0.002, 1e-13);
        run_balls!(scene, f32, 20, 0.002, 1e-7);
        scene.finish()?;
    }
    Ok(())
}
