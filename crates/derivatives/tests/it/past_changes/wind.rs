//! Under a law of loads on bodies, by its own numbers, too: against a closed form where friction breaks away, and against runs over jets.

use super::{WIDTH, hanging};
use catena::loading::LoadLaw;
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::{Error, Lift, spatial};
use catena_oracle::{derivative, near};
use std::f64::consts::FRAC_PI_2;

/// A wind on the outboard end of each body, which resists and pushes, the more the later it is.
#[derive(Clone, Copy)]
struct Wind<T> {
    drag: T,
    push: [T; 2],
    pace: T,
}
catena::lift!(Wind<T> { drag, push, pace });

impl<T: Scalar> Wind<T> {
    /// Of the first numbers of a list.
    fn of(x: &[T]) -> Self {
        Self { drag: x[0], push: [x[1], x[2]], pace: x[3] }
    }
    /// The force on what moves like this.
    fn force(&self, time: T::Real, velocity: [T; 2]) -> [T; 2] {
        let growth = T::one() + self.pace.scale(time);
        [0, 1].map(|k| self.push[k] * growth - self.drag * velocity[k])
    }
}

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Wind<T> {
    type Value = Wrench<T>;
    fn at(&self, time: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        motion.force_at([T::literal(0.4), T::zero()], self.force(time, motion.outboard().velocity.into()))
    }
}

impl<T: Scalar> LoadLaw<spatial::BodyMotion<T>> for Wind<T> {
    type Value = spatial::Wrench<T>;
    fn at(&self, time: T::Real, _: usize, motion: &spatial::BodyMotion<T>) -> spatial::Wrench<T> {
        let velocity = motion.outboard().velocity;
        let [x, y] = self.force(time, [velocity.x, velocity.y]);
        motion.force_at([T::literal(0.1), T::zero(), T::literal(-0.2)], [x, y, -(self.drag * velocity.z)])
    }
}

#[test]
fn blocks_and_arms_in_a_wind() -> Result<(), Error> {
    let wind = [0.3, -0.4, 0.2, 0.5];
    let falling = [wind.to_vec(), vec![1.0, 0.7, 9.81]].concat();
    let changes = as_forward_under!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-9, falling, |x, T| {
        let of = <T as Scalar>::literal;
        let block = RigidBody::new(of(2.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
        let slide = HardStops::between(Slider::along(of(FRAC_PI_2)), [of(0.0), of(f64::INFINITY)]).rebounding(x[5]);
        let scene = System::new(Clamped::origin(), (slide, block), Free)?.with_gravity(x[6]);
        let mut start = scene.motion();
        start.set_coordinates(&[x[4]])?;
        (scene, start, Wind::of(x))
    });
    assert!(changes > 2, "{changes}");
    let arm = [wind.to_vec(), vec![0.8, 1.0, 0.3, 0.8, 9.81, -0.2, 0.9]].concat();
    let changes = as_forward_under!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, arm, |x, T| {
        let rod = Rod::uniform(x[4], x[5]);
        let shoulder = Coulomb::new(Revolute::smooth(), x[6]).breaking_away(x[6] * T::literal(1.5));
        let elbow = HardStops::between(Revolute::smooth(), [T::literal(0.0), T::literal(FRAC_PI_2)]).rebounding(x[7]);
        let scene = System::new(Clamped::origin(), (shoulder, rod, elbow, rod), Free)?.with_gravity(x[8]);
        let mut start = scene.motion();
        start.set_coordinates(&x[9..])?;
        (scene, start, Wind::of(x))
    });
    assert!(changes > 3, "{changes}");
    Ok(())
}

/// A block that sticks until the wind, which grows, breaks it away: when that is hangs on the wind alone.
#[test]
fn a_block_that_a_wind_breaks_away() -> Result<(), Error> {
    const END: f64 = 1.7;
    // Mass, friction, by how much more it breaks away, and the wind: what pushes, and how fast it grows.
    let at = [2.0, 5.0, 1.3, 4.0, 0.9];
    let closed = |[mass, sliding, more, push, pace]: [f64; 5]| {
        let from = (sliding * more / push - 1.0) / pace;
        let time = END - from;
        // Of a force that has grown to more than slides by then, and grows on.
        ((sliding * (more - 1.0)) * time * time / 2.0 + push * pace * time.powi(3) / 6.0) / mass
    };
    macro_rules! pushed {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
            let block = RigidBody::new(x[0], of(0.1), [of(0.0); 2], [of(0.0); 2]);
            let rail = Coulomb::new(Slider::along(of(0.0)), x[1]).breaking_away(x[1] * x[2]);
            let scene = System::new(Clamped::origin(), (rail, block), Free)?;
            let start = scene.motion();
            (scene, start, Wind { drag: of(0.0), push: [x[3], of(0.0)], pace: x[4] })
        }};
    }
    let changes = as_forward_under!(Dop853::tolerance(1e-12), Dop853, END, 1e-9, at, |x, T| pushed!(x, T));
    assert_eq!(changes, 2); // it begins, and breaks away once
    let (scene, start, law) = pushed!(&at, f64);
    let mut backward = scene.backward(Dop853).under(law);
    let course = backward.course(&start, Dop853::tolerance(1e-12), END, &[])?;
    let last = course.states().len() - 1;
    near(course.states()[last].coordinates()[0], closed(at), 1e-10);
    let gradient = backward
        .gradient_past(&course, &mut [], |step, _, by| if step == last { by.add(&[1.0], &[0.0]) } else { Ok(()) })?;
    let along = gradient.along(&pushed!(&[0, 1, 2, 3, 4].map(|k| Jet::<f64, 5>::seed(at[k], k)), Jet<f64, 5>).0)?;
    let [_, by_push, _, by_pace] = gradient.by_loads()?[..] else { unreachable!() };
    for (k, found) in [along[0], along[1], along[2], by_push, by_pace].into_iter().enumerate() {
        let moved = |by: f64| {
            let mut other = at;
            other[k] += by;
            closed(other)
        };
        let expected = derivative(1e-3, moved);
        println!("{k}: {found} {expected}");
        near(found, expected, 1e-8 * (1.0 + expected.abs()));
    }
    Ok(())
}

#[test]
fn an_arm_in_space_in_a_wind() -> Result<(), Error> {
    use spatial::{Ball, Coulomb, Free, HardStops, Pinned, Revolute, System};
    let numbers = [0.3, -0.4, 0.2, 0.5, 0.9, 0.02, -0.3, 0.5, 0.6, 0.1, -9.81];
    let changes = as_forward_under!(Dop853::tolerance(1e-11), Dop853, 0.8, 1e-8, numbers, |x, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let body = hanging(x[4], [x[5], of(0.03), of(0.01)]);
        let elbow = HardStops::between(Revolute::about([of(1.0), zero, zero]), [x[6], x[7]]).rebounding(x[8]);
        let wrist = Coulomb::new(Revolute::about([zero, of(1.0), zero]), x[9]).breaking_away(x[9] * of(1.3));
        let scene = System::new(Pinned::origin(), (body, elbow, body, Ball, body, wrist, body), Free)?;
        let scene = scene.with_gravity([zero, zero, x[10]]);
        let rates = [0.3, 0.5, 0.2, 2.0, 0.1, 0.2, 0.3, 1.5].map(of);
        let start = scene.with_rates(scene.motion(), &rates)?;
        (scene, start, Wind::of(x))
    });
    assert!(changes > 2, "{changes}");
    Ok(())
}
