//! Chains in space whose tip is held, and put back at the end of each step.

use super::*;

/// Bodies on balls between two balls of the ground.
macro_rules! pinned {
    ($method:expr, $steps:expr, $h:expr) => {{
        let mut parameters = bodies(3);
        parameters.extend([0.1, -0.2, 0.3, 1.1, 0.4, -0.3]);
        let kinds: Kinds = &[("bodies", 39), ("gravity", 3), ("root", 3), ("tip", 3)];
        let name = format!("pinned, {:?}", $method);
        gradients!(&name, kinds, parameters, [true; 3], 3, $method, $steps, $h, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let chain = (of(0), [(Ball, of(1)), (Ball, of(2))]);
            System::new(Pinned::at(vector(42)), chain, Pinned::at(vector(45))).unwrap().with_gravity(vector(39))
        })
    }};
}

#[test]
fn chains_between_balls_have_the_gradients_of_jets() {
    pinned!(Rk4, 4, 0.05);
    pinned!(Dop853, 2, 0.1);
}

/// Hinges with a spring and without, balls, a weld and an arm, clamped at both ends: without optimisation too much for the stack of a test.
#[test]
fn chains_clamped_at_both_ends_have_the_gradients_of_jets() {
    let thread = std::thread::Builder::new().stack_size(1 << 25).spawn(clamped).expect("a thread");
    thread.join().expect("gradients of jets");
}

fn clamped() {
    let mut parameters = bodies(3);
    parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
    parameters.extend([3.0, 0.4, 0.2]); // a spring
    parameters.extend([0.1, -0.2, 0.3, 0.2, 0.5, -0.3, 1.3, 0.6, -0.4, 0.4, -0.2, 0.7]); // both ends
    let kinds: Kinds =
        &[("bodies", 39), ("gravity", 3), ("axis", 3), ("weld", 3), ("spring", 3), ("root", 6), ("tip", 6)];
    gradients!("clamped", kinds, parameters, [false, true, true, true, false], 7, Rk4, 3, 0.03, |x| {
        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let end = |first: usize| Clamped::at(vector(first), Rotation::from_angles(vector(first + 3)));
        let (hinge, weld) = (Revolute::about(vector(42)), Weld::at(Rotation::from_angles(vector(45))));
        let sprung = hinge.with(Spring::new(x(48)).damped(x(49)).resting_at(x(50)));
        let chain = (sprung, of(0), Branch((Ball, of(1))), Ball, of(1), weld, of(0), Ball, of(2), hinge, of(1));
        System::new(end(51), chain, end(57)).unwrap().with_gravity(vector(39))
    });
}

/// Bodies on balls between two hinges of the ground.
#[test]
fn chains_between_hinges_have_the_gradients_of_jets() {
    let mut parameters = bodies(3);
    parameters.extend([0.1, -0.2, 0.3, 0.2, 0.5, -0.3, 0.3, 1.0, -0.5, 1.1, 0.4, -0.3, 0.4, -0.2, 0.7, 0.9, 0.2, 0.4]);
    let kinds: Kinds = &[("bodies", 39), ("gravity", 3), ("root", 6), ("its axis", 3), ("tip", 6), ("tip's axis", 3)];
    gradients!("hinged", kinds, parameters, [false, true, true], 3, Dop853, 2, 0.1, |x| {
        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let end = |first: usize| {
            let ground = Clamped::at(vector(first), Rotation::from_angles(vector(first + 3)));
            Hinged::on(ground, vector(first + 6))
        };
        System::new(end(42), (of(0), [(Ball, of(1)), (Ball, of(2))]), end(51)).unwrap().with_gravity(vector(39))
    });
}
