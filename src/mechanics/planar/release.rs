//! What joints in the plane let move, and what resists it.

use super::{ElasticHinge, HingeAxes, JointMotion, Linear, Planar, Slider, SpringLaw};
use crate::relation::planar::algebra::normal;
use crate::release::{Freedom, Release, Way};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A turn, which is about ẑ.
fn turn<T: Scalar>(law: &impl SpringLaw<T>, state: [T; 2]) -> Freedom<Planar<T>> {
    Freedom::smooth(Way::Turn, Vector2::new(T::zero(), T::zero())).sprung(law, state)
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
    Release { linear: bias(turn.rate, line * position, line * rate), ..Release::nothing() }
        .with(Freedom::smooth(Way::Slide, line).sprung(&joint.spring, [position, rate]))
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
    let slide = |axis| Freedom::smooth(Way::Slide, axis).undriven();
    Release { linear, swings: A::SWINGS, balanced: A::LEVER, ..Release::nothing() }
        .with(slide(axes[0]).sprung(&joint.linear.x, [position.0, rate.0]))
        .with(slide(axes[1]).sprung(&joint.linear.y, [position.1, rate.1]))
        .with(turn(&joint.rotary, [position.2, rate.2]))
}
