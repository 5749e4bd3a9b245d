//! Gradients asked for wrongly: what they refuse, and that nothing of it is left for the next one.

use super::names::*;
use catena::loading::LoadLaw;
use catena::sensitivity::{Checkpoints, Costate};
use catena::{Error, Fault};

type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

fn pendulum() -> Result<Pendulum, Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

#[test]
fn a_cost_that_fails_leaves_no_torques_behind() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (torques, mut states) = ([0.1, 0.2], [start; 11]);
    let mut backward = system.backward(Rk4);
    backward.run(&start, 0.01, 10, &torques, &mut states)?;
    let end = |step: usize, by: &mut Costate<_>| match step {
        10 => by.add(&[0.0, 1.0], &[0.0; 2]),
        _ => Ok(()),
    };
    let [mut expected, mut found] = [[0.0; 2]; 2];
    backward.gradient(&torques, &states, &mut expected, |step, _, by| end(step, by))?;
    let failed = backward.gradient(&torques, &states, &mut found, |step, _, by| match step {
        5 => Err(Error::new(Fault::NoBodies)),
        _ => end(step, by),
    });
    assert!(failed.is_err());
    backward.gradient(&torques, &states, &mut found, |step, _, by| end(step, by))?;
    assert_eq!(found, expected);
    Ok(())
}

/// Numbers of steps beyond all that a list can hold are refused as others are.
#[test]
fn more_steps_than_can_be_counted_are_refused() -> Result<(), Error> {
    let (system, most) = (pendulum()?, usize::MAX);
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    let refused = |found: Result<(), Error>, given: usize| {
        let fault = found.unwrap_err().fault;
        assert!(matches!(fault, Fault::Count { expected: usize::MAX, given: few, .. } if few == given), "{fault:?}");
    };
    refused(backward.run(&start, 0.1, most, &[], &mut states), 3);
    refused(backward.run(&start, 0.1, most, &[1.0], &mut states), 1);
    let plan = Checkpoints { step: 0.1, steps: most, every: 1 };
    refused(backward.run_between(&start, plan, &[], &mut states), 3);
    Ok(())
}

#[test]
fn steps_that_do_not_go_on_and_costs_that_are_no_numbers_are_refused() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states, mut next) = (system.backward(Rk4), [start; 3], start);
    let mut tape = [backward.tape(), backward.tape()];
    let refused = |found: Result<(), Error>| matches!(found.unwrap_err().fault, Fault::NotPositive { .. });
    for step in [0.0, -0.005, f64::NAN, f64::INFINITY] {
        assert!(refused(backward.run(&start, step, 2, &[], &mut states)), "{step}");
        let plan = Checkpoints { step, steps: 2, every: 1 };
        assert!(refused(backward.run_between(&start, plan, &[], &mut states)), "{step}");
        assert!(refused(backward.run_on_tape(&start, step, 2, &[], &mut tape, &mut next)), "{step}");
        assert!(refused(backward.linearised_step(&start, step, &[], &mut next, &mut [0.0; 16], &mut [])), "{step}");
    }
    backward.run(&start, 0.01, 2, &[], &mut states)?;
    let found = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[f64::NAN, 0.0], &[0.0; 2]));
    assert!(matches!(found.map(|_| ()).unwrap_err().fault, Fault::NotFinite { .. }));
    Ok(())
}

