//! Gradients of runs under force elements: against the same steps, by all that scene, law and start are made of.

use super::over_jets::WIDTH;
use crate::drag::Drag;
use catena::loading::ForceLaw;
use catena::planar::*;
use catena::scalar::Scalar;
use catena::{Error, Fault, robot, spatial};

/// A muscle along points of three bodies, excited over time: as strong as it is long, less as it shortens.
#[derive(Clone, Copy)]
struct Muscle<T> {
    points: [[T; 2]; 3],
    stiffness: T,
    damping: T,
    length: T,
    excitation: [T; 3],
}
catena::lift!(Muscle { points, stiffness, damping, length, excitation });

impl<T: Scalar<Real = f64>> Muscle<T> {
    fn of(x: &[T]) -> Self {
        let points = [[x[0], x[1]], [x[2], x[3]], [x[4], x[5]]];
        Self { points, stiffness: x[6], damping: x[7], length: x[8], excitation: [x[9], x[10], x[11]] }
    }

    /// Forces on the points, by their places and velocities.
    fn pull<const D: usize>(&self, time: f64, ends: [[[T; D]; 2]; 3]) -> [[T; D]; 3] {
        let dot = |a: [T; D], b: [T; D]| (0..D).fold(T::zero(), |sum, i| sum + a[i] * b[i]);
        let part = |k: usize, i: usize| -> [T; D] { core::array::from_fn(|j| ends[k + 1][i][j] - ends[k][i][j]) };
        let (mut length, mut rate, mut along) = (T::zero(), T::zero(), [[T::zero(); D]; 2]);
        for (k, along) in along.iter_mut().enumerate() {
            let apart = part(k, 0);
            let distance = dot(apart, apart).sqrt();
            *along = apart.map(|x| x / distance);
            (length, rate) = (length + distance, rate + dot(*along, part(k, 1)));
        }
        let [level, swing, pace] = self.excitation;
        let excited = level + swing * (pace * T::literal(time)).sin_cos().0;
        let force = excited * self.stiffness * (length - self.length) + self.damping * rate;
        let [a, b] = along.map(|along| along.map(|x| x * force));
        [a, core::array::from_fn(|i| b[i] - a[i]), b.map(|x| -x)]
    }
}

impl<T: Scalar<Real = f64>> ForceLaw<Planar<T>, 3> for Muscle<T> {
    fn loads(&self, time: f64, bodies: &[BodyMotion<T>; 3]) -> [Wrench<T>; 3] {
        let ends = core::array::from_fn(|k| {
            let point = bodies[k].point(self.points[k]);
            [point.place.into(), point.velocity.into()]
        });
        let forces = self.pull(time, ends);
        core::array::from_fn(|k| bodies[k].force_at(self.points[k], forces[k]))
    }
}

/// In space the points are out of the plane, and a couple twists the last body against the first as it is turned.
impl<T: Scalar<Real = f64>> ForceLaw<spatial::Spatial<T>, 3> for Muscle<T> {
    fn loads(&self, time: f64, bodies: &[spatial::BodyMotion<T>; 3]) -> [spatial::Wrench<T>; 3] {
        let at = self.points.map(|[x, y]| [y, x, T::literal(0.07)]);
        let ends = core::array::from_fn(|k| {
            let point = bodies[k].point(at[k]);
            [point.place.into(), point.velocity.into()]
        });
        let forces = self.pull(time, ends);
        let mut loads: [spatial::Wrench<T>; 3] = core::array::from_fn(|k| bodies[k].force_at(at[k], forces[k]));
        let twist = bodies[2].inboard.turn.spin * self.damping;
        (loads[0].torque, loads[2].torque) = (loads[0].torque + twist, loads[2].torque - twist);
        loads
    }
}

const MUSCLE: [f64; 12] = [0.4, 0.1, 0.3, -0.2, 0.5, 0.1, 30.0, 1.2, 0.9, 0.8, 0.5, 9.0];

fn sum<const N: usize>(lists: [[f64; WIDTH]; N]) -> [f64; WIDTH] {
    core::array::from_fn(|k| lists.iter().map(|list| list[k]).sum())
}

#[test]
fn a_muscle_along_an_arm() -> Result<(), Error> {
    macro_rules! arm {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
            let (law, x) = (Muscle::of(x), &x[MUSCLE.len()..]);
            let (rod, body) =
                (Rod::uniform(x[0], x[1]), RigidBody::new(x[2], of(0.1), [of(0.3), of(0.1)], [x[3], of(0.2)]));
            let root = Pinned::at(of(0.0), of(0.1));
            let scene = System::new(root, (rod, ElasticHinge::rotary(x[4]), body, Pin, rod), Free)?.with_gravity(x[5]);
            let start = scene.at_rest(&[x[6], of(-0.5), of(0.3)])?;
            let element = ForceElement::by([0, 1, 2], law).and(Loads::none().on_bodies_by(Drag { drag: x[7] }));
            (scene, start, element, (law, x[7]))
        }};
    }
    let numbers = [&MUSCLE[..], &[0.8, 1.2, 0.9, 0.7, 4.0, 9.81, -0.9, 0.1]].concat();
    macro_rules! by {
        ($rule:expr, $h:expr, $steps:expr) => {
            as_jets!($rule, $h, $steps, numbers, arm, |gradient, parts| {
                let [by_drag] = *gradient.by_loads()? else { unreachable!() };
                sum([gradient.along_force(&parts.0), parts.1.eps.map(|slope: f64| by_drag * slope)])
            })
        };
    }
    by!(Rk4, 0.02, 10);
    by!(Dop853, 0.05, 3);
    by!(Sdirk4::new(), 0.02, 4);
    by!(GeneralizedAlpha::new(0.8), 0.02, 5);
    Ok(())
}

