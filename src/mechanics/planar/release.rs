//! What joints in the plane let move, and what resists it.

use super::{ElasticHinge, HingeAxes, JointMotion, Linear, Planar, Slider, SpringLaw};
use crate::element::Implicit;
use crate::relation::planar::algebra::normal;
use crate::release::{Freedom, Release, Resistance, Way};
use crate::scalar::Scalar;
use nalgebra::Vector2;
use num_traits::{One, Zero};

/// The coordinate of a law, which turns or slides along an axis.
fn against<T: Scalar>(
    way: Way,
    axis: Vector2<T>,
    law: &impl SpringLaw<T>,
    [position, rate]: [T; 2],
) -> Freedom<Planar<T>> {
    let (zero, one) = (T::Real::zero(), T::Real::one());
    let [stiffness, damping] =
        [(one, zero), (zero, one)].map(|(p, r)| law.pivot(position, rate, Implicit { position: p, rate: r }));
    let resistance = Resistance { force: law.force(position, rate), stiffness, damping };
    Freedom::smooth(way, axis).against(resistance, law.force(T::zero(), T::zero()))
}

/// A turn, which is about ẑ.
fn turn<T: Scalar>(law: &impl SpringLaw<T>, state: [T; 2]) -> Freedom<Planar<T>> {
    against(Way::Turn, Vector2::new(T::zero(), T::zero()), law, state)
}

/// Whatever the coordinate of a pin, which is an absolute angle: nothing resists.
pub(super) fn pin<T: Scalar>() -> Release<Planar<T>> {
    let turn = Freedom::smooth(Way::Turn, Vector2::new(T::zero(), T::zero()));
    Release { carries: false, ..Release::nothing() }.with(turn)
}

pub(super) fn rotary<T: Scalar, R: SpringLaw<T>>(joint: &ElasticHinge<R>, state: [T; 2]) -> Release<Planar<T>> {
    Release::nothing().with(turn(&joint.rotary, state))
}

/// What a point of a body that turns accelerates by where it is at `arm` and slides: −ω² d + 2 ω ẑ × ḋ.
fn bias<T: Scalar>(spin: T, arm: Vector2<T>, sliding: Vector2<T>) -> Vector2<T> {
    arm * -(spin * spin) + normal(sliding) * (spin + spin)
}

pub(super) fn slider<T: Scalar, S: SpringLaw<T>>(
    joint: &Slider<T, S>,
    motion: &JointMotion<T>,
    [position, rate]: [T; 2],
) -> Release<Planar<T>> {
    let turn = motion.inboard.turn;
    let (sine, cosine) = (turn.angle + joint.direction).sin_cos();
    let line = Vector2::new(cosine, sine);
    Release { linear: bias(turn.rate, line * position, line * rate), ..Release::nothing() }.with(against(
        Way::Slide,
        line,
        &joint.spring,
        [position, rate],
    ))
}

pub(super) fn elastic<T: Scalar, R: SpringLaw<T>, X: SpringLaw<T>, Y: SpringLaw<T>, A: HingeAxes>(
    joint: &ElasticHinge<R, Linear<T, X, Y, A>>,
    motion: &JointMotion<T>,
    position: &(T, T, T),
    rate: &(T, T, T),
) -> Release<Planar<T>> {
    let spin = motion.inboard.turn.rate;
    let axes = if A::SWINGS {
        let (sine, cosine) = motion.inboard.turn.angle.sin_cos();
        let x = Vector2::new(cosine, sine);
        [x, normal(x)]
    } else {
        [Vector2::new(T::one(), T::zero()), Vector2::new(T::zero(), T::one())]
    };
    let along = |[x, y]: [T; 2]| axes[0] * x + axes[1] * y;
    let linear = match A::SWINGS {
        true => bias(spin, along([position.0, position.1]), along([rate.0, rate.1])),
        false => Vector2::new(T::zero(), T::zero()),
    };
    Release { linear, swings: A::SWINGS, balanced: A::LEVER, ..Release::nothing() }
        .with(against(Way::Slide, axes[0], &joint.linear.x, [position.0, rate.0]).undriven())
        .with(against(Way::Slide, axes[1], &joint.linear.y, [position.1, rate.1]).undriven())
        .with(turn(&joint.rotary, [position.2, rate.2]))
}