#[test]
fn states_of_another_plan_and_beyond_the_end_are_refused() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states) = (system.backward(Rk4), [start; 16]);
    let plan = Checkpoints { step: 0.01, steps: 100, every: 7 };
    backward.run_between(&start, plan, &[], &mut states)?;
    let mut tape = vec![backward.tape(); 10];
    let mut asked = |plan| {
        let found = backward.gradient_between(plan, &[], &states, &mut tape, &mut [], |_, _, _| Ok(()));
        found.map(|_| ()).map_err(|error| error.fault)
    };
    assert_eq!(asked(plan), Ok(()));
    for other in
        [Checkpoints { every: 10, ..plan }, Checkpoints { every: 8, ..plan }, Checkpoints { step: 0.02, ..plan }]
    {
        assert!(matches!(asked(other), Err(Fault::Unsupported { what }) if what.contains("another plan")), "{other:?}");
    }
    // A list that is longer than the run: what is beyond is at the start's time.
    let mut states = [start; 15];
    backward.run(&start, 0.01, 10, &[], &mut states)?;
    let found = backward.gradient(&[], &states, &mut [], |_, _, _| Ok(())).map(|_| ()).unwrap_err();
    assert!(matches!(found.fault, Fault::OutOfRange { value, .. } if (value + 0.1).abs() < 1e-15), "{found}");
    assert!(found.time.is_some_and(|time| (time - 0.1).abs() < 1e-15));
    assert!(backward.gradient(&[], &states[..11], &mut [], |_, _, _| Ok(())).is_ok());
    Ok(())
}

#[test]
fn an_event_that_no_time_changes_has_no_gradient() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.01, 2, &[], &mut states)?;
    let cost = |_: usize, _: &_, by: &mut Costate<_>| by.add(&[1.0, 0.0], &[0.0; 2]);
    for slope in [0.0, f64::NAN] {
        let event = |_: &_, by: &mut Costate<_>| by.add(&[slope; 2], &[0.0; 2]);
        let found = backward.gradient_to_event(&[], &states, &mut [], cost, event).map(|_| ()).unwrap_err().fault;
        assert!(matches!(found, Fault::NotFinite { .. }), "{found:?}");
    }
    Ok(())
}

#[test]
fn an_event_function_that_is_no_number_cuts_nothing() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.01, 2, &[], &mut states)?;
    // Of unlike signs at the states, and nothing between them.
    let found = backward.cut(&[], &mut states, |state| match state.time() {
        0.0 => 1.0,
        0.01 => -1.0,
        _ => f64::NAN,
    });
    let fault = found.unwrap_err().fault;
    assert!(matches!(fault, Fault::NotFinite { parameter: "value of the event function" }), "{fault:?}");
    Ok(())
}

#[test]
fn a_run_is_cut_after_a_zero_at_its_start() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let (mut backward, mut states) = (system.backward(Rk4), [start; 3]);
    backward.run(&start, 0.1, 2, &[], &mut states)?;
    let uncut = states;
    assert_eq!(backward.cut(&[], &mut states, |state| state.time() * (state.time() + 0.05))?, None);
    assert_eq!(states, uncut);
    assert_eq!(backward.cut(&[], &mut states, |state| state.time() * (state.time() - 0.05))?, Some(1));
    assert!((states[1].time() - 0.05).abs() < 1e-15);
    Ok(())
}

/// A force that grows with time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Growing<T> {
    pub(super) pace: T, // (N/s)
}
catena::lift!(Growing<T> { pace });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Growing<T> {
    type Value = Wrench<T>;

    fn at(&self, time: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        motion.force_at([T::zero(); 2], [T::zero(), self.pace.scale(time)])
    }
}

/// A brake that fades in with time: nothing where nothing moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fading<T> {
    pub(super) pace: T, // (N/m)
}
catena::lift!(Fading<T> { pace });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Fading<T> {
    type Value = Wrench<T>;

    fn at(&self, time: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let v = motion.outboard().velocity * -self.pace.scale(time);
        motion.force_at([T::zero(); 2], [v.x, v.y])
    }
}