#[test]
fn a_muscle_around_a_loop_on_gears() -> Result<(), Error> {
    macro_rules! bars {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
            let (law, x) = (Muscle::of(x), &x[MUSCLE.len()..]);
            let (bar, j) = (
                |k: usize| RigidBody::new(x[k], of(0.05), [of(0.4), of(0.05)], [of(0.8), of(0.0)]),
                Revolute::smooth(),
            );
            let chain = (j, bar(0), j, bar(1), j, bar(0), j.named("last"), bar(1));
            let root = Clamped::at(of(0.0), of(0.1), of(0.2));
            let scene = System::new(root, chain, Pinned::at(x[2], of(0.2)))?.with_gravity(of(9.81));
            let couplings = Couplings::of(&scene, [Coupling::new("last", 2).ratio(x[3]).offset(of(-0.3))])?;
            let mut guess = scene.motion();
            guess.set_coordinates(&[x[4], of(0.42), of(-1.96), of(-0.6)])?;
            let start = scene.assembled(couplings.joined(guess), &couplings)?;
            let loads = couplings.and(ForceElement::by([0, 3, 1], law));
            (scene, start, loads, (law, couplings))
        }};
    }
    let numbers = [&MUSCLE[..], &[1.0, 1.2, 1.6, -0.7, 0.92]].concat();
    as_jets!(Rk4, 0.02, 6, numbers, bars, |gradient, parts| {
        sum([gradient.along_force(&parts.0), gradient.along_couplings(&parts.1)])
    });
    as_jets!(Sdirk4::new(), 0.02, 4, numbers, bars, |gradient, parts| {
        sum([gradient.along_force(&parts.0), gradient.along_couplings(&parts.1)])
    });
    Ok(())
}

#[test]
fn a_muscle_in_space() -> Result<(), Error> {
    use spatial::{Ball, Free, Pinned, Revolute, RigidBody, System};
    macro_rules! arm {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
            let (law, x, zero) = (Muscle::of(x), &x[MUSCLE.len()..], of(0.0));
            let tensor = [[x[0], zero, zero], [zero, of(0.05), zero], [zero, zero, of(0.03)]];
            let body = RigidBody::new(x[1], tensor, [zero, of(0.1), of(-0.2)], [of(0.1), zero, x[2]]);
            let hinge = Revolute::about([of(0.6), of(0.8), zero]);
            let scene = System::new(Pinned::origin(), (body, hinge, body, Ball, body), Free)?.with_gravity([
                of(0.2),
                zero,
                x[3],
            ]);
            let rates = [0.3, 0.5, -0.2, 1.0, 0.4, 0.2, -0.5].map(of);
            let start = scene.with_rates(scene.motion(), &rates)?;
            (scene, start, spatial::ForceElement::by([0, 1, 2], law), law)
        }};
    }
    let numbers = [&MUSCLE[..], &[0.04, 1.1, -0.4, -9.81]].concat();
    as_jets!(Rk4, 0.02, 6, numbers, arm, |gradient, law| gradient.along_force(&law));
    Ok(())
}

#[test]
fn a_muscle_of_a_robot() -> Result<(), Error> {
    use robot::{Base, Hinge, Link, Quarter, System};
    macro_rules! arm {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
            let (law, x) = (Muscle::of(x), &x[MUSCLE.len()..]);
            let tensor = [[0.06, 0.002, 0.0], [0.002, 0.05, 0.001], [0.0, 0.001, 0.02]].map(|row| row.map(of));
            let link = Link::general(x[0], [of(0.02), of(0.01), x[1]], tensor);
            let hinge = Hinge::at::<0b111>([of(0.05), of(-0.02), x[2]]).turned(Quarter::<30>);
            let chain = (Hinge::level().grounded(), link, hinge, link, hinge, link);
            let scene = System::new(Base::origin(), chain, spatial::Free)?.with_gravity([of(0.3), of(-0.2), x[3]]);
            let mut start = scene.motion();
            start.set_coordinates(&[of(0.2), x[4], of(-0.8)])?;
            start.set_rates(&[of(0.5), of(-1.0), of(0.7)])?;
            (scene, start, robot::ForceElement::by([0, 1, 2], law), law)
        }};
    }
    let numbers = [&MUSCLE[..], &[1.1, 0.2, 0.4, -9.81, 0.5]].concat();
    as_jets!(Rk4, 0.02, 6, numbers, arm, |gradient, law| gradient.along_force(&law));
    Ok(())
}

/// More numbers than costates have room for.
#[test]
fn laws_of_too_many_numbers_are_refused() -> Result<(), Error> {
    #[derive(Clone, Copy)]
    struct Long<T> {
        numbers: [T; 33],
    }
    catena::lift!(Long { numbers });
    impl<T: Scalar<Real = f64>> ForceLaw<Planar<T>, 1> for Long<T> {
        fn loads(&self, _: f64, _: &[BodyMotion<T>; 1]) -> [Wrench<T>; 1] {
            [Wrench::torque(self.numbers[32])]
        }
    }
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?;
    let mut states = [scene.at_rest(&[-1.0])?; 3];
    let (start, element) = (states[0], ForceElement::by([0], Long { numbers: [0.1; 33] }));
    let mut backward = scene.backward(Rk4).under(element);
    backward.run(&start, 0.01, 2, &[], &mut states)?;
    let fault = backward.gradient(&[], &states, &mut [], |_, _, _| Ok(())).map(|_| ()).map_err(|error| error.fault);
    assert!(matches!(fault, Err(Fault::Count { expected: 32, given: 33, .. })), "{fault:?}");
    Ok(())
}
