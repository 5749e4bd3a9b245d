//! Gradients through joints with coordinates of their own: hinges with springs, dampers and laws, joints that slide.

use super::names::*;
use catena::{Fault, Real};

/// A spring that stiffens, with a damper: −k (φ + s φ³) − c φ̇.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stiffening<T> {
    pub(super) stiffness: T,
    pub(super) growth: T,
    pub(super) damping: T,
}
catena::lift!(Stiffening<T> { stiffness, growth, damping });

impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
    const LINEAR: bool = false;

    fn force(&self, position: T, rate: T) -> T {
        let Self { stiffness, growth, damping } = *self;
        -(stiffness * (position + growth * position * position * position)) - damping * rate
    }
    fn energy(&self, position: T) -> T {
        let square = position * position;
        self.stiffness * (square.scale(T::Real::of(0.5)) + (self.growth * square * square).scale(T::Real::of(0.25)))
    }
    fn pivot(&self, position: T, _: T, springs: impl Springs<T>) -> T {
        let three = T::one() + T::one() + T::one();
        springs.pivot(self.stiffness * (T::one() + three * self.growth * position * position), self.damping)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Hinges between, before and behind pins and welds, in an arm and on a clamped root: springs, dampers, rest angles, a law of the user's
/// own, and a hinge without any.
#[test]
fn hinges_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (8, 7, 9);
    let mut noise = Noise::new(15);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([12.0, 0.3, 0.4, 5.0, 0.2, 0.7, 20.0, -0.3]); // springs, dampers, rest angles
    list.extend([8.0, 0.5, 0.1]); // a law
    list.extend([0.3, 0.2, 9.81]); // a weld, the root, gravity
    assert_eq!(list.len(), 24);
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let kinds = [
        ("bodies", 10),
        ("springs", 8),
        ("law", 3),
        ("weld and root", 2),
        ("gravity", 1),
        ("coordinates", coordinates),
        ("rates", coordinates),
        ("torques", steps * joints),
    ];
    gradients!("hinges", &kinds, list, [coordinates, joints], Rk4, steps, 0.02, |x| {
        let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
        let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
        let full = ElasticHinge::rotary(x(10)).damped(x(11)).resting_at(x(12));
        let damped = ElasticHinge::rotary(x(13)).damped(x(14));
        let resting = ElasticHinge::rotary(x(16)).resting_at(x(17));
        let own = ElasticHinge::with(Stiffening { stiffness: x(18), growth: x(19), damping: x(20) });
        let arm = (damped, rigid, Pin, rod, ElasticHinge::rotary(x(15)), rod);
        let chain = (full, rigid, Branch(arm), Pin, rod, Weld::at(x(21)), rigid, own, rod, resting, rod);
        let root = Clamped::at(N::constant(0.2), N::constant(0.1), x(22));
        System::new(root, chain, Free).unwrap().with_gravity(x(23))
    });
}

/// A cart on a slope with a pendulum, a slider on a hinge, one at a tip, one in an arm: directions, springs, point masses lumped at them.
#[test]
fn sliders_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (8, 7, 8);
    let mut noise = Noise::new(16);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2]; // a rod and a rigid body
    list.extend([0.2, -0.4, 1.1, 0.5]); // directions
    list.extend([30.0, 1.5, 0.3, 40.0, 0.6, 15.0]); // springs, dampers, rest values
    list.push(9.81);
    assert_eq!(list.len(), 21);
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let kinds = [
        ("bodies", 10),
        ("directions", 4),
        ("springs", 6),
        ("gravity", 1),
        ("coordinates", coordinates),
        ("rates", coordinates),
        ("efforts", steps * joints),
    ];
    gradients!("sliders", &kinds, list, [coordinates, joints], Rk4, steps, 0.02, |x| {
        let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
        let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
        let track = Slider::along(x(10)).with(Spring::new(x(14)).damped(x(15)).resting_at(x(16)));
        let piston = Slider::along(x(11)).with(Spring::new(x(17)).damped(x(18)));
        let hinge = ElasticHinge::rotary(x(19));
        let chain = (
            track,
            rigid,
            Pin,
            rod,
            Branch((Slider::along(x(13)), rod)),
            piston,
            rod,
            hinge,
            rigid,
            Slider::along(x(12)).with(Spring::damping(x(15))),
            rod,
            Pin,
            rod,
        );
        System::new(Clamped::at(N::constant(0.2), N::constant(0.1), N::constant(0.3)), chain, Free)
            .unwrap()
            .with_gravity(x(20))
    });
}

/// A joint of more numbers than gradients keep says so, once they are asked for.
#[test]
fn a_joint_has_six_numbers_or_less() {
    #[derive(Clone, Copy, Debug)]
    struct Many<T>([T; 7]);
    impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Many<T> {
        type Over = Many<U>;
        fn lift(&self, number: &mut impl FnMut(T) -> U) -> Many<U> {
            Many(self.0.map(number))
        }
    }
    impl<T: Scalar> SpringLaw<T> for Many<T> {
        fn force(&self, position: T, _: T) -> T {
            self.0.iter().fold(T::zero(), |sum, k| sum - *k * position)
        }
        fn energy(&self, _: T) -> T {
            T::zero()
        }
        fn pivot(&self, _: T, _: T, _: impl Springs<T>) -> T {
            T::zero()
        }
        fn check(&self) -> Result<(), Fault> {
            Ok(())
        }
    }
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, ElasticHinge::with(Many([1.0; 7])), rod), Free).unwrap();
    let mut states = [system.at_rest(&[0.0, 0.5]).unwrap(); 2];
    let (start, mut backward) = (states[0], system.backward(Rk4));
    backward.run(&start, 0.1, 1, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0, 0.0], &[0.0; 2])).unwrap();
    let found = gradient.along(&system.lift(Jet::<f64, 1>::of)).unwrap_err().fault;
    assert!(matches!(found, Fault::Count { expected: 6, given: 7, .. }), "{found:?}");
}
