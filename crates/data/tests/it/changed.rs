//! Runs that go on under other loads, in another scene, with other rates, tolerances, samples or events; and methods under a control that is
//! not theirs.

use crate::record::{bits, same};
use catena::loading::TimeLaw;
use catena::planar::*;
use catena::scalar::Scalar;
use catena::simulate::Stepper;
use catena::time::{Control, Rule};
use catena::{Error, Fault};
use std::cell::Cell;

type Rods = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

fn rods(gravity: f64) -> Result<Rods, Error> {
    let rod = Rod::uniform(1.0, 2.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(gravity))
}

#[test]
fn a_method_without_an_estimate_takes_no_tolerance() -> Result<(), Error> {
    let scene = rods(9.81)?;
    let start = scene.at_rest(&[-1.0, -0.5])?;
    let rule = Rule { method: Rk4, control: Control::Tolerance(1e-9) };
    let refused = scene.simulation(rule).run(start, 1.5, |_| ()).unwrap_err();
    assert!(matches!(refused.error.fault, Fault::Unsupported { .. }), "{}", refused.error);
    assert_eq!(refused.last.time(), 0.0);
    let refused = scene.backward(Rk4).run_adaptive(&start, 1e-9, 1.5, &[], &mut [start; 40]).unwrap_err();
    assert!(matches!(refused.fault, Fault::Unsupported { .. }), "{refused}");
    assert!(scene.backward(Dopri5).run_adaptive(&start, 1e-6, 0.5, &[], &mut [start; 40])? > 3);
    Ok(())
}

/// How far two motions are apart.
fn apart(a: &impl serde::Serialize, b: &impl serde::Serialize) -> f64 {
    let numbers = |motion: &dyn Fn() -> String| -> Vec<f64> {
        motion().split(['[', ']', ',', ':', '{', '}']).filter_map(|text| text.parse().ok()).collect()
    };
    let (a, b) = (numbers(&|| serde_json::to_string(a).unwrap()), numbers(&|| serde_json::to_string(b).unwrap()));
    assert!(a.len() == b.len() && a.len() >= 4);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// A run saved under a torque, which goes on without, under other gravity, after an impact, against runs that begin where it was saved.
macro_rules! changed {
    ($rule:expr, $most:expr) => {{
        let (scene, other) = (rods(9.81)?, rods(3.7)?);
        let loads = Loads::none().torques([0.0, 5.0]);
        let mut run = scene.simulation($rule).loads(&loads).begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
        run.until(0.25)?;
        let (saved, end) = (run.save(), run.motion().time() + 0.04);
        let mut struck = saved.clone();
        struck.motion.set_rates(&[-1.0, 2.0])?;
        for (change, scene, saved) in
            [("load", &scene, &saved), ("gravity", &other, &saved), ("impact", &scene, &struck)]
        {
            let found = scene.simulation($rule).resume(saved.clone(), end, |_| ())?.finish()?.motion;
            let expected = scene.simulation($rule).run(saved.motion, end, |_| ())?.motion;
            let apart = apart(&(found.position(), found.rate()), &(expected.position(), expected.rate()));
            println!("{:?}, {change}: {apart:e}", $rule.method);
            assert!(apart <= $most, "{:?}, {change}: {apart:e}", $rule.method);
        }
    }};
}

#[test]
fn what_has_changed_is_known_from_the_first_step_on() -> Result<(), Error> {
    changed!(Rk4::step(0.01), 1e-12);
    changed!(Adams::step(0.01), 1e-12);
    changed!(Vcabm::new().step(0.01), 1e-12);
    changed!(Taylor::<12>::step(0.01), 1e-12);
    changed!(Sdirk4::new().step(0.01), 1e-12);
    changed!(GeneralizedAlpha::new(0.8).step(0.01), 1e-4);
    changed!(Dop853::tolerance(1e-8), 1e-7);
    changed!(Vcabm::new().tolerance(1e-8), 1e-6);
    changed!(Auto::tolerance(1e-8), 1e-6);
    Ok(())
}

struct Ramp(f64);

impl TimeLaw<f64> for Ramp {
    fn at<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
        X::literal(self.0) * (time - X::literal(0.01)) + X::literal(joint as f64)
    }
}

