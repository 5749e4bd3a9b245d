//! What was silent garbage, or a run without an end, is refused by name.

use catena::simulate::{Interrupted, Now};
use catena::{Error, Fault, Scalar, planar, spatial};
use core::fmt::Debug;

/// Why a run was refused at its start.
fn fault<R, M>(run: Result<R, Interrupted<M>>) -> Option<Fault> {
    run.err().map(|interrupted| interrupted.error.fault)
}

#[test]
fn motions_of_another_length_are_refused() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let chain = |links: usize| System::new(Pinned::origin(), (rod, vec![(Pin, rod); links]), Free);
    for (here, there) in [(2, 3), (3, 2)] {
        let (here, there) = (chain(here)?.with_gravity(9.81), chain(there)?.with_gravity(9.81));
        let motion = there.with_accelerations(there.motion(), &Unloaded)?;
        let shape = Error::new(Fault::Shape);
        assert_eq!((there.fits(&motion), here.fits(&motion)), (Ok(()), Err(shape)));
        let rates = vec![1.0; here.joints()];
        assert_eq!(here.with_rates(motion.clone(), &rates).err(), Some(shape));
        assert_eq!(here.with_body_rates(motion.clone(), &rates).err(), Some(shape));
        assert_eq!(here.with_joint_rates(motion.clone(), &rates).err(), Some(shape));
        assert_eq!(here.transfer_matrix(&motion, &Unloaded, |_, _| ()).err(), Some(shape));
        assert_eq!(here.root_state(&motion, &Unloaded).err(), Some(shape));

        assert_eq!(here.angles(&motion).err(), Some(shape));
        assert_eq!(here.body_motions(&motion).err(), Some(shape));
        assert_eq!(here.stations(&motion, &Unloaded).err(), Some(shape));
        assert_eq!(here.budget(&motion).err(), Some(shape));
        // And its own motion reads as before.
        assert!(
            there.angles(&motion)?.iter().all(|angle| angle.is_finite()) && there.budget(&motion)?.energy().is_finite()
        );
    }
    Ok(())
}

#[test]
fn struts_to_bodies_that_do_not_exist_are_refused() -> Result<(), Error> {
    {
        use planar::*;
        let rod = Rod::uniform(1.0, 1.0);
        let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
        let start = scene.at_rest(&[0.0, 0.3])?;
        for (strut, body) in [
            (Strut::to_ground((2, [0.0; 2]), [1.0, 1.0]), 2),
            (Strut::between((0, [0.5, 0.0]), (7, [0.0; 2])), 7),
            (Strut::between((usize::MAX, [0.5, 0.0]), (1, [0.0; 2])), usize::MAX),
        ] {
            let refused = Fault::NoSuchBody { body, bodies: 2 };
            let good = Strut::to_ground((1, [1.0, 0.0]), [1.0, 1.0]).with_stiffness(1.0);
            let loads = Struts::of([good, strut.with_stiffness(1.0)]);
            assert_eq!(scene.with_accelerations(start, &loads).err(), Some(Error::new(refused)));
            assert_eq!(scene.assembled(start, &loads).err(), Some(Error::new(refused)));
            for rule in [Rk4::step(0.01), Rk4::step(0.1)] {
                assert_eq!(fault(scene.simulation(rule).loads(&loads).run(start, 1.0, |_| ())), Some(refused));
            }
            let mut next = start;
            assert_eq!(scene.stepper(Rk4).step(&start, &loads, 0.1, &mut next), Err(Error::new(refused)));
            assert_eq!(scene.stepper(Adams).advance(&start, &loads, 0.1, &mut next), Err(Error::new(refused)));
            assert_eq!(scene.stepper(Sdirk4::new()).step(&start, &loads, 0.1, &mut next), Err(Error::new(refused)));
            let mut alpha = scene.stepper(GeneralizedAlpha::new(0.8));
            assert_eq!(alpha.step(&start, &loads, 0.1, &mut next), Err(Error::new(refused)));
            assert_eq!(alpha.advance(&start, &loads, 0.1, &mut next), Err(Error::new(refused)));
        }
        let text = Error::new(Fault::NoSuchBody { body: 2, bodies: 2 }).to_string();
        assert_eq!(text, "there is no body 2: the scene has 2, from 0 on");
    }
    use spatial::*;
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Ball, rod), Free)?;
    let loads = Struts::of([Strut::to_ground((2, [0.0; 3]), [1.0; 3]).with_stiffness(1.0)]);
    let refused = Fault::NoSuchBody { body: 2, bodies: 2 };
    assert_eq!(scene.with_accelerations(scene.motion(), &loads).err(), Some(Error::new(refused)));
    Ok(())
}

