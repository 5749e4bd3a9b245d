//! Balls with rotary springs, dampers and rest values.

use super::loads::{MEDIUM, Medium};
use super::*;
use catena::nalgebra::Vector3;
use catena::spatial::{RotaryLaw, Rotation};

/// Numbers of two bodies, gravity, two springs, and a law of loads.
fn numbers() -> Vec<f64> {
    let mut parameters = bodies(2);
    parameters.extend([5.0, 3.0, 8.0, 0.3, 0.2, 0.5, 0.2, -0.3, 0.1]); // three of each
    parameters.extend([6.0, 2.0, 4.0, 0.25]); // alike dampers, no rest
    parameters.extend([0.1, -0.4, 0.8, 0.7, 0.6, -0.2, 0.3]); // an axis, a rod, a tip
    parameters.extend(MEDIUM);
    parameters
}

const KINDS: Kinds =
    &[("bodies", 26), ("gravity", 3), ("springs", 13), ("axis", 3), ("rod", 1), ("tip", 3), ("law", 6)];

/// One after the other, in an arm, before and after balls and hinges, and as the last joint.
macro_rules! chains {
    ($method:expr, $steps:expr, $h:expr) => {
        gradients!(
            &format!("elastic balls, {:?}", $method),
            KINDS,
            numbers(),
            [true, true, true, false, true, true],
            7,
            $method,
            $steps,
            $h,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let first = ElasticHinge::rotary(vector(29)).damped_about(vector(32)).resting_at(vector(35));
                let second = ElasticHinge::rotary(vector(38)).damped(x(41));
                let plain = ElasticHinge::rotary(vector(38));
                let arm = Branch((Ball, of(1)));
                let hinge = Revolute::about(vector(42));
                let rod = Rod::new(x(45), x(45), x(45), x(45) * x(45), x(45));
                let chain = (first, of(0), arm, second, of(1), hinge, of(0), Ball, rod, plain, of(1));
                System::new(Clamped::at(vector(46), Rotation::identity()), chain, Free)
                    .unwrap()
                    .with_gravity(vector(26))
            },
            under(6, |y| { Medium::of(y, 49) })
        )
    };
}

#[test]
fn elastic_balls_have_the_gradients_of_jets() {
    chains!(Rk4, 3, 0.04);
}

/// By rules whose pivots know springs.
#[test]
fn elastic_balls_have_the_gradients_of_jets_by_implicit_rules() {
    with_room(|| {
        chains!(Sdirk4::new(), 2, 0.03);
        chains!(GeneralizedAlpha::new(0.8), 3, 0.02);
        chains!(GeneralizedAlpha::new(0.8).with_sweeps(3), 2, 0.02);
    });
}

/// In both arms of a loop, and before a tip that is held.
macro_rules! closed {
    ($method:expr, $steps:expr, $h:expr) => {
        gradients!(
            &format!("elastic balls in a loop, {:?}", $method),
            KINDS,
            numbers(),
            [true, true, true, true, true, false],
            8,
            $method,
            $steps,
            $h,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let first = ElasticHinge::rotary(vector(29)).damped_about(vector(32)).resting_at(vector(35));
                let second = ElasticHinge::rotary(vector(38)).damped(x(41));
                let network = Network::new((first, of(0), Ball, of(1)), (second, of(1)), Ball);
                let rod = Rod::new(x(45), x(45), x(45), x(45) * x(45), x(45));
                let chain = (of(1), network, first, of(0), second, of(1), Revolute::about(vector(42)), rod);
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::identity());
                System::new(root, chain, Pinned::at(vector(46))).unwrap().with_gravity(vector(26))
            },
            under(6, |y| { Medium::of(y, 49) })
        )
    };
}

#[test]
fn elastic_balls_in_closed_scenes_have_the_gradients_of_jets() {
    closed!(Rk4, 2, 0.02);
}

#[test]
fn elastic_balls_in_closed_scenes_have_the_gradients_of_jets_by_implicit_rules() {
    with_room(|| {
        closed!(Sdirk4::new(), 2, 0.02);
        closed!(GeneralizedAlpha::new(0.8), 2, 0.02);
        closed!(GeneralizedAlpha::new(0.8).with_sweeps(1), 2, 0.02);
    });
}

/// A spring that grows with the square of the angle, and a damper with that of the rate.
#[derive(Clone, Copy, Debug)]
struct Hardening<T>(T, T);

