//! Loops in space that a ball, a weld or a revolute joint closes, and that are closed again at the end of each step.

use super::*;

/// A window of four bodies on balls, behind a body, and before one on a hinge.
#[test]
fn loops_closed_by_balls_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5]);
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3)];
        let balls = [true, true, true, true, true, false];
        gradients!("closed by a ball", kinds, parameters, balls, 7, Rk4, 3, 0.03, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let window = Network::new((Ball, of(0), Ball, of(1)), (Ball, of(1), Ball, of(0)), Ball);
            let chain = (of(1), window, Revolute::about(vector(29)), of(0));
            System::new(Pinned::on([0.0; 3].map(N::constant)), chain, Free).unwrap().with_gravity(vector(26))
        });
    });
}

/// On a ground that is turned, from two places of it.
#[test]
fn loops_closed_by_welds_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.2, 0.4, -0.3, 0.8, 0.2, -0.4, 0.1, 0.2, 0.3, 0.5, -0.2, 0.1]);
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3), ("weld", 3), ("reach", 3), ("ground", 6)];
        let balls = [false, true, true, true];
        gradients!("closed by a weld", kinds, parameters, balls, 6, Rk4, 3, 0.03, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let weld = Weld::at(Rotation::from_angles(vector(32)));
            let side = (RigidBody::massless(vector(35)), Ball, of(1), Ball, of(0));
            let net = Network::new((Revolute::about(vector(29)), of(0), Ball, of(1)), side, weld.named("grip"));
            let root = Clamped::at(vector(38), Rotation::from_angles(vector(41)));
            System::new(root, net, Free).unwrap().with_gravity(vector(26))
        });
    });
}

/// An arm that comes back to its own body by a hinge, under a torque in it.
#[test]
fn loops_closed_by_hinges_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.8, 0.2, -0.4, 0.4, 0.3, 1.0, 3.0, 0.2]);
        let kinds: Kinds =
            &[("bodies", 26), ("gravity", 3), ("axis", 3), ("place", 3), ("closing axis", 3), ("spring", 2)];
        let balls = [true, true, true, false, true];
        gradients!("closed by a hinge", kinds, parameters, balls, 6, Dop853, 2, 0.05, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let hinge = Revolute::about(vector(29)).with(Spring::new(x(38)).damped(x(39)));
            let arm = (Ball, of(0), Ball, of(1), hinge, of(0));
            let swing = ClosedLoop::ending_at(vector(32), arm, Revolute::about(vector(35)));
            System::new(Pinned::on([0.0; 3].map(N::constant)), (of(1), swing, Ball, of(0)), Free)
                .unwrap()
                .with_gravity(vector(26))
        });
    });
}

/// A loop that a hinge closes, in an arm of another, and a tip that is held beyond it.
#[test]
fn nested_loops_and_a_held_tip_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 1.4, 0.5, -0.3]);
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3), ("tip", 3)];
        gradients!("nested", kinds, parameters, [true; 9], 11, Rk4, 2, 0.02, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let inner =
                Network::new((Ball, of(0), Ball, of(1)), (Ball, of(1), Ball, of(0)), Revolute::about(vector(29)));
            let outer = Network::new((Ball, of(0), inner), (Ball, of(1), Ball, of(0)), Ball);
            let chain = (of(1), outer, Ball, of(0));
            System::new(Pinned::on([0.0; 3].map(N::constant)), chain, Pinned::at(vector(32)))
                .unwrap()
                .with_gravity(vector(26))
        });
    });
}