#[test]
fn a_series_is_that_of_the_law_handed_in() -> Result<(), Error> {
    let scene = rods(9.81)?;
    let of = |slope| Loads::none().in_joints_over_time(Ramp(slope));
    let start = scene.with_accelerations(scene.at_rest(&[-1.0, -0.5])?, &of(1.0))?;
    let (mut stepper, mut now, mut next) = (scene.stepper(Taylor::<12>), start, start);
    stepper.step(&start, &of(1.0), 0.01, &mut now)?;
    // The same torque and so the same accelerations, but another law from here on.
    stepper.advance(&now, &of(50.0), 0.01, &mut next)?;
    let (mut other, mut expected) = (scene.stepper(Taylor::<12>), start);
    other.advance(&now, &of(50.0), 0.01, &mut expected)?;
    same("series", &next, &expected);
    // A step made once more, under another law again.
    stepper.advance(&now, &of(1.0), 0.01, &mut next)?;
    scene.stepper(Taylor::<12>).advance(&now, &of(1.0), 0.01, &mut expected)?;
    same("series", &next, &expected);
    Ok(())
}

#[test]
fn samples_lie_within_their_steps_in_single_precision() -> Result<(), Error> {
    let rod = Rod::uniform(1.0_f32, 2.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81_f32);
    let start = scene.at_rest(&[-1.0, -0.5])?;
    let mut run = scene.simulation(Rk4::step(0.025)).every(0.1).begin(start, 20.0, |_| ())?;
    run.until(10.0)?;
    let (saved, mut times) = (run.save(), vec![]);
    scene.simulation(Rk4::step(0.025)).every(0.095).resume(saved, 11.0, |now| times.push(now.time()))?.finish()?;
    println!("{times:?}");
    assert!(times.iter().all(|time| *time >= 10.0) && times.len() == 10 + usize::from(times[0] < 10.05));
    // Late, times are rounded by parts of a step.
    for (step, every) in [(1e-3, 1e-3), (1e-3, 0.6e-3), (0.7e-3, 1e-3)] {
        let simulation = || scene.simulation(Rk4::step(step)).every(every);
        let (mut whole, mut parts) = (vec![], vec![]);
        simulation().run(start.at_time(2200.0), 2200.02, |now| whole.push(now.time()))?;
        assert!(whole.windows(2).all(|pair| pair[0] < pair[1]), "{whole:?}");
        assert_eq!(whole.len(), (0.02 / every + 1.01) as usize, "{whole:?}");
        let mut run = simulation().begin(start.at_time(2200.0), 2200.02, |now| parts.push(now.time()))?;
        run.until(2200.011)?;
        let saved = run.save();
        simulation().resume(saved, 2200.02, |now| parts.push(now.time()))?.finish()?;
        assert_eq!(parts, whole);
    }
    // Nor are last steps longer than the rule says.
    let run = scene.simulation(Rk4::step(0.1)).run(start, 0.211, |_| ())?;
    assert_eq!(run.steps, 3);
    let run = scene.simulation(Rk4::step(0.1)).run(start, 2.0, |_| ())?;
    assert_eq!(run.steps, 20);
    Ok(())
}

/// The size of the first step (s) after a thousand of another size.
fn first_step<T: Scalar<Real = T> + catena::Real>(start: f64, step: f64, other: f64) -> Result<f64, Error> {
    let scene = System::new(Pinned::origin(), Rod::uniform(T::one(), T::one()), Free)?.with_gravity(T::of(9.81));
    let (start, simulation) = (T::of(start), |step| scene.simulation(Rk4::step(T::of(step))));
    let mut run = simulation(step).begin(scene.at_rest(&[T::zero()])?.at_time(start), start + T::of(2.0), |_| ())?;
    for _ in 0..1003 {
        run.step()?;
    }
    let mut run = simulation(other).resume(run.save(), start + T::of(2.0), |_| ())?;
    let before = run.motion().time();
    run.step()?;
    Ok((run.motion().time() - before).as_f64())
}

#[test]
fn steps_of_another_size_are_of_that_size_from_the_first_on() -> Result<(), Error> {
    let (rounding, rounding_32) = (2.4e-7, 1.3e-4); // of times (s)
    for other in [0.998e-3, 1.1e-3, 0.5e-3] {
        let found = first_step::<f32>(1997.0, 1e-3, other)?;
        assert!((found - other).abs() <= rounding_32, "{found:e} instead of {other:e}");
    }
    for other in [1.0004e-5, 1.1e-5] {
        let found = first_step::<f64>(1.7e9, 1e-5, other)?;
        assert!((found - other).abs() <= rounding, "{found:e} instead of {other:e}");
    }
    Ok(())
}