/// The last step begins at rest, or ends there, where such loads are the same at all times.
#[test]
fn loads_of_time_are_found_out_by_all_motions_of_the_last_step() -> Result<(), Error> {
    let system = pendulum()?;
    let mut states = [system.at_rest(&[-1.0, -0.5])?; 2];
    let mut backward = system.backward(Rk4).under(Fading { pace: 0.1 });
    let start = states[0];
    backward.run(&start, 0.01, 1, &[], &mut states)?;
    let mut ends_at_rest = [states[1].at_time(0.0), start.at_time(0.01)];
    for states in [&mut states, &mut ends_at_rest] {
        let past = states[0];
        let mut end = |size: f64| -> Result<Vec<f64>, Error> {
            let mut states = [past; 2];
            backward.run(&past, size, 1, &[], &mut states)?;
            Ok(states[1].coordinates())
        };
        // What cost and event change by as the step grows.
        let [back, ahead, far_back, far_ahead] = [end(0.009)?, end(0.011)?, end(0.008)?, end(0.012)?];
        let slope = |k: usize| (8.0 * (ahead[k] - back[k]) - (far_ahead[k] - far_back[k])) / 0.012;
        let cost = |_: usize, _: &_, by: &mut Costate<_>| by.add(&[1.0, 0.0], &[0.0; 2]);
        let event = |_: &_, by: &mut Costate<_>| by.add(&[0.0, 1.0], &[0.0; 2]);
        let found = backward.gradient_to_event(&[], states, &mut [], cost, event)?.by_rate();
        let at_last = |k: usize, _: &_, by: &mut Costate<_>| {
            by.add(&[1.0, if k == 1 { -slope(0) / slope(1) } else { 0.0 }], &[0.0; 2])
        };
        let expected = backward.gradient(&[], states, &mut [], at_last)?.by_rate();
        println!("{found:?} {expected:?}");
        found.iter().zip(&expected).for_each(|(found, expected)| near(*found, *expected, 1e-10 * expected.abs()));
    }
    Ok(())
}

/// The number of a body.
#[derive(Clone, Copy, Debug)]
struct Body(usize);
catena::lift!(Body);

/// A pull on one body.
#[derive(Clone, Copy, Debug)]
struct Pull<T> {
    body: Body,
    force: T, // (N)
}
catena::lift!(Pull { body, force });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Pull<T> {
    type Value = Wrench<T>;

    fn at(&self, _: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let force = if body == self.body.0 { self.force } else { T::zero() };
        motion.force_at([T::zero(); 2], [force, T::zero()])
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        if self.body.0 < bodies { Ok(()) } else { Err(Fault::NoSuchBody { body: self.body.0, bodies }) }
    }
}

#[test]
fn loads_on_bodies_that_do_not_exist_are_refused() -> Result<(), Error> {
    let system = pendulum()?;
    let start = system.at_rest(&[-1.0, -0.5])?;
    let refused = |found: Result<(), Error>| {
        let fault = found.unwrap_err().fault;
        assert!(matches!(fault, Fault::NoSuchBody { body: 5, .. }), "{fault:?}");
    };
    let (mut states, mut next) = ([start; 3], start);
    let mut backward = system.backward(Rk4).under(Pull { body: Body(5), force: 1.0 });
    let plan = Checkpoints { step: 0.01, steps: 2, every: 1 };
    let mut tape = [backward.tape(), backward.tape()];
    refused(backward.run(&start, 0.01, 2, &[], &mut states));
    refused(backward.run_between(&start, plan, &[], &mut states));
    refused(backward.run_on_tape(&start, 0.01, 2, &[], &mut tape, &mut next));
    refused(backward.linearised_step(&start, 0.01, &[], &mut next, &mut [0.0; 16], &mut []));
    refused(backward.cut(&[], &mut states, |_| 1.0).map(|_| ()));
    let cost = |_: usize, _: &_, _: &mut Costate<_>| Ok(());
    refused(backward.gradient(&[], &states, &mut [], cost).map(|_| ()));
    refused(backward.gradient_between(plan, &[], &states, &mut tape, &mut [], cost).map(|_| ()));
    refused(backward.gradient_on_tape(2, &tape, &start, &mut [], cost).map(|_| ()));
    refused(backward.gradient_to_event(&[], &states, &mut [], cost, |_, _| Ok(())).map(|_| ()));
    system.backward(Rk4).under(Pull { body: Body(1), force: 1.0 }).run(&start, 0.01, 2, &[], &mut states)
}
