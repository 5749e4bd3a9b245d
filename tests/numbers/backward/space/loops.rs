//! Loops in space that a ball, a weld or a revolute joint closes, and that are closed again at the end of each step.

use super::*;

/// Without optimisation these scenes over jets are too much for the stack of a test.
fn with_room(test: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 26).spawn(test).expect("a thread");
    thread.join().expect("gradients of jets");
}

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
