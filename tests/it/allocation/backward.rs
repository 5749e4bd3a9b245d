//! Gradients of runs allocate nothing.

use super::counting::allocations;
use catena::Error;
use catena::planar::*;
use catena::scalar::Jet;
use catena::sensitivity::Checkpoints;

#[test]
fn gradients_allocate_nothing() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.5, 0.1]);
    let system = System::new(Pinned::origin(), (rod, Branch((Pin, plate)), [(Pin, rod); 3]), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.5, 0.0, 0.5, 1.0])?;
    let (mut states, torques, mut by_torques) = ([start; 21], [0.1; 100], [0.0; 100]);
    let mut backward = system.backward(Dop853);
    let number = |x| Jet::<f64, 2>::of(x);
    let lifted = system.lift(number).with_gravity(Jet::seed(9.81, 0));
    let (count, outcome) = allocations(|| {
        backward.run(&start, 0.01, 20, &torques, &mut states)?;
        let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
            20 => by.add(&[1.0; 5], &[0.0; 5]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&torques, &states, &mut by_torques, end)?;
        gradient.along(&lifted)
    });
    let [by_gravity, by_nothing] = outcome?;
    assert!(count == 0 && by_gravity != 0.0 && by_nothing == 0.0, "{count} allocations, {by_gravity}, {by_nothing}");
    assert!(by_torques.iter().all(|x| *x != 0.0));
    Ok(())
}

#[test]
fn gradients_in_space_allocate_nothing() -> Result<(), Error> {
    use catena::spatial::{Ball, Clamped, Effort, Free, Revolute, RigidBody, Rod, System};
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let tensor = [[0.02, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.04]];
    let body = RigidBody::new(1.0, tensor, [0.2, 0.1, 0.0], [0.5, 0.1, -0.1]);
    let chain = (Revolute::about([0.0, 0.6, 0.8]), body, Branch((Ball, rod)), [(Ball, rod); 2]);
    let system = System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
    let start = system.at_rest(&[0.3, 0.1, 0.2, 0.4, -0.3, 0.2, 0.1, 0.5, -0.2, 0.3])?;
    let (mut states, torques) = ([start; 11], [Effort([1e-3, 2e-3, -1e-3]); 50]);
    let (mut backward, mut by_torques) = (system.backward(Rk4), torques);
    let gravity = [Jet::of(0.0), Jet::of(0.0), Jet::<f64, 1>::seed(-9.81, 0)];
    let lifted = system.lift(Jet::<f64, 1>::of).with_gravity(gravity);
    let (count, outcome) = allocations(|| {
        backward.run(&start, 0.01, 10, &torques, &mut states)?;
        let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
            10 => by.add(&[1.0; 10], &[0.5; 10]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&torques, &states, &mut by_torques, end)?;
        Ok::<_, Error>([gradient.along(&lifted)?[0], gradient.by_gravity().z])
    });
    let [along, by_gravity] = outcome?;
    assert!(count == 0 && along == by_gravity && along != 0.0, "{count} allocations, {along}, {by_gravity}");
    Ok(())
}

#[test]
fn gradients_of_held_tips_and_loops_in_space_allocate_nothing() -> Result<(), Error> {
    use catena::spatial::{Ball, Clamped, Effort, Hinged, Revolute, Rod, Rotation, System};
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let window = Network::new((Ball, rod, Ball, rod), (Ball, rod, Ball, rod), Revolute::about([0.0, 0.0, 1.0]));
    let chain = (Revolute::about([0.0, 0.6, 0.8]), rod, window, Ball, rod);
    let tip = Hinged::on(Clamped::at([1.0, 0.2, 0.3], Rotation::from_angles([0.1, 0.2, 0.3])), [0.0, 0.0, 1.0]);
    let system = System::new(Clamped::origin(), chain, tip)?.with_gravity([0.0, 0.0, -9.81]);
    let angles = [0.3, 0.1, 0.2, 0.4, -0.3, 0.2, -0.9, 0.5, -0.2, -0.9, 0.1, -0.3, 0.4, 0.5, 0.2, -0.4];
    let start = system.assembled(system.at_rest(&angles)?, &Unloaded)?;
    let (mut states, torques) = ([start; 6], [Effort([1e-3, 2e-3, -1e-3]); 40]);
    let (mut backward, mut by_torques) = (system.backward(Rk4), torques);
    let gravity = [Jet::of(0.0), Jet::of(0.0), Jet::<f64, 1>::seed(-9.81, 0)];
    let lifted = system.lift(Jet::<f64, 1>::of).with_gravity(gravity);
    let (count, outcome) = allocations(|| {
        backward.run(&start, 0.01, 5, &torques, &mut states)?;
        let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
            5 => by.add(&[1.0; 16], &[0.5; 16]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&torques, &states, &mut by_torques, end)?;
        Ok::<_, Error>([gradient.along(&lifted)?[0], gradient.by_gravity().z])
    });
    let [along, by_gravity] = outcome?;
    assert!(count == 0 && along == by_gravity && along != 0.0, "{count} allocations, {along}, {by_gravity}");
    Ok(())
}

