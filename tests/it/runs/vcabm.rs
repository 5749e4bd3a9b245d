//! The predictor and corrector of variable order: orders, references, sweeps for an error, restarts, samples and events.

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Stepper;
use catena_oracle::{has_order, near};
use core::f64::consts::FRAC_PI_3;
use num_dual::Dual64;

type Rods<T> = System<T, Pinned<[T; 2]>, (Rod<T>, Pin, Rod<T>), Free>;
type State = catena::system::MotionOf<Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

/// The double pendulum of `runs/double_pendulum.rs` at two seconds: an integration of order 8, a Taylor series of 30 digits.
const ANGLES: [f64; 2] = [-1.3564198519106136, -1.1306522396578225];

fn rods() -> Result<Rods<f64>, Error> {
    let rod = Rod::uniform(1.0, 1.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

fn error(scene: &Rods<f64>, motion: &State) -> f64 {
    let found = scene.angles(motion).unwrap();
    found.iter().zip(ANGLES).fold(0.0, |worst: f64, (found, angle)| worst.max((found - angle).abs()))
}

/// Of a corrector that has one order more than its predictor.
#[test]
fn steps_of_one_size_have_the_order_asked_for() -> Result<(), Error> {
    let scene = rods()?;
    for (order, numbers) in
        [(1, [1000, 2000, 4000]), (3, [1000, 1400, 2000]), (5, [400, 500, 640]), (7, [160, 220, 300])]
    {
        let mut points = vec![];
        for n in numbers {
            let rule = Vcabm::new().up_to(order).step(2.0 / f64::from(n));
            let run = scene.simulate(scene.at_rest(&[-FRAC_PI_3; 2])?, rule, 2.0, |_| ())?;
            assert_eq!(run.sweeps, (order - 1) * 12 + (n as usize - (order - 1)) * 2);
            points.push((f64::from(n).recip(), error(&scene, &run.motion)));
        }
        has_order(&format!("order {order}"), (order + 1) as f64, 2e-14, &points);
    }
    Ok(())
}

#[test]
fn runs_meet_references() -> Result<(), Error> {
    let (share, small) = (Rod::uniform(0.5, 0.5), Rod::uniform(0.05, 0.05));
    // Of an integration at 30 digits (`runs/references.rs`).
    let two = System::new(Pinned::origin(), (share, Pin, share), Free)?.with_gravity(9.81);
    let run = two.simulate(two.at_rest(&[0.0; 2])?, Vcabm::new().tolerance(1e-14), 2.0, |_| ())?;
    println!("two rods: error {:.1e}, {} sweeps", run.motion.position().1.1 + 0.9071302549910606, run.sweeps);
    near(run.motion.position().1.1, -0.9071302549910606, 1e-11);
    let twenty = System::new(Clamped::at(0.0, 0.0, 0.0), [(Pin, small); 20], Free)?.with_gravity(9.81);
    let run = twenty.simulate(twenty.at_rest(&[0.0; 20])?, Vcabm::new().tolerance(1e-13), 0.5, |_| ())?;
    let last = twenty.angles(&run.motion)?.iter().last().copied().unwrap_or(f64::NAN);
    println!("twenty rods: error {:.1e}, {} sweeps", last + 3.0330002988365, run.sweeps);
    near(last, -3.0330002988365, 1e-10);
    Ok(())
}

/// Sweeps that an error of 1e-9 takes: between two runs, as their logarithms go.
fn sweeps_to(errors: impl Fn(f64) -> (f64, usize)) -> f64 {
    let mut before: Option<(f64, usize)> = None;
    for k in 15..22 {
        let (error, sweeps) = errors(10_f64.powf(-0.5 * f64::from(k)));
        if error <= 1e-9 {
            let Some((larger, fewer)) = before else { return sweeps as f64 };
            let share = (larger / 1e-9).ln() / (larger / error).ln();
            return (fewer as f64) * (sweeps as f64 / fewer as f64).powf(share);
        }
        before = Some((error, sweeps));
    }
    f64::NAN
}

/// Sweeps of runs by both rules under loads, for an error of the last angle.
macro_rules! share_of_sweeps {
    ($name:literal, $scene:expr, $start:expr, $loads:expr, $end:expr) => {{
        let (scene, start, loads) = (&$scene, &$start, &$loads);
        macro_rules! last {
            ($rule:expr) => {{
                let run = scene.simulation($rule).loads(loads).run(start.clone(), $end, |_| ())?;
                (run.motion.coordinates().last().copied().unwrap_or(f64::NAN), run.sweeps)
            }};
        }
        let (exact, _) = last!(Dop853::tolerance(1e-13));
        let runs = |rule: usize| -> Result<f64, Error> {
            let mut found = vec![];
            for k in 15..22 {
                let tolerance = 10_f64.powf(-0.5 * f64::from(k));
                let (last, sweeps) = if rule == 0 {
                    last!(Dop853::tolerance(tolerance))
                } else {
                    last!(Vcabm::new().tolerance(tolerance))
                };
                found.push((tolerance, (last - exact).abs(), sweeps));
            }
            Ok(sweeps_to(|tolerance| {
                found.iter().find(|(of, ..)| *of == tolerance).map_or((0.0, 0), |(_, error, sweeps)| (*error, *sweeps))
            }))
        };
        let (other, own) = (runs(0)?, runs(1)?);
        println!("{}: {own:.0} sweeps, DOP853 {other:.0}: {:.2}", $name, own / other);
        assert!(own < 0.6 * other);
    }};
}

#[test]
fn errors_of_1e_9_take_six_tenths_of_the_sweeps_of_dop853_at_most() -> Result<(), Error> {
    let (share, small) = (Rod::uniform(0.5, 0.5), Rod::uniform(0.05, 0.05));
    let two = System::new(Pinned::origin(), (share, Pin, share), Free)?.with_gravity(9.81);
    share_of_sweeps!("two rods", two, two.at_rest(&[0.0; 2])?, Unloaded, 2.0);
    let swung = Loads::none().in_joints(|time: f64, joint, motion: &JointMotion<f64>| {
        let motor = if joint == 1 { 0.5 * (3.0 * time).sin() } else { 0.0 };
        motor - 0.05 * motion.rate()
    });
    share_of_sweeps!("two rods under loads", two, two.at_rest(&[-0.3, 0.2])?, swung, 2.0);
    let twenty = System::new(Clamped::at(0.0, 0.0, 0.0), [(Pin, small); 20], Free)?.with_gravity(9.81);
    share_of_sweeps!("twenty rods", twenty, twenty.at_rest(&[0.0; 20])?, Unloaded, 0.5);
    let rod = |length: f64| Rod::uniform(length, length);
    let held = System::new(Pinned::origin(), (rod(0.5), Pin, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0_f64, 0.0))?
        .with_gravity(9.81);
    let start = held.assembled(held.at_rest(&[1.0, 0.3, -1.9])?, &Unloaded)?;
    share_of_sweeps!("held tip", held, start, Unloaded, 2.0);
    let net =
        Network::new((Pin, rod(0.5), Pin, rod(1.2)), (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9)), LeastNorm(Pin));
    let closed = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(9.81);
    let start = closed.assembled(closed.at_rest(&[1.0, 0.3, 1.1])?, &Unloaded)?;
    share_of_sweeps!("loop", closed, start, Unloaded, 2.0);
    Ok(())
}

#[test]
fn errors_follow_tolerances_and_few_steps_are_rejected() -> Result<(), Error> {
    let scene = rods()?;
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let run = scene.simulate(scene.at_rest(&[-FRAC_PI_3; 2])?, Vcabm::new().tolerance(tolerance), 2.0, |_| ())?;
        let found = error(&scene, &run.motion);
        println!(
            "{tolerance:.0e}: {found:.1e} rad, {} steps, {} rejected, {} sweeps",
            run.steps, run.rejected, run.sweeps
        );
        assert!(found < 100.0 * tolerance && 4 * run.rejected < run.steps);
        assert_eq!(run.sweeps, run.steps + run.rejected); // one a step
    }
    Ok(())
}

