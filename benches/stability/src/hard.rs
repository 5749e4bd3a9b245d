//! Passages that are hard: attitudes that are singular in angles, closures that depend on each other, loads that jump, high rates.

use crate::table::Table;
use catena::paper;
use catena::{planar, spatial};

fn say(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// The largest difference of two lists, where the first is finite; relative where numbers exceed one.
fn apart(found: &[f64], exact: &[f64]) -> Result<f64, String> {
    let size = exact.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    let worst = found.iter().zip(exact).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs())) / size;
    match found.iter().all(|x| x.is_finite()) && found.len() == exact.len() {
        true => Ok(worst),
        false => Err("not finite, and no error returned".to_owned()),
    }
}

/// Three rods on balls that fall in the plane x, z, so that the second of the angles 1-2-3 passes 90°: against rods on pins.
fn attitudes(table: &mut Table) {
    let exact = || -> Result<Vec<f64>, String> {
        use planar::*;
        let rod = Rod::uniform(0.3, 0.3);
        let scene = System::new(Pinned::origin(), (rod, [(Pin, rod); 2]), Free).map_err(say)?.with_gravity(9.81);
        let start = scene.at_rest(&[0.4; 3]).map_err(say)?;
        let run = scene.simulate(start, Dop853::tolerance(1e-13), 2.0, |_| ()).map_err(|stopped| say(stopped.error))?;
        let bodies = scene.body_motions(&run.motion).map_err(say)?;
        Ok(bodies.iter().flat_map(|body| [body.outboard().place.x, body.outboard().place.y]).collect())
    };
    use spatial::*;
    let rod = Rod::new(0.3, 0.3, 0.15, 1e-4, 0.3 * 0.09 / 12.0);
    let scene = || -> Result<_, String> {
        let scene = System::new(Pinned::origin(), (rod, [(Ball, rod); 2]), Free).map_err(say)?;
        let scene = scene.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.at_rest(&[0.0, -0.4, 0.0, 0.0, -0.4, 0.0, 0.0, -0.4, 0.0]).map_err(say)?;
        Ok((scene, start))
    };
    macro_rules! rule {
        ($name:literal, $rule:expr) => {{
            let found = scene().and_then(|(scene, start)| {
                let run = scene.simulate(start, $rule, 2.0, |_| ()).map_err(|stopped| say(stopped.error))?;
                let bodies = scene.body_motions(&run.motion).map_err(say)?;
                let places = bodies.iter().map(|body| body.outboard().place);
                Ok(places.flat_map(|place| [place.x, place.z]).collect::<Vec<f64>>())
            });
            let outcome = found.and_then(|found| apart(&found, &exact()?));
            table.add("hard", "3 rods on balls through 90°", "angle (°)", 90.0, $name, "f64", outcome);
        }};
    }
    rule!("DOP853, 1e-12", Dop853::tolerance(1e-12));
    rule!("Vcabm, 1e-12", Vcabm::default().tolerance(1e-12));
    rule!("RK4 of 1 ms", Rk4::step(1e-3));
    rule!("generalised-alpha of 1 ms", GeneralizedAlpha::new(0.8).step(1e-3));
    for (name, slots) in
        [("2005, angles 1-2-3", paper::Slots::Angles), ("2005, rotations", paper::Slots::RotationVectors)]
    {
        let found = scene().and_then(|(scene, start)| {
            let scheme = paper::Scheme::new(paper::GeneralizedAlpha::new(0.8)).linearized(paper::At::Predictor);
            let scheme = scheme.solved_by(paper::Solver::Riccati).turning_by(slots);
            let mut run = scheme.start(&scene, &start, &Unloaded, 1e-3).map_err(say)?;
            run.run_to(2.0).map_err(say)?;
            let places: Vec<f64> = run.stations().iter().skip(2).step_by(2).flat_map(|z| [z[0], z[2]]).collect();
            Ok(places)
        });
        let outcome = found.and_then(|found| apart(&found, &exact()?));
        table.add("hard", "3 rods on balls through 90°", "angle (°)", 90.0, name, "f64", outcome);
    }
}