/// Few states and a tape, a run that is cut at an event, and a step's Jacobians.
#[test]
fn gradients_of_all_kinds_of_runs_allocate_nothing() -> Result<(), Error> {
    type Costate<R> = catena::sensitivity::Costate<R>;
    let rod = Rod::uniform(0.5, 1.0);
    let hinge = ElasticHinge::rotary(5.0).damped(0.1).resting_at(0.2);
    let cart = Slider::along(0.0).with(Spring::new(30.0));
    let chain = (cart, rod, Pin, rod, Branch((hinge, rod)), hinge, rod);
    let system = System::new(Clamped::at(0.0, 0.0, -1.0), chain, Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.5, -1.0, 0.5])?;
    let plan = Checkpoints { step: 0.01, steps: 40, every: 7 };
    let mut backward = system.backward(Rk4);
    let (mut states, mut few, mut tape) = ([start; 41], [start; 7], vec![backward.tape(); 40]);
    let (mut next, mut by_state, mut by_torques) = (start, [0.0; 64], [0.0; 40]);
    let end = |step: usize, _: &_, by: &mut Costate<_>| match step {
        40 => by.add(&[1.0; 4], &[0.0; 4]),
        _ => Ok(()),
    };
    let (count, outcome) = allocations(|| {
        backward.run_between(&start, plan, &[], &mut few)?;
        let between = backward.gradient_between(plan, &[], &few, &mut tape, &mut [], end)?;
        let levels = backward.gradient_in_levels(plan, &[], &few, &mut [few[0]; 4], &mut tape[..2], &mut [], end)?;
        assert_eq!(levels.start, between.start);
        backward.run_on_tape(&start, 0.01, 40, &[], &mut tape, &mut next)?;
        let taped = backward.gradient_on_tape(40, &tape, &next, &mut [], end)?;
        backward.run(&start, 0.01, 40, &[], &mut states)?;
        let cut = backward.cut(&[], &mut states, |state| state.rate().1.2 - 1.0)?;
        let at_event = match cut {
            Some(steps) => {
                let states = &states[..=steps];
                backward
                    .gradient_to_event(&[], states, &mut [], end, |_, by| by.add(&[0.0; 4], &[0.0, 1.0, 0.0, 0.0]))?
            }
            None => return Ok(None),
        };
        backward.linearised_step(&start, 0.01, &[], &mut next, &mut by_state, &mut by_torques)?;
        Ok::<_, Error>(Some([between.by_gravity().y, taped.by_gravity().y, at_event.by_gravity().y]))
    });
    let found = outcome?;
    assert!(matches!(found, Some([a, b, _]) if a == b && a != 0.0), "{found:?}");
    assert!(count == 0, "{count} allocations");
    Ok(())
}

/// Torques of steps on a tape are copied into the room that it has, of vectors too; the gradient itself takes as much as any other.
#[test]
fn tapes_of_an_implicit_rule_allocate_nothing() -> Result<(), Error> {
    let (rod, hinge) = (Rod::uniform(0.5, 1.0), ElasticHinge::rotary(50.0).damped(0.1));
    let system = System::new(Pinned::origin(), (rod, vec![(hinge, rod); 3]), Free)?.with_gravity(9.81);
    let (start, torques) = (system.at_rest(&[-1.0, 0.1, 0.2, 0.1])?, [0.1; 80]);
    let mut backward = system.backward(Sdirk4::new());
    let (mut states, mut tape, mut next) = (vec![start.clone(); 21], vec![backward.tape(); 20], start.clone());
    let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
        20 => by.add(&[1.0; 4], &[0.0; 4]),
        _ => Ok(()),
    };
    let mut both = || -> Result<_, Error> {
        let (run, kept) = allocations(|| backward.run(&start, 0.01, 20, &torques, &mut states));
        kept?;
        let (taped, kept) = allocations(|| backward.run_on_tape(&start, 0.01, 20, &torques, &mut tape, &mut next));
        kept?;
        let (gradient, kept) = allocations(|| backward.gradient(&torques, &states, &mut [], end));
        let expected = kept?.by_position();
        let (on_tape, kept) = allocations(|| backward.gradient_on_tape(20, &tape, &next, &mut [], end));
        assert_eq!(kept?.by_position(), expected);
        Ok([run, taped, gradient, on_tape])
    };
    both()?; // room for sweeps is made once
    let [run, taped, gradient, on_tape] = both()?;
    assert_eq!((run, taped, on_tape), (0, 0, gradient));
    Ok(())
}

/// Rooms for the sweeps of a stage are made with the way back, whatever the rule.
#[test]
fn gradients_by_implicit_rules_allocate_nothing() -> Result<(), Error> {
    let (rod, hinge) = (Rod::uniform(0.5, 1.0), ElasticHinge::rotary(50.0).damped(0.1));
    let system = System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.9, -0.8, -0.7])?;
    let torques = [0.1; 40];
    macro_rules! count {
        ($rule:expr) => {{
            let (mut states, mut by_torques) = ([start; 11], [0.0; 40]);
            let mut backward = system.backward($rule);
            let (count, outcome) = allocations(|| {
                backward.run(&start, 0.01, 10, &torques, &mut states)?;
                let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
                    10 => by.add(&[1.0; 4], &[0.0; 4]),
                    _ => Ok(()),
                };
                Ok::<_, Error>(backward.gradient(&torques, &states, &mut by_torques, end)?.by_gravity().y)
            });
            assert!(count == 0 && outcome? != 0.0, "{count} allocations");
            assert!(by_torques.iter().all(|x| *x != 0.0));
        }};
    }
    count!(Sdirk4::new());
    count!(GeneralizedAlpha::new(0.8));
    Ok(())
}
