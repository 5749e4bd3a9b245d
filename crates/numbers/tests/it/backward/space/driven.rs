//! Joints that turn about an axis or slide along one as they are told, in chains and arms, to a held tip and around a loop.

use super::super::driven::Swing;
use super::loads::{MEDIUM, Medium};
use super::*;

/// Numbers of two bodies, gravity, axes and laws of a crank and of a line, the root, and more.
fn numbers(more: &[f64]) -> Vec<f64> {
    let mut parameters = bodies(2);
    parameters.extend([0.3, 1.0, -0.5, 0.4, -0.7, 0.5, 3.1]); // the crank
    parameters.extend([0.9, -0.2, 0.4, 0.2, 0.1, 0.3, 4.0]); // the line
    parameters.extend([0.3, -0.2, 0.1, 0.4, 0.2, -0.6]); // the root
    parameters.extend(more);
    parameters
}
/// What they are.
const KINDS: [(&str, usize); 7] = [
    ("bodies", 26),
    ("gravity", 3),
    ("axis of the crank", 3),
    ("crank", 4),
    ("axis of the line", 3),
    ("line", 4),
    ("root", 6),
];

/// The crank, the line, bodies and the root of numbers.
macro_rules! parts {
    ($N:ty, $x:expr) => {{
        let x = $x;
        let of = |i: usize| body::<$N>(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let law = |k: usize| Swing { offset: x(k), drift: x(k + 1), amplitude: x(k + 2), frequency: x(k + 3) };
        let crank = Driven::new(Revolute::about(vector(29)), law(32));
        let line = Driven::new(Prismatic::along(vector(36)), law(39));
        let root = Clamped::at(vector(43), Rotation::from_angles(vector(46)));
        (crank, line, [of(0), of(1)], root, vector(26))
    }};
}

/// Cranks at the root and in an arm, a line beyond a ball.
macro_rules! chains {
    ($method:expr, $steps:expr, $h:expr) => {{
        let kinds = [&KINDS[..], &[("law", 6)]].concat();
        let name = format!("driven, {:?}", $method);
        let balls = [true, true, false, true];
        gradients!(
            &name,
            kinds,
            numbers(&MEDIUM),
            balls,
            9,
            $method,
            $steps,
            $h,
            |x| {
                let (crank, line, [a, b], root, gravity) = parts!(N, x);
                let arm = (crank, a, Ball, b);
                let hinge = Revolute::about([0, 1, 2].map(|k| x(36 + k)));
                let chain = (crank, a, Branch(arm), Ball, b, line, a, hinge, b, line, b, Ball, a);
                System::new(root, chain, Free).unwrap().with_gravity(gravity)
            },
            under(6, |y| { Medium::of(y, 49) })
        )
    }};
}

#[test]
fn driven_chains_have_the_gradients_of_jets() {
    with_room(|| chains!(Rk4, 3, 0.05));
}

#[test]
fn driven_chains_have_the_gradients_of_jets_by_implicit_rules() {
    with_room(|| chains!(GeneralizedAlpha::new(0.8), 3, 0.02));
}

/// Between a clamp and a ball of the ground.
#[test]
fn held_chains_with_a_crank_have_the_gradients_of_jets() {
    with_room(|| {
        let kinds = [&KINDS[..], &[("tip", 3)]].concat();
        gradients!("driven, held", kinds, numbers(&[1.4, 0.5, -0.3]), [true; 3], 6, Rk4, 3, 0.03, |x| {
            let (crank, line, [a, b], root, gravity) = parts!(N, x);
            let chain = (crank, a, Ball, b, line, a, Ball, b, Ball, a);
            System::new(root, chain, Pinned::at([0, 1, 2].map(|k| x(49 + k)))).unwrap().with_gravity(gravity)
        });
    });
}

/// A window beyond the crank, which a hinge closes.
#[test]
fn loops_with_a_crank_have_the_gradients_of_jets() {
    with_room(|| {
        gradients!("driven loop", KINDS, numbers(&[]), [true; 4], 8, Rk4, 3, 0.03, |x| {
            let (crank, line, [a, b], root, gravity) = parts!(N, x);
            let (main, side) = ((crank, a, Ball, b, line, a), (Ball, b, Ball, a, Ball, b));
            let net = Network::new(main, side, Ball);
            System::new(root, (a, net), Free).unwrap().with_gravity(gravity)
        });
    });
}