/// From a tape and from few states as from all, bit for bit; and steps have the Jacobians that go with it, projection included.
#[test]
fn closed_scenes_have_one_gradient_however_runs_are_kept() {
    use catena::sensitivity::{Checkpoints, Costate};
    const N: usize = 13;
    let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    let window = Network::new((Ball, rod, Ball, rod), (Ball, rod, Ball, rod), Revolute::about([0.0, 0.0, 1.0]));
    let hinge = Revolute::about([0.0, 1.0, 0.0]);
    let system = System::new(Clamped::origin(), (hinge, rod, window), Pinned::at([1.1, 0.3, -0.2])).unwrap();
    let angles = [0.3, 0.2, 0.4, -0.3, 0.2, -0.9, 0.5, -0.2, -0.9, 0.1, -0.3, 0.4, 0.5];
    let guess = system.with_rates(system.at_rest(&angles).unwrap(), &angles).unwrap();
    let start = system.assembled(guess, &Unloaded).unwrap();
    let joints = system.joints();
    let torques: Vec<_> =
        (0..4 * joints).map(|k| Effort([0, 1, 2].map(|i| 0.1 * ((3 * k + i) as f64).sin()))).collect();
    let plan = Checkpoints { step: 0.05, steps: 4, every: 3 };
    let mut backward = system.backward(Rk4);
    let (mut states, mut few) = (vec![start; 5], vec![start; plan.states()]);
    let (mut tape, mut end, mut by) = (vec![backward.tape(); 4], start, [(); 3].map(|()| torques.clone()));
    let cost = |step: usize, _: &_, by: &mut Costate<_>| if step == 4 { by.add(&angles, &[0.2; N]) } else { Ok(()) };
    backward.run(&start, 0.05, 4, &torques, &mut states).unwrap();
    let all = backward.gradient(&torques, &states, &mut by[0], cost).unwrap();
    backward.run_on_tape(&start, 0.05, 4, &torques, &mut tape, &mut end).unwrap();
    let taped = backward.gradient_on_tape(4, &tape, &end, &mut by[1], cost).unwrap();
    backward.run_between(&start, plan, &torques, &mut few).unwrap();
    let between = backward.gradient_between(plan, &torques, &few, &mut tape, &mut by[2], cost).unwrap();
    for (other, by_torques) in [(&taped, &by[1]), (&between, &by[2])] {
        assert!(all.by_position() == other.by_position() && all.by_rate() == other.by_rate() && by[0] == *by_torques);
    }
    // The last costate through the Jacobians of four steps.
    let mut costate: Vec<f64> = angles.into_iter().chain([0.2; N]).collect();
    for k in (0..4).rev() {
        let (mut next, mut a, mut b) = (start, [0.0; 4 * N * N], vec![Effort([0.0; 3]); 2 * N * joints]);
        let held = &torques[joints * k..][..joints];
        // Steps of a run are as long as its clock, which rounds.
        let size = states[k + 1].time() - states[k].time();
        backward.linearised_step(&states[k], size, held, &mut next, &mut a, &mut b).unwrap();
        for (joint, expected) in by[0][joints * k..][..joints].iter().enumerate() {
            for i in 0..3 {
                let found: f64 = (0..2 * N).map(|row| costate[row] * b[joints * row + joint].0[i]).sum();
                near(found, expected.0[i], ROUNDING);
            }
        }
        costate = (0..2 * N).map(|j| (0..2 * N).map(|row| costate[row] * a[2 * N * row + j]).sum()).collect();
    }
    let expected = all.by_position().into_iter().chain(all.by_rate());
    costate.iter().zip(expected).for_each(|(found, x)| near(*found, x, ROUNDING));
}

/// A rod between two balls: both hold its length. And a loop of straight arms.
#[test]
fn closures_that_depend_on_each_other_are_refused() {
    let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    let (held, straight) = (Pinned::at([0.5, 0.0, 0.0]), (Ball, rod, Ball, rod));
    let held = System::new(Pinned::origin(), rod, held).unwrap();
    let looped = System::new(Pinned::origin(), (rod, Network::new(straight, straight, Ball)), Free).unwrap();
    let (start, begin) = (held.at_rest(&[0.0; 3]).unwrap(), looped.at_rest(&[0.0; 15]).unwrap());
    let faults = [
        held.backward(Rk4).run(&start, 0.01, 1, &[], &mut [start; 2]).unwrap_err().fault,
        looped.backward(Rk4).run(&begin, 0.01, 1, &[], &mut [begin; 2]).unwrap_err().fault,
    ];
    assert!(faults.iter().all(|fault| matches!(fault, Fault::RedundantClosures { .. })), "{faults:?}");
}