/// Between steps about as good as at their ends, and events are found there. Readings are those of the motion shown.
#[test]
fn samples_events_and_readings_are_as_good_as_steps() -> Result<(), Error> {
    let scene = rods()?;
    let start = scene.at_rest(&[-FRAC_PI_3; 2])?;
    let mut exact = vec![];
    macro_rules! see {
        ($now:ident) => {
            [$now.motion().position().1.1, $now.motion().rate().0, $now.stations().root().internal.force.y]
        };
    }
    let rule = Dop853::tolerance(1e-13);
    scene
        .simulation(rule)
        .every(0.137)
        .event(|now| now.motion().rate().1.1)
        .run(start, 1.0, |now| exact.push((now.is_event(), now.time(), see!(now))))?;
    for tolerance in [1e-6, 1e-10] {
        let (mut seen, mut worst) = (0, 0.0_f64);
        let run = scene.simulation(Vcabm::new().tolerance(tolerance)).every(0.137).event(|now| now.motion().rate().1.1);
        run.run(start, 1.0, |now| {
            let (event, time, numbers) = exact[seen];
            assert_eq!(now.is_event(), event);
            worst = numbers
                .iter()
                .zip(see!(now))
                .fold(worst.max((time - now.time()).abs()), |worst, (a, b)| worst.max((a - b).abs()));
            seen += 1;
        })?;
        println!("{tolerance:.0e}: {worst:.1e} in {seen} instants");
        assert!(seen == exact.len() && worst < 300.0 * tolerance);
    }
    Ok(())
}

