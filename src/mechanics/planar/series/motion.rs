//! Taylor series in the plane: the motion of a body, as laws of loads see it.

use crate::mechanics::planar::{Acceleration, BodyMotion, Frame, Inertia, Internal, Planar, Turn};
use crate::relation::planar::algebra::{cross, dot};
use crate::scalar::{Elementary, Powers, Scalar};
use crate::series::ExpandBody;
use nalgebra::Vector2;

impl<T: Scalar, const N: usize> ExpandBody<N> for Planar<T> {
    fn body_series(
        start: &BodyMotion<T>,
        accelerations: &[Acceleration<T>],
        gravity: Vector2<T>,
    ) -> BodyMotion<Powers<T, N>> {
        let BodyMotion { inboard, arm, direction, inertia: Inertia { mass, centre, about_centre }, .. } = *start;
        let of = |first: T, slope: &dyn Fn(usize) -> T| {
            Powers::integral(first, Powers::polynomial(accelerations.len(), accelerations.len() + 1, slope))
        };
        let linear = |i: usize| {
            of(inboard.velocity[i], &|k| accelerations[k].linear[i] + if k == 0 { gravity[i] } else { T::zero() })
        };
        let velocity = Vector2::new(linear(0), linear(1));
        let rate = of(inboard.turn.rate, &|k| accelerations[k].angular);
        let angle = Powers::integral(inboard.turn.angle, rate);
        let (sine, cosine) = angle.sin_cos();
        let frame = Frame {
            place: Vector2::new(
                Powers::integral(inboard.place.x, velocity.x),
                Powers::integral(inboard.place.y, velocity.y),
            ),
            velocity,
            turn: Turn { angle, rate },
            acceleration: Acceleration::zero(),
        };
        let mut motion = BodyMotion {
            inboard: frame,
            arm: velocity,
            to_centre: velocity,
            direction: Vector2::new(cosine, sine),
            inertia: Inertia {
                mass: Powers::of(mass),
                centre: centre.map(Powers::of),
                about_centre: Powers::of(about_centre),
            },
        };
        motion.arm = motion.turned([dot(direction, arm), cross(direction, arm)].map(Powers::of));
        motion.to_centre = motion.turned(motion.inertia.centre);
        motion
    }

    fn terms(load: Internal<Powers<T, N>>) -> [Internal<T>; N] {
        let ([x, y], torque) = (<[_; 2]>::from(load.force).map(Powers::terms), load.torque.terms());
        core::array::from_fn(|k| Internal { force: Vector2::new(x[k], y[k]), torque: torque[k] })
    }
}
