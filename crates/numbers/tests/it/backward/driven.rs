//! Gradients through joints that are driven, by all numbers of their laws: in chains, arms, behind hinges and slides, under loads that see
//! the motion, by implicit rules, to held tips and around loops.

use super::names::*;

/// Around an offset to and fro, and on: b + u t + a sin (ω t + φ).
#[derive(Clone, Copy)]
pub(super) struct Swing<T> {
    pub(super) offset: T,
    pub(super) drift: T,
    pub(super) amplitude: T,
    pub(super) frequency: T,
}
catena::lift!(Swing { offset, drift, amplitude, frequency });

impl<T: Scalar<Real = f64>> MotionLaw<T> for Swing<T> {
    fn at(&self, time: f64) -> [T; 3] {
        let Self { offset, drift, amplitude: a, frequency: w } = *self;
        let (sine, cosine) = (w.scale(time) + T::constant(0.3)).sin_cos();
        [offset + drift.scale(time) + a * sine, drift + a * w * cosine, -(a * w * w * sine)]
    }
}

/// Numbers of a rod, a rigid body and a bob.
const BODIES: [f64; 12] = [1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2, 0.6, 0.9];
/// Numbers of a law.
const LAW: [f64; 4] = [0.4, -0.7, 0.5, 3.1];

/// Cranks at the root, in an arm and behind a hinge, a line that is driven, of a direction, and pins, hinges and slides that are not.
macro_rules! driven {
    ($x:expr, $N:ty) => {{
        let x = $x;
        let rod = Rod::<$N>::new(x(0), x(1), x(2), x(3));
        let rigid = RigidBody::<$N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
        let bob = PointMass::<$N>::new(x(10), x(11));
        let law = |k: usize| Swing { offset: x(k), drift: x(k + 1), amplitude: x(k + 2), frequency: x(k + 3) };
        let crank = Driven::new(Revolute::smooth(), law(12));
        let turning = Driven::new(Revolute::smooth(), law(16));
        let line = Driven::new(Slider::along(x(20)), law(21));
        let hinge = ElasticHinge::rotary(x(25)).damped(x(26));
        let piston = Slider::along(x(27));
        let arm = (turning, rod, hinge, bob);
        let chain = (
            crank,
            rigid,
            Branch(arm),
            hinge,
            rod,
            piston,
            rigid,
            turning,
            rod,
            line,
            bob,
            Weld::at(x(28)),
            rod,
            Pin,
            bob,
        );
        System::new(Clamped::at(x(29), x(30), x(31)), chain, Free).unwrap().with_gravity(x(32))
    }};
}

/// The numbers of that scene, and what they are.
fn numbers() -> Vec<f64> {
    let mut list = BODIES.to_vec();
    list.extend(LAW);
    list.extend([-0.3, 0.4, 0.6, 2.2]);
    list.extend([0.5, 0.2, 0.1, 0.3, 4.0]);
    list.extend([12.0, 0.3, -0.4, 0.3]);
    list.extend([0.2, 0.1, 0.3, 9.81]);
    list
}
const KINDS: [(&str, usize); 7] = [
    ("bodies", 12),
    ("cranks", 8),
    ("direction of the line", 1),
    ("line", 4),
    ("hinges, slide, weld", 4),
    ("root", 3),
    ("gravity", 1),
];

#[test]
fn driven_joints_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (6, 4, 10);
    let mut list = numbers();
    list.extend(moving(&mut Noise::new(61), coordinates, steps * joints));
    gradients!(
        "driven",
        &with_motion(&KINDS, coordinates, steps * joints),
        list,
        [coordinates, joints],
        Rk4,
        steps,
        0.02,
        |x| { driven!(x, N) }
    );
}

#[test]
fn driven_joints_have_the_gradients_of_jets_by_implicit_rules() {
    let (steps, coordinates, joints) = (4, 4, 10);
    let mut list = numbers();
    list.extend(moving(&mut Noise::new(62), coordinates, steps * joints));
    gradients!(
        "driven, Sdirk4",
        &with_motion(&KINDS, coordinates, steps * joints),
        list.clone(),
        [coordinates, joints],
        Sdirk4::new(),
        steps,
        0.02,
        |x| { driven!(x, N) }
    );
    let method = GeneralizedAlpha::new(0.8);
    gradients!(
        "driven, generalized-alpha",
        &with_motion(&KINDS, coordinates, steps * joints),
        list,
        [coordinates, joints],
        method,
        steps,
        0.02,
        |x| { driven!(x, N) }
    );
}

/// A law of seven numbers, of which costates know six: said, not left out.
#[test]
fn laws_of_motion_have_six_numbers_or_less() -> Result<(), catena::Error> {
    #[derive(Clone, Copy)]
    struct Many<T>([T; 7]);
    impl<T: Scalar<Real = f64>> MotionLaw<T> for Many<T> {
        fn at(&self, time: f64) -> [T; 3] {
            [self.0[6].scale(time), self.0[6], T::constant(0.0)]
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
            let (rod, law) = (Rod::uniform($number(0.5), $number(1.0)), Many([$number(0.7); 7]));
            System::new(Clamped::origin(), (Driven::new(Revolute::smooth(), law), rod, Pin, rod), Free)?
        }};
    }
    let scene = scene!(|x: f64| x);
    let mut states = [scene.at_rest(&[-1.0])?; 2];
    let (mut backward, start) = (scene.backward(Rk4), states[0]);
    backward.run(&start, 0.01, 1, &[], &mut states)?;
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0], &[0.0]))?;
    let fault = gradient.along(&scene!(Jet::<f64, 8>::of)).err().map(|error| error.fault);
    assert!(matches!(fault, Some(catena::Fault::Count { expected: 6, given: 7, .. })), "{fault:?}");
    Ok(())
}
