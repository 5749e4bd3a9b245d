//! Andrews' squeezing mechanism against its reference.

#[path = "../../../examples/common/squeezer.rs"]
mod squeezer;

use catena::Error;
use catena::planar::*;
use squeezer::{CLOSING, END, FIRST, REFERENCE, START, absolute, relative, squeezer, wrench};

type Motion = catena::system::MotionOf<Planar<f64>, Clamped<[f64; 2], f64>, squeezer::Arms, Free>;

fn angles(scene: &squeezer::Squeezer, motion: &Motion) -> [f64; 7] {
    let all = scene.angles(motion).unwrap();
    relative(squeezer::BODIES.map(|k| all.get(k).copied().unwrap_or(f64::NAN)))
}

/// The largest relative error of the seven angles.
fn error(scene: &squeezer::Squeezer, motion: &Motion) -> f64 {
    let of = |(found, expected): (f64, f64)| ((found - expected) / expected).abs();
    angles(scene, motion).into_iter().zip(REFERENCE).map(of).fold(0.0, f64::max)
}

/// By how much the arms miss the point where they meet (m).
fn miss(scene: &squeezer::Squeezer, motion: &Motion) -> f64 {
    let stations = scene.stations(motion, &catena::loading::Unloaded).unwrap();
    let end = stations.tip().frame.place;
    CLOSING.iter().filter_map(|k| stations.get(*k)).fold(0.0, |worst, side| (side.frame.place - end).norm().max(worst))
}

#[test]
fn starts_as_the_test_set_says() -> Result<(), Error> {
    let scene = squeezer()?;
    let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
    let start = scene.assembled(scene.at_rest(&absolute(START))?, &loads)?;
    assert!(miss(&scene, &start) < 1e-16);
    let bodies = scene.body_motions(&start)?;
    let turn = |k| bodies.get(k).map_or(f64::NAN, |body| body.inboard.acceleration.angular);
    let found = [turn(0), turn(1) - turn(0)];
    println!("{found:?}");
    for (found, expected) in found.into_iter().zip(FIRST) {
        assert!((found - expected).abs() < 1e-11 * expected.abs(), "{found:.10} instead of {expected}"); // all its digits
    }
    Ok(())
}

#[test]
fn ends_where_the_reference_ends() -> Result<(), Error> {
    let scene = squeezer()?;
    let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
    let start = scene.assembled(scene.at_rest(&absolute(START))?, &loads)?;
    let mut worst = 0.0_f64;
    let mut last = f64::NAN;
    for tolerance in [1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
        let rule = Dop853::tolerance(tolerance);
        let run = scene.simulation(rule).loads(&loads).run(start, END, |now| {
            worst = worst.max(miss(&scene, now.motion()));
        })?;
        let error = error(&scene, &run.motion);
        println!("{tolerance:.0e}: {} steps, error {error:.1e}", run.steps);
        last = error;
    }
    println!("arms miss by {worst:.1e} m");
    assert!(last < 1e-10 && worst < 1e-15, "{last:.1e}, {worst:.1e} m");
    Ok(())
}

/// First steps that are far too long are taken back: from coarse tolerances on, errors fall with them.
#[test]
fn coarse_tolerances_do_not_break_it() -> Result<(), Error> {
    let scene = squeezer()?;
    let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
    let start = scene.assembled(scene.at_rest(&absolute(START))?, &loads)?;
    for (tolerance, most) in [(0.3, 1.0), (0.1, 1.0), (1e-2, 1e-2), (1e-3, 1e-2), (1e-4, 1e-2)] {
        let run = scene.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(start, END, |_| ())?;
        let error = error(&scene, &run.motion);
        println!("{tolerance:.0e}: {} steps, {} rejected, error {error:.1e}", run.steps, run.rejected);
        assert!(error < most);
    }
    Ok(())
}

/// The spring's work and that of the drive make the kinetic energy.
#[test]
fn balances_its_energy() -> Result<(), Error> {
    let scene = squeezer()?;
    let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
    let start = scene.assembled(scene.at_rest(&absolute(START))?, &loads)?;
    let budget = |motion: &Motion| {
        let bodies = scene.body_motions(motion).unwrap();
        let hook = bodies.get(3).map(|body| body.point(squeezer::HOOK).place - nalgebra::Vector2::from(squeezer::C));
        let stretch = hook.map_or(f64::NAN, |reach| reach.norm() - 0.07785);
        scene.budget(motion).unwrap().kinetic + 0.5 * 4530.0 * stretch * stretch - 0.033 * angles(&scene, motion)[0]
    };
    let first = budget(&start);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    scene.simulation(Dop853::tolerance(1e-12)).loads(&loads).run(start, END, |now| {
        worst = worst.max((budget(now.motion()) - first).abs());
        most = most.max(now.budget().kinetic);
    })?;
    println!("energy kept within {worst:.1e} J of {most:.2} J");
    assert!(worst < 1e-10 * most);
    Ok(())
}