#[test]
fn events_are_seen_in_the_first_step_after_another() -> Result<(), Error> {
    let scene = rods(9.81)?;
    let start = scene.at_rest(&[-1.0, -0.5])?;
    let rule = Rk4::step(0.1);
    let upright =
        |place: f64| move |now: &catena::simulate::Now<'_, _, _, _, _, Unloaded>| now.motion().position().0 + place;
    let mut run = scene.simulation(rule).event(upright(1.1)).stopping().begin(start, 2.0, |_| ())?;
    while run.step()? {}
    let saved = run.save();
    // Another event soon after, within the first step.
    let mut found = vec![];
    let simulation = scene.simulation(rule).event(upright(1.15));
    simulation
        .resume(saved.clone(), 0.9, |now| {
            if now.is_event() {
                found.push(*now.motion())
            }
        })?
        .finish()?;
    let first = found.first().expect("an event");
    println!("{} then {}", saved.motion.time(), first.time());
    assert!(first.time() > saved.motion.time() && first.time() < saved.motion.time() + 0.1);
    assert!((first.position().0 + 1.15).abs() < 1e-12);
    // The same one, to which the rod comes back within a step after a weak blow, and not after a strong one.
    for (rate, expected) in [(0.05, 1), (3.0, 0)] {
        let (mut struck, mut times) = (saved.clone(), vec![]);
        struck.motion.set_rates(&[rate, 0.0])?;
        let simulation = scene.simulation(rule).event(upright(1.1));
        let see = |now: &catena::simulate::Now<'_, _, _, _, _, _>| {
            if now.is_event() {
                times.push(now.time())
            }
        };
        simulation.resume(struck, saved.motion.time() + 0.1, see)?.finish()?;
        assert_eq!(times.len(), expected, "{times:?}");
    }
    Ok(())
}

#[test]
fn another_tolerance_is_one_of_trials_too() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 2.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.2, 0.0, core::f64::consts::PI - 1.2])?;
    let mut coarse = scene.simulation(Dopri5::tolerance(1e-6)).begin(start, 1.0, |_| ())?;
    coarse.until(0.1)?;
    let trials = |saved: &dyn Fn() -> String| {
        let text = saved();
        let from = text.find("\"allowed\"").unwrap();
        text[from..from + text[from..].find("\"longest\"").unwrap()].to_owned()
    };
    let changed = scene.simulation(Dopri5::tolerance(1e-9)).resume(coarse.save(), 1.0, |_| ())?;
    let begun = scene.simulation(Dopri5::tolerance(1e-9)).begin(start, 1.0, |_| ())?;
    let of = |text: String| trials(&move || text.clone());
    let [changed, begun] =
        [serde_json::to_string(&changed.save()), serde_json::to_string(&begun.save())].map(|x| of(x.unwrap()));
    assert!(changed == begun && changed != of(serde_json::to_string(&coarse.save()).unwrap()), "{changed}");
    let fixed = scene.simulation(Dopri5::step(0.01)).resume(coarse.save(), 1.0, |_| ())?;
    assert!(of(serde_json::to_string(&fixed.save()).unwrap()).starts_with("\"allowed\":null"));
    Ok(())
}

#[test]
fn a_run_goes_on_once_what_kept_it_is_gone() -> Result<(), Error> {
    let (scene, broken) = (rods(9.81)?, Cell::new(false));
    let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| if broken.get() { f64::NAN } else { 0.0 });
    macro_rules! goes_on {
        ($($rule:expr),*) => {$(
            let mut run = scene.simulation($rule).loads(&loads).begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
            run.until(0.3)?;
            broken.set(true);
            for _ in 0..2 {
                let error = run.step().unwrap_err();
                assert!(matches!(error.fault, Fault::StepTooSmall { .. }), "{error}");
            }
            let saved = run.save();
            broken.set(false);
            let end = run.finish()?;
            assert!(end.motion.time() == 1.0 && end.steps < 100, "{}", end.steps);
            let resumed = scene.simulation($rule).loads(&loads).resume(saved, 1.0, |_| ())?.finish()?;
            assert!(bits(&resumed.motion) == bits(&end.motion) || apart(&resumed.motion, &end.motion) < 1e-5);
        )*};
    }
    goes_on!(Dopri5::tolerance(1e-8), Dop853::tolerance(1e-8), Vcabm::new().tolerance(1e-8));
    Ok(())
}

#[test]
fn an_end_before_the_start_is_out_of_range() -> Result<(), Error> {
    let scene = rods(9.81)?;
    let start = scene.at_rest(&[-1.0, -0.5])?.at_time(2.0);
    let refused = scene.simulation(Rk4::step(0.01)).begin(start, 1.0, |_| ()).err().unwrap().error;
    assert!(matches!(refused.fault, Fault::OutOfRange { least: 2.0, value: 1.0, .. }), "{refused}");
    assert_eq!(
        refused.to_string(),
        "end of the run must be finite and at least 2, but is 1: it lies before where the run begins, or goes on"
    );
    Ok(())
}