impl<T: Scalar<Real = f64>> RotaryLaw<T> for Hardening<T> {
    fn torque(&self, position: &Rotation<T>, rate: &[T; 3]) -> Vector3<T> {
        let (angle, rate) = (Vector3::from(position.log()), Vector3::from(*rate));
        let square = |v: Vector3<T>| v.x * v.x + v.y * v.y + v.z * v.z;
        angle * (-self.0 * (T::constant(1.0) + square(angle))) - rate * (self.1 * square(rate))
    }
    fn pivot(
        &self,
        position: &Rotation<T>,
        rate: &[T; 3],
        springs: catena::extend::Implicit<f64>,
    ) -> catena::spatial::Symmetric3<T> {
        let square = |v: [T; 3]| v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        let stiffness = self.0 * (T::constant(1.0) + square(position.log()));
        let pivot = stiffness.scale(springs.position) + (self.1 * square(*rate)).scale(springs.rate);
        catena::spatial::Symmetric3::of_diagonal(Vector3::repeat(pivot))
    }
    fn energy(&self, _: &Rotation<T>) -> T {
        T::constant(0.0)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Hardening<T> {
    type Over = Hardening<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Hardening<U> {
        Hardening(number(self.0), number(self.1))
    }
}

/// A law of the user's own goes backward by itself, also where implicit rules read it where accelerations have led.
macro_rules! hardening {
    ($method:expr, $steps:expr, $h:expr) => {{
        let mut parameters = bodies(2);
        parameters.extend([4.0, 0.7]);
        gradients!(
            &format!("own rotary laws, {:?}", $method),
            &[("bodies", 26), ("gravity", 3), ("law", 2)],
            parameters,
            [true, true],
            3,
            $method,
            $steps,
            $h,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let joint = ElasticHinge::with(Hardening(x(29), x(30)));
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::identity());
                let gravity = [0, 1, 2].map(|k| x(26 + k));
                System::new(root, (joint, of(0), joint, of(1)), Free).unwrap().with_gravity(gravity)
            }
        )
    }};
}

#[test]
fn rotary_laws_of_ones_own_have_the_gradients_of_jets() {
    hardening!(Dop853, 2, 0.05);
    hardening!(Sdirk4::new(), 2, 0.04);
    hardening!(GeneralizedAlpha::new(0.8), 3, 0.03);
}

/// At rest, straight, without a turn: where rotation vectors are zero.
#[test]
fn gradients_at_rest_are_numbers() {
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let joint = ElasticHinge::rotary([20.0, 5.0, 20.0]).damped(0.01);
    let scene = System::new(Clamped::origin(), (joint, rod, joint, rod), Free).unwrap();
    let start = scene.motion();
    let (mut backward, mut states) = (scene.backward(Rk4), vec![start; 11]);
    backward.run(&start, 0.01, 10, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0; 6], &[1.0; 6])).unwrap();
    let all: Vec<f64> = gradient.by_position().into_iter().chain(gradient.by_rate()).collect();
    assert!(all.iter().all(|x| x.is_finite()) && all.iter().any(|x| *x != 0.0), "{all:?}");
}

/// A rotary law of ten numbers is refused.
#[test]
fn rotary_laws_have_nine_numbers_or_less() {
    #[derive(Clone, Copy, Debug)]
    struct Many<T>([T; 10]);
    impl<T: Scalar<Real = f64>> RotaryLaw<T> for Many<T> {
        fn torque(&self, position: &Rotation<T>, _: &[T; 3]) -> Vector3<T> {
            Vector3::from(position.log()) * -self.0[9]
        }
        fn pivot(
            &self,
            _: &Rotation<T>,
            _: &[T; 3],
            _: catena::extend::Implicit<f64>,
        ) -> catena::spatial::Symmetric3<T> {
            catena::spatial::Symmetric3::of_diagonal(Vector3::repeat(self.0[9]))
        }
        fn energy(&self, _: &Rotation<T>) -> T {
            T::constant(0.0)
        }
        fn check(&self) -> Result<(), Fault> {
            Ok(())
        }
    }
    impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Many<T> {
        type Over = Many<U>;
        fn lift(&self, number: &mut impl FnMut(T) -> U) -> Many<U> {
            Many(self.0.map(number))
        }
    }
    macro_rules! scene {
        ($number:expr) => {{
            let ground = Clamped::at([0.0; 3].map($number), Rotation::from_angles([0.0; 3].map($number)));
            let rod = Rod::new($number(0.5), $number(1.0), $number(0.25), $number(0.02), $number(0.05));
            System::new(ground, (ElasticHinge::with(Many([$number(2.0); 10])), rod), Free).unwrap()
        }};
    }
    let scene = scene!(|x: f64| x);
    let start = scene.motion();
    let (mut backward, mut states) = (scene.backward(Rk4), [start; 2]);
    backward.run(&start, 0.01, 1, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0; 3], &[0.0; 3])).unwrap();
    let fault = gradient.along(&scene!(Jet::<f64, 8>::of)).unwrap_err().fault;
    assert!(matches!(fault, Fault::Count { expected: 9, given: 10, .. }), "{fault:?}");
}