/// An event function that is not a number at the start, at the end of a step, and inside of one only.
#[test]
fn event_functions_that_are_not_numbers_are_refused() -> Result<(), Error> {
    use planar::*;
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.0])?;
    let refused = Fault::NotFinite { parameter: "value of the event function" };
    for (from, to) in [(0.0, 1.0), (0.35, 1.0), (0.41, 0.49)] {
        let event = |now: &Now<'_, _, _, _, _, _>| {
            if (from..=to).contains(&now.time()) { f64::NAN } else { 0.45 - now.time() }
        };
        let run = scene.simulation(Rk4::step(0.1)).event(event).run(start, 1.0, |_| ());
        let Interrupted { error, last } = run.map(|run| run.steps).unwrap_err();
        assert_eq!(error.fault, refused);
        assert!(error.time.is_some_and(|time| (from..=to).contains(&time) && last.time() <= time), "{error}");
        assert!(last.is_finite());
    }
    // A run that cannot start gives the start back.
    let begun = scene.simulation(Rk4::step(0.1)).event(|_| f64::NAN).begin(start, 1.0, |_| panic!("a run began"));
    assert_eq!(begun.err().map(|refused| refused.last), Some(start));
    // Infinite values have signs.
    let mut found = 0.0_f64;
    let event = |now: &Now<'_, _, _, _, _, _>| if now.time() < 0.45 { f64::INFINITY } else { -1.0 };
    scene.simulation(Rk4::step(0.1)).event(event).run(start, 1.0, |now| {
        if now.is_event() {
            found = now.time();
        }
    })?;
    assert!((found - 0.45).abs() < 1e-12);
    Ok(())
}

/// The times of all events of a function of time, in a second of steps of 0.1 s.
fn events(function: fn(f64) -> f64) -> Result<Vec<f64>, Error> {
    use planar::*;
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let mut found = vec![];
    let event = move |now: &Now<'_, _, _, _, _, _>| function(now.time());
    scene.simulation(Rk4::step(0.1)).event(event).run(scene.at_rest(&[0.0])?, 1.0, |now| {
        if now.is_event() {
            found.push(now.time());
        }
    })?;
    Ok(found)
}

#[test]
fn zeros_at_the_ends_of_steps_hide_no_others() -> Result<(), Error> {
    let near = |found: Vec<f64>, expected: &[f64]| {
        let same = found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12);
        assert!(found.len() == expected.len() && same, "{found:?}, not {expected:?}");
    };
    near(events(|t| (t - 0.5) * (t - 0.55))?, &[0.5, 0.55]);
    near(events(|t| t * (t - 0.05))?, &[0.05]);
    // One that stays at zero, one that only touches it, one that leaves it slowly.
    near(events(|t| (0.2 - t).max(0.0))?, &[0.2]);
    near(events(|t| (t - 0.5).powi(2))?, &[0.5]);
    near(events(|t| (1.0 + t.powi(4)) - 1.0)?, &[]);
    Ok(())
}

#[test]
fn signs_of_tiny_and_of_infinite_values_are_read() -> Result<(), Error> {
    assert_eq!(events(|t| 1e-170 * (1.0 + t))?, []);
    assert!((events(|t| 1e-170 * (0.45 - t))?[0] - 0.45).abs() < 1e-12);
    assert!((0.45..=0.5).contains(&events(|t| if t < 0.45 { f64::INFINITY } else { 0.0 })?[0]));
    Ok(())
}