/// A parallelogram that passes the places where it is flat, some twenty times: its energy, and its closure.
fn flat_parallelogram(table: &mut Table, quick: bool) {
    use planar::*;
    let rod = |length| Rod::uniform(length, length);
    let end = if quick { 2.0 } else { 20.0 };
    let scene = || -> Result<_, String> {
        let chain = (rod(0.5), Pin, rod(1.0), Pin, rod(0.5));
        let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0)).map_err(say)?.with_gravity(1.0);
        let angles = [1.0, 0.0, 1.0 + std::f64::consts::PI];
        let start = scene.with_rates(scene.at_rest(&angles).map_err(say)?, &[6.0, 0.0, 6.0]).map_err(say)?;
        let start = scene.assembled(start, &Unloaded).map_err(say)?;
        Ok((scene, start))
    };
    macro_rules! rule {
        ($name:literal, $rule:expr) => {
            rule!($name, $rule, |run| run)
        };
        ($name:literal, $rule:expr, |$run:ident| $sampled:expr) => {{
            let mut passed = 0.0;
            let outcome = scene().and_then(|(scene, start)| {
                let before = scene.budget(&start).map_err(say)?;
                let mut worst = 0.0_f64;
                let $run = scene.simulation($rule);
                let run = $sampled.run(start, end, |now| {
                    passed = now.time();
                    let tip = now.stations().tip().frame.place;
                    let drift = (now.energy() - before.energy()).abs() / before.kinetic;
                    // fold by hand: `max` forgets what is no number
                    for off in [drift, (tip.x - 1.0).hypot(tip.y)] {
                        worst = if off.is_nan() || off > worst { off } else { worst };
                    }
                });
                run.map_err(|stopped| say(stopped.error))?;
                if worst.is_nan() { Err("not finite, and no error returned".to_owned()) } else { Ok(worst) }
            });
            let stopped = outcome.is_err();
            let kept = outcome.as_ref().err().cloned().unwrap_or_default();
            table.add("hard", "parallelogram through flat", "time (s)", end, $name, "f64", outcome);
            if stopped {
                table.note(format!("at {passed:.2} s: {kept}"));
            }
        }};
    }
    rule!("DOP853, 1e-8", Dop853::tolerance(1e-8));
    rule!("DOP853, 1e-12", Dop853::tolerance(1e-12));
    rule!("DOPRI5, 1e-8", Dopri5::tolerance(1e-8));
    rule!("Vcabm, 1e-8", Vcabm::default().tolerance(1e-8));
    rule!("Adams, 1e-8", Adams::tolerance(1e-8));
    rule!("RK4 of 1 ms", Rk4::step(1e-3));
    rule!("DOP853 of 5 ms", Dop853::step(5e-3));
    rule!("generalised-alpha of 1 ms", GeneralizedAlpha::new(0.8).step(1e-3));
    rule!("SDIRK4 of 1 ms", Sdirk4::new().step(1e-3));
    rule!("DOP853, 1e-12, samples", Dop853::tolerance(1e-12), |run| run.every(0.01));
    rule!("DOPRI5, 1e-8, samples", Dopri5::tolerance(1e-8), |run| run.every(0.01));
    rule!("Vcabm, 1e-8, samples", Vcabm::default().tolerance(1e-8), |run| run.every(0.01));
}