/// Backwards, and not at all.
#[test]
fn steps_may_turn_round() -> Result<(), Error> {
    let scene = rods()?;
    let (mut stepper, mut past) = (scene.stepper(Vcabm::new().up_to(6)), scene.at_rest(&[-FRAC_PI_3; 2])?);
    let (start, mut next) = (past, past);
    for size in [[0.01; 12], [0.0; 12], [-0.01; 12]].concat() {
        stepper.step(&past, &Unloaded, size, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let off = (past.position().0 - start.position().0).abs().max((past.position().1.1 - start.position().1.1).abs());
    println!("there and back: {off:.1e} rad");
    assert!(off < 1e-9);
    Ok(())
}

/// Derivatives of one step from a motion in mid-run: what is remembered has other derivative parts, and is forgotten.
#[test]
fn derivative_parts_may_be_set_anew() -> Result<(), Error> {
    let rod = Rod::uniform(Dual64::from(1.0), Dual64::from(1.0));
    let scene: Rods<Dual64> = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Dual64::from(9.81));
    let mut past = scene.at_rest(&[Dual64::from(-1.0); 2])?;
    let (mut own, mut other, mut next) = (scene.stepper(Vcabm::new().up_to(4)), scene.stepper(Dop853), past);
    for _ in 0..10 {
        own.step(&past, &Unloaded, 0.02, &mut next)?;
        core::mem::swap(&mut past, &mut next);
    }
    let mut expected = past;
    past.position_mut().0 = past.position().0.derivative();
    own.step(&past, &Unloaded, 0.02, &mut next)?;
    other.step(&past, &Unloaded, 0.02, &mut expected)?;
    let [found, expected] = [next, expected].map(|motion| [motion.rate().0.eps, motion.rate().1.1.eps]);
    assert_eq!(found, expected);
    Ok(())
}

/// A step that is taken back does not stand in the way of the one made instead.
#[test]
fn a_step_may_be_repeated() -> Result<(), Error> {
    let scene = rods()?;
    let mut steppers = [scene.stepper(Vcabm::new().up_to(6)), scene.stepper(Vcabm::new().up_to(6))];
    let mut ends = [scene.at_rest(&[-FRAC_PI_3; 2])?; 2];
    for (repeats, (stepper, end)) in steppers.iter_mut().zip(&mut ends).enumerate() {
        for _ in 0..40 {
            let past = *end;
            for size in [0.02, 0.005, 0.01].iter().skip(if repeats == 0 { 2 } else { 0 }) {
                stepper.step(&past, &Unloaded, *size, end)?;
            }
        }
    }
    assert_eq!(ends[0], ends[1]);
    Ok(())
}

/// A motor that is switched between steps, and within steps of a run: whose error control finds it.
#[test]
fn torques_may_jump() -> Result<(), Error> {
    let scene = rods()?;
    let start = scene.at_rest(&[-FRAC_PI_3; 2])?;
    let jumps = Loads::none().in_joints(|time: f64, k, _: &JointMotion<f64>| match k {
        1 if time < 0.5 => 3.0,
        1 => -5.0,
        _ => 0.0,
    });
    let half = |start: State, end: f64| {
        let run = scene.simulation(Dop853::tolerance(1e-13)).loads(&jumps).run(start, end, |_| ());
        run.map(|run| run.motion).map_err(Error::from)
    };
    let exact = half(half(start, 0.5)?, 1.0)?;
    for tolerance in [1e-5, 1e-8] {
        let run = scene.simulation(Vcabm::new().tolerance(tolerance)).loads(&jumps).run(start, 1.0, |_| ())?;
        let other = scene.simulation(Dop853::tolerance(tolerance)).loads(&jumps).run(start, 1.0, |_| ())?;
        let off = (run.motion.position().1.1 - exact.position().1.1).abs();
        println!(
            "{tolerance:.0e}: {off:.1e} rad, {} sweeps, {} rejected; DOP853 {}",
            run.sweeps, run.rejected, other.sweeps
        );
        assert!(off < 100.0 * tolerance && run.sweeps < 3 * other.sweeps / 2);
    }
    Ok(())
}

/// A step that is made anew after it was accepted, as where a joint comes to rest within it, has the order of that, whatever trials failed before.
#[test]
fn a_step_made_anew_keeps_its_order() -> Result<(), Error> {
    type Scene = Rods<f64>;
    let (scene, tolerance) = (rods()?, 1e-9);
    let mut now = scene.with_accelerations(scene.at_rest(&[-FRAC_PI_3; 2])?, &Unloaded)?;
    let (mut stepper, mut next, mut size) = (scene.stepper(Vcabm::new()), now, 1e-5);
    // Eighty accepted steps, and two trials that fail before one more.
    let mut failures = 0;
    for step in 0.. {
        let proposed = Stepper::<&Scene, _>::propose(&mut stepper, &now, &Unloaded, tolerance);
        size = if failures > 0 || step == 0 { size } else { proposed.unwrap_or(size) };
        let tried = if step >= 80 && failures < 2 { 3.0 * size } else { size };
        Stepper::<&Scene, _>::advance(&mut stepper, &now, &Unloaded, tried, &mut next)?;
        let error = Stepper::<&Scene, _>::error(&mut stepper, &now, tried, &next, tolerance).unwrap_or(f64::NAN);
        if error > 1.0 {
            failures += 1;
            size *= 0.9;
        } else if step >= 80 {
            assert_eq!(failures, 2);
            break;
        } else {
            failures = 0;
            core::mem::swap(&mut now, &mut next);
        }
    }
    let memory = Stepper::<&Scene, Unloaded>::memory(&stepper);
    for share in [0.9, 0.5, 0.7] {
        Stepper::<&Scene, Unloaded>::restore(&mut stepper, &memory);
        Stepper::<&Scene, _>::advance(&mut stepper, &now, &Unloaded, share * size, &mut next)?;
        let exact = scene.simulate(now, Dop853::tolerance(1e-14), now.time() + share * size, |_| ())?.motion;
        println!("{share} of {size:.1e} s: error {:.1e}", next.rate().1.1 - exact.rate().1.1);
        near(next.rate().1.1, exact.rate().1.1, tolerance);
    }
    Ok(())
}
