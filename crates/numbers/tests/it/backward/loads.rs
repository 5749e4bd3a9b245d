//! Gradients of runs under loads on bodies that depend on the motion.

use super::names::*;
use catena::Real;
use catena::loading::LoadLaw;

/// Drag at the outboard ends of all bodies, −c |v| v, a spring from the mass centre of every second one to a point, and a torque that brakes
/// turning, −b ω³, and slackens with time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Medium<T> {
    pub(super) drag: T,
    pub(super) stiffness: T,
    pub(super) anchor: [T; 2],
    pub(super) brake: T,
}
catena::lift!(Medium<T> { drag, stiffness, anchor, brake });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Medium<T> {
    type Value = Wrench<T>;

    fn at(&self, time: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let v = motion.outboard().velocity;
        let speed = (v.x * v.x + v.y * v.y).sqrt();
        let drag = v * -(self.drag * speed);
        let spring = match body % 2 {
            0 => v * T::zero(),
            _ => (motion.centre().place - catena::nalgebra::Vector2::from(self.anchor)) * -self.stiffness,
        };
        let cross = |d: catena::nalgebra::Vector2<T>, f: catena::nalgebra::Vector2<T>| d.x * f.y - d.y * f.x;
        let slack = T::Real::of(1.0) / (T::Real::of(1.0) + time);
        let brake = -(self.brake * motion.rate() * motion.rate() * motion.rate()).scale(slack);
        Wrench { force: drag + spring, torque: cross(motion.arm, drag) + cross(motion.to_centre, spring) + brake }
    }
}

/// All bodies and joints, an arm, a clamped root at a place: by all of it, and by the numbers of the law.
#[test]
fn loads_that_read_the_motion_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (6, 6, 8);
    let mut noise = Noise::new(17);
    let mut list = TREE.to_vec();
    list.extend([0.4, 7.0, 0.5, 0.8, 0.05]); // the law
    assert_eq!(list.len(), 27);
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let mut kinds = OF_TREE.to_vec();
    kinds.extend([("law", 5), ("coordinates", coordinates), ("rates", coordinates), ("efforts", steps * joints)]);
    gradients!(
        "loads",
        &kinds,
        list,
        [coordinates, joints],
        Rk4,
        steps,
        0.02,
        |x| { tree!(N, x) },
        under(5, |x| { Medium { drag: x(22), stiffness: x(23), anchor: [x(24), x(25)], brake: x(26) } })
    );
}

/// A law of more numbers than gradients keep says so, once they are asked for.
#[test]
fn a_law_of_loads_has_six_numbers_or_less() {
    #[derive(Clone, Copy, Debug)]
    struct Many<T>([T; 7]);
    impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Many<T> {
        type Over = Many<U>;
        fn lift(&self, number: &mut impl FnMut(T) -> U) -> Many<U> {
            Many(self.0.map(number))
        }
    }
    impl<T: Scalar> LoadLaw<BodyMotion<T>> for Many<T> {
        type Value = Wrench<T>;
        fn at(&self, _: T::Real, _: usize, _: &BodyMotion<T>) -> Wrench<T> {
            Wrench::torque(self.0[6])
        }
    }
    let system = System::new(Pinned::origin(), (Rod::uniform(1.0_f64, 1.0),), Free).unwrap();
    let mut states = [system.at_rest(&[0.0]).unwrap(); 2];
    let (start, mut backward) = (states[0], system.backward(Rk4).under(Many([1.0; 7])));
    backward.run(&start, 0.1, 1, &[], &mut states).unwrap();
    let gradient = backward.gradient(&[], &states, &mut [], |_, _, by| by.add(&[1.0], &[0.0])).unwrap();
    let found = gradient.by_loads().unwrap_err().fault;
    assert!(matches!(found, catena::Fault::Count { expected: 6, given: 7, .. }), "{found:?}");
}