/// A torque that jumps at a third of a second and back at two thirds: against a run that is cut there.
fn jumps(table: &mut Table) {
    use planar::*;
    let rod = Rod::uniform(0.5, 0.5);
    let instants = [1.0 / 3.0, 2.0 / 3.0, 1.0];
    let torque = |size: f64| [size, -0.3 * size];
    let scene =
        || System::new(Pinned::origin(), (rod, Pin, rod), Free).map(|scene| scene.with_gravity(9.81)).map_err(say);
    for size in [1.0, 1e2, 1e4] {
        let exact = scene().and_then(|scene| {
            let mut now = scene.at_rest(&[-1.0, -0.5]).map_err(say)?;
            for (instant, on) in instants.into_iter().zip([0.0, size, 0.0]) {
                let loads = Loads::none().torques(torque(on));
                now = scene.with_accelerations(now, &loads).map_err(say)?;
                let run = scene.simulation(Dop853::tolerance(1e-13)).loads(&loads).run(now, instant, |_| ());
                now = run.map_err(|stopped| say(stopped.error))?.motion;
            }
            Ok(now.coordinates())
        });
        macro_rules! rule {
            ($name:literal, $rule:expr) => {{
                let found = scene().and_then(|scene| {
                    let jumping = move |time: f64, joint: usize, _: &JointMotion<f64>| {
                        let on = if (instants[0]..instants[1]).contains(&time) { size } else { 0.0 };
                        torque(on).get(joint).copied().unwrap_or(0.0)
                    };
                    let loads = Loads::none().in_joints(jumping);
                    let start = scene.at_rest(&[-1.0, -0.5]).map_err(say)?;
                    let run = scene.simulation($rule).loads(&loads).run(start, 1.0, |_| ());
                    Ok(run.map_err(|stopped| say(stopped.error))?.motion.coordinates())
                });
                let outcome = found.and_then(|found| apart(&found, exact.as_ref().map_err(Clone::clone)?));
                table.add("hard", "torque that jumps", "torque (N·m)", size, $name, "f64", outcome);
            }};
        }
        rule!("DOP853, 1e-10", Dop853::tolerance(1e-10));
        rule!("DOPRI5, 1e-10", Dopri5::tolerance(1e-10));
        rule!("Vcabm, 1e-10", Vcabm::default().tolerance(1e-10));
        rule!("Adams, 1e-10", Adams::tolerance(1e-10));
        rule!("RK4 of 1 ms", Rk4::step(1e-3));
        rule!("DOP853 of 1 ms", Dop853::step(1e-3));
        rule!("generalised-alpha, 1e-10", GeneralizedAlpha::new(0.8).tolerance(1e-10));
        rule!("SDIRK4, 1e-10", Sdirk4::new().tolerance(1e-10));
    }
}

/// Rods that turn at `rate` for as long as ten at 1 rad/s would: the same motion with gravity scaled by the square of the rate.
fn rates(table: &mut Table) {
    let turned = |rate: f64, gravity: f64| -> Result<Vec<f64>, String> {
        use planar::*;
        let rod = Rod::uniform(0.5, 0.5);
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).map_err(say)?.with_gravity(gravity);
        let start = scene.with_rates(scene.at_rest(&[0.3, -0.2]).map_err(say)?, &[rate, 0.5 * rate]).map_err(say)?;
        let run = scene.simulate(start, Dop853::tolerance(1e-12), 10.0 / rate, |_| ()).map_err(say)?;
        Ok(run.motion.coordinates())
    };
    let spun = |rate: f64, gravity: f64| -> Result<Vec<f64>, String> {
        use spatial::*;
        let rod = Rod::uniform(0.5, 0.05, 0.5);
        let scene =
            System::new(Pinned::origin(), (rod, Ball, rod), Free).map_err(say)?.with_gravity([0.0, 0.0, -gravity]);
        let start = scene.at_rest(&[0.0, 0.3, 0.1, 0.0, -0.2, 0.0]).map_err(say)?;
        let rates = [1.0, 0.5, 0.3, 0.2, -0.4, 0.6].map(|share| rate * share);
        let start = scene.with_rates(start, &rates).map_err(say)?;
        let run = scene.simulate(start, Dop853::tolerance(1e-12), 10.0 / rate, |_| ()).map_err(say)?;
        Ok(run.motion.coordinates())
    };
    for rate in [1.0, 1e2, 1e4, 1e6] {
        let same = 1.0 / (rate * rate) * 9.81;
        let outcome = turned(1.0, same).and_then(|exact| apart(&turned(rate, 9.81)?, &exact));
        table.add("hard", "2 rods on pins, 10 rad", "rate (rad/s)", rate, "DOP853, 1e-12", "f64", outcome);
        let outcome = spun(1.0, same).and_then(|exact| apart(&spun(rate, 9.81)?, &exact));
        table.add("hard", "2 rods on balls, 10 rad", "rate (rad/s)", rate, "DOP853, 1e-12", "f64", outcome);
    }
}

pub fn run(table: &mut Table, quick: bool) {
    attitudes(table);
    flat_parallelogram(table, quick);
    jumps(table);
    rates(table);
}
