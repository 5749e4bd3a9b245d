//! Joints that slide along an axis, slide and turn, or turn about two axes.

use super::loads::{MEDIUM, Medium};
use super::*;

/// Numbers of two bodies, gravity, two axes, a weld, two springs of a stiffness, a rod and the root.
fn numbers(stiffness: f64) -> Vec<f64> {
    let mut parameters = bodies(2);
    parameters.extend([0.3, 1.0, -0.5, 0.9, -0.2, 0.4, 0.2, 0.1, -0.4]); // axes, a weld
    parameters.extend([stiffness, 0.1 * stiffness, 0.2, 0.5 * stiffness, 0.1 * stiffness, -0.1]); // springs
    parameters.extend([0.7, 0.8, 0.3, 0.02, 0.05]); // a rod
    parameters.extend([0.3, -0.2, 0.1, 0.4, 0.2, -0.6]); // the root
    parameters.extend(MEDIUM);
    parameters
}

/// What they are.
const KINDS: Kinds =
    &[("bodies", 26), ("gravity", 3), ("axes", 6), ("weld", 3), ("springs", 6), ("rod", 5), ("root", 6), ("law", 6)];

/// A cylinder in an arm and at the tip, a cross about a weld, and a slide beyond a hinge or a ball, under loads.
macro_rules! joints {
    ($method:expr, $steps:expr, $h:expr, $stiffness:expr, $coordinates:expr, $between:expr) => {{
        let name = format!("slides, cylinders and a cross, {:?}", $method);
        gradients!(
            &name,
            KINDS,
            numbers($stiffness),
            $coordinates,
            7,
            $method,
            $steps,
            $h,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let first = Spring::new(x(38)).damped(x(39)).resting_at(x(40));
                let second = Spring::new(x(41)).damped(x(42)).resting_at(x(43));
                let cylinder = Cylindrical::on(vector(29)).with(first, second);
                let cross = Universal::about(vector(32), vector(29)).with(second, first);
                let slide = Prismatic::along(vector(32)).with(first);
                let weld = Weld::at(Rotation::from_angles(vector(35)));
                let rod = Rod::new(x(44), x(45), x(46), x(47), x(48));
                let chain = (
                    of(0),
                    Branch((cylinder, rod)),
                    weld,
                    rod,
                    cross,
                    of(1),
                    $between,
                    of(0),
                    slide,
                    rod,
                    cylinder,
                    rod,
                );
                System::new(Clamped::at(vector(49), Rotation::from_angles(vector(52))), chain, Free)
                    .unwrap()
                    .with_gravity(vector(26))
            },
            under(6, |y| { Medium::of(y, 55) })
        )
    }};
}

#[test]
fn slides_and_crosses_have_the_gradients_of_jets() {
    with_room(|| joints!(Rk4, 3, 0.05, 6.0, [false, false, false, false, true, false, false, false], Ball));
}

/// By rules whose pivots know springs.
#[test]
fn stiff_slides_and_crosses_have_the_gradients_of_jets() {
    fn hinge<T: Scalar>() -> Revolute<T> {
        Revolute::about([0.3, -0.4, 0.8].map(T::literal))
    }
    with_room(|| joints!(Sdirk4::new(), 2, 0.03, 1e3, [false; 8], hinge()));
}

/// A slide that a ball follows, without a body between, a cylinder, and a cross before a tip that is held.
#[test]
fn slides_in_closed_scenes_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.9, -0.2, 0.4, 1.4, 0.5, -0.3]);
        parameters.extend(MEDIUM);
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axes", 6), ("tip", 3), ("law", 6)];
        let coordinates = [true, false, true, false, false, true, true, true, false, false];
        gradients!(
            "slides in a loop",
            kinds,
            parameters,
            coordinates,
            9,
            Rk4,
            2,
            0.02,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let (one, other) = (vector(29), vector(32));
                let main = (Prismatic::along(one), Ball, of(0), Cylindrical::on(other), of(1));
                let chain = (of(1), Network::new(main, (Ball, of(1), Ball, of(0)), Ball), Ball, of(0));
                let chain = (chain, Universal::about(other, one), of(1));
                let root = Pinned::on([0.0; 3].map(N::constant));
                System::new(root, chain, Pinned::at(vector(35))).unwrap().with_gravity(vector(26))
            },
            under(6, |y| { Medium::of(y, 38) })
        );
    });
}

/// Two laws share six numbers: three are each one's, and more are refused.
#[test]
fn each_of_two_laws_has_three_numbers_or_less() {
    macro_rules! scene {
        ($number:expr) => {{
            let spring = Spring::new($number(3.0)).damped($number(0.4)).resting_at($number(0.2));
            let law = Custom((spring, Spring::new($number(1.0))));
            let joint = Cylindrical::on([0.0, 1.0, 0.0].map($number)).with(spring, law);
            let bob = PointMass::new($number(0.4), $number(0.3));
            let ground = Clamped::at([0.0; 3].map($number), Rotation::from_angles([0.0; 3].map($number)));
            System::new(ground, (joint, bob), Free).unwrap()
        }};
    }
    let scene = scene!(|x: f64| x);
    let start = scene.at_rest(&[0.1]).unwrap();
    let (mut backward, mut states) = (scene.backward(Rk4), [start; 2]);
    backward.run(&start, 0.01, 1, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0, 0.0], &[0.0; 2])).unwrap();
    let fault = gradient.along(&scene!(Jet::<f64, 8>::of)).unwrap_err().fault;
    assert!(matches!(fault, Fault::Count { expected: 6, given: 7, .. }), "{fault:?}");
}