/// A pendulum of numbers of a type, run by `Dop853` with a tolerance.
fn with_tolerance<T: Scalar<Real = T> + catena::Real + Debug>(tolerance: T) -> Option<Fault> {
    use planar::*;
    let scene = System::new(Pinned::origin(), Rod::uniform(T::one(), T::one()), Free).ok()?.with_gravity(T::of(9.81));
    let start = scene.at_rest(&[T::zero()]).ok()?;
    let mut instants = 0;
    fault(scene.simulate(start, Dop853::tolerance(tolerance), T::one(), |_| {
        instants += 1;
        assert!(instants < 10_000, "the run does not end");
    }))
}

#[test]
fn tolerances_below_rounding_are_refused() {
    let below = |value: f64, least: f64| {
        let (most, outside) = (f64::INFINITY, "numbers are rounded by more");
        Some(Fault::OutOfRange { parameter: "tolerance", value, least, most, outside })
    };
    let rounding = f64::from(f32::EPSILON);
    for tolerance in [1e-12_f32, 1e-30] {
        assert_eq!(with_tolerance(tolerance), below(tolerance.into(), rounding));
    }
    for tolerance in [1e-300, 1e-16] {
        assert_eq!(with_tolerance(tolerance), below(tolerance, f64::EPSILON));
    }
    assert_eq!((with_tolerance(2e-7_f32), with_tolerance(1e-15)), (None, None));
}

#[test]
fn runs_that_would_not_end_are_refused() -> Result<(), Error> {
    use planar::*;
    let pendulum = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let (scene, start) = (&pendulum, pendulum.at_rest(&[0.0])?);
    let show = |_: &Now<'_, _, _, _, _, _>| panic!("a run began");
    let refused = |fault: Option<Fault>, parameter: &str, value: f64| {
        let Some(Fault::OutOfRange { parameter: found, value: given, least, .. }) = fault else { panic!("{fault:?}") };
        assert_eq!((found, given), (parameter, value));
        assert!(least > value && least < 1e-6);
    };
    for step in [1e-300, 1e-17, 1e-12] {
        refused(fault(scene.simulation(Rk4::step(step)).run(start, 1.0, show)), "step size", step);
        refused(fault(scene.simulation(Sdirk4::new().step(step)).run(start, 1.0, show)), "step size", step);
    }
    for every in [1e-300, 1e-12] {
        let run = scene.simulation(Rk4::step(0.1)).every(every).run(start, 1.0, show);
        refused(fault(run), "interval between samples", every);
        let run = scene.simulation(Dopri5::tolerance(1e-6)).longest_step(every).run(start, 1.0, show);
        refused(fault(run), "longest step", every);
    }
    // Late, steps are short that were long enough before.
    let late = start.at_time(1e9);
    refused(fault(scene.simulation(Rk4::step(1e-9)).run(late, 1e9 + 1e-6, show)), "step size", 1e-9);
    let run = scene.simulation(Rk4::step(1e-3)).every(1e-9).run(late, 1e9 + 1e-6, show);
    refused(fault(run), "interval between samples", 1e-9);
    let run = scene.simulation(Dopri5::tolerance(1e-6)).longest_step(1e-9).run(late, 1e9 + 1e-6, show);
    refused(fault(run), "longest step", 1e-9);
    // What hangs at rest may do so late, in steps that advance time.
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0_f32, 1.0), Free)?;
    let rest = scene.motion().at_time(4000.0);
    let run = scene.simulate(rest, Dopri5::tolerance(1e-4), 4001.0, |_| ())?;
    assert_eq!(run.motion.time(), 4001.0);
    // Short runs may have short steps.
    let mut steps = 0;
    pendulum.simulation(Rk4::step(1e-12)).every(1e-12).run(start, 1e-9, |_| steps += 1)?;
    assert_eq!(steps, 1001);
    Ok(())
}
