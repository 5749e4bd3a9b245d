//! Hinges with linear springs, dampers and rest values, with rotary springs and without.

use super::loads::{MEDIUM, Medium};
use super::*;

/// Numbers of two bodies, gravity, a rotary spring, springs along axes, an axis, a rod, a place, and a law of loads.
fn numbers() -> Vec<f64> {
    let mut parameters = bodies(2);
    parameters.extend([5.0, 3.0, 8.0, 0.3, 0.2, 0.5, 0.2, -0.3, 0.1]); // three of each
    parameters.extend([60.0, 2.0, 0.1, 90.0, 1.0, 70.0, -0.2]); // along x, y and z
    parameters.extend([0.1, -0.4, 0.8, 0.7, 0.6, -0.2, 0.3]); // an axis, a rod, a place
    parameters.extend(MEDIUM);
    parameters
}

const KINDS: Kinds = &[
    ("bodies", 26),
    ("gravity", 3),
    ("rotary spring", 9),
    ("springs", 7),
    ("axis", 3),
    ("rod", 1),
    ("place", 3),
    ("law", 6),
];

/// Hinges of both kinds, and bodies, of numbers.
macro_rules! parts {
    ($N:ty, $x:expr) => {{
        let x = $x;
        let of = |i: usize| body::<$N>(core::array::from_fn(|k| x(13 * i + k)));
        let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
        let full = Spring::new(x(38)).damped(x(39)).resting_at(x(40));
        let (damped, plain) = (Spring::new(x(41)).damped(x(42)), Spring::new(x(43)).resting_at(x(44)));
        let first = ElasticHinge::rotary(vector(29))
            .damped_about(vector(32))
            .resting_at(vector(35))
            .with_linear(full, damped, plain);
        let second = ElasticHinge::linear(plain, full, Spring::new(x(41)));
        let hinge = Revolute::about(vector(45));
        let rod = Rod::new(x(48), x(48), x(48), x(48) * x(48), x(48));
        (first, second, hinge, rod, [of(0), of(1)], vector(26), vector(49))
    }};
}

/// One after the other, in an arm, before and after balls and hinges, and as the last joint.
macro_rules! chains {
    ($method:expr, $steps:expr, $h:expr) => {
        gradients!(
            &format!("linear hinges, {:?}", $method),
            KINDS,
            numbers(),
            // Displacements are numbers.
            [
                &[false, false, false, true][..],
                &[false, false, false, true],
                &[true],
                &[false, false, false, true],
                &[false],
                &[false, false, false, true]
            ]
            .concat(),
            7,
            $method,
            $steps,
            $h,
            |x| {
                let (first, second, hinge, rod, [a, b], gravity, place) = parts!(N, x);
                let chain = (first, a, Branch((second, b)), Ball, a, first, rod, hinge, b, second, a);
                System::new(Clamped::at(place, Rotation::identity()), chain, Free).unwrap().with_gravity(gravity)
            },
            under(6, |y| { Medium::of(y, 52) })
        )
    };
}

#[test]
fn hinges_with_linear_springs_have_the_gradients_of_jets() {
    with_room(|| chains!(Rk4, 2, 0.02));
}

/// By rules whose pivots know springs.
#[test]
fn hinges_with_linear_springs_have_the_gradients_of_jets_by_implicit_rules() {
    with_room(|| {
        chains!(Sdirk4::new(), 2, 0.02);
        chains!(GeneralizedAlpha::new(0.8), 2, 0.02);
    });
}

/// In both arms of a loop, and before a tip that is held.
macro_rules! closed {
    ($method:expr, $steps:expr, $h:expr) => {
        gradients!(
            &format!("linear hinges in a loop, {:?}", $method),
            KINDS,
            numbers(),
            [
                &[false, false, false, true][..],
                &[true],
                &[false, false, false, true],
                &[true],
                &[false, false, false, true],
                &[false]
            ]
            .concat(),
            8,
            $method,
            $steps,
            $h,
            |x| {
                let (first, second, hinge, rod, [a, b], gravity, place) = parts!(N, x);
                let network = Network::new((first, a, Ball, b), (second, b), Ball);
                let chain = (b, network, Ball, a, second, b, hinge, rod);
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::identity());
                System::new(root, chain, Pinned::at(place)).unwrap().with_gravity(gravity)
            },
            under(6, |y| { Medium::of(y, 52) })
        )
    };
}

#[test]
fn hinges_with_linear_springs_in_closed_scenes_have_the_gradients_of_jets() {
    with_room(|| {
        closed!(Rk4, 2, 0.01);
        closed!(Sdirk4::new(), 1, 0.01);
        closed!(GeneralizedAlpha::new(0.8), 2, 0.01);
    });
}

/// A law that stiffens, which implicit rules read where accelerations have led, and with it all others of the hinge.
macro_rules! stiffening {
    ($method:expr, $steps:expr, $h:expr) => {{
        let mut parameters = bodies(2);
        parameters.extend([5.0, 3.0, 8.0, 30.0, 0.5, 60.0, 0.1]);
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("rotary spring", 3), ("law", 2), ("spring", 2)];
        let name = format!("stiffening along an axis, {:?}", $method);
        let balls = [false, false, false, true, false, false, false, true];
        gradients!(&name, kinds, parameters, balls, 3, $method, $steps, $h, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let law = Custom(Stiffening { stiffness: x(32), damping: x(33) });
            let spring = Spring::new(x(34)).resting_at(x(35));
            let hinge = ElasticHinge::rotary(vector(29)).with_linear(spring, law, spring);
            let root = Clamped::at([0.0; 3].map(N::constant), Rotation::identity());
            System::new(root, (hinge, of(0), hinge, of(1)), Free).unwrap().with_gravity(vector(26))
        })
    }};
}

#[test]
fn laws_along_axes_that_stiffen_have_the_gradients_of_jets() {
    stiffening!(Dop853, 1, 0.05);
    stiffening!(Sdirk4::new(), 2, 0.02);
    stiffening!(GeneralizedAlpha::new(0.8), 2, 0.02);
}
