//! The smooth pin.

use super::{Acceleration, Frame, Joint, Planar, Turn};
use crate::element::{Applied, Condense, Loading, Posture};
use crate::lift::lift;
use crate::relation::Term;
use crate::relation::plane::{Full, Gain, Point};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A smooth pin: two bodies share a point, and turn freely but for the torque that is applied in the joint.
///
/// Its coordinate is the *absolute* angle of the outboard body. It has no parameters and takes no space; after it the
/// relation is a [`Point`] relation, for the moment no longer depends on the motion. Its pivot is the inertia of all that
/// lies outboard about the pin, which is positive wherever mechanics is regular, so that the centre of percussion, where
/// (40) of the paper breaks down, is nothing special.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pin;

impl<T: Scalar> Joint<T> for Pin {
    type Position = T;
    type Rate = T;
    type Kept = Gain<T>;

    fn position() -> T {
        T::zero()
    }
    fn rate() -> T {
        T::zero()
    }
    fn kept() -> Gain<T> {
        Gain { per_acceleration: Vector2::new(T::zero(), T::zero()), free: T::zero() }
    }
    fn is_finite(kept: &Gain<T>) -> bool {
        kept.per_acceleration.x.is_finite() && kept.per_acceleration.y.is_finite() && kept.free.is_finite()
    }
    fn aim(&self, position: &mut T, _: Turn<T>, next: &mut impl FnMut() -> T) -> Turn<T> {
        *position = next();
        Turn { angle: *position, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, _: Turn<T>) -> Turn<T> {
        Turn { angle: *position, rate: *rate }
    }
    #[inline(always)]
    fn moved(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> Frame<T> {
        Frame {
            turn: Turn { angle: *position, rate: *rate },
            acceleration: Acceleration { angular: *acceleration, ..inboard.acceleration },
            ..inboard
        }
    }
    #[inline(always)]
    fn recovered(&self, inboard: Acceleration<T>, kept: &Gain<T>, rate: &mut T) -> Acceleration<T> {
        *rate = kept.angular(inboard.linear);
        Acceleration { angular: *rate, ..inboard }
    }
}

impl<T: Scalar, L: Loading<Planar<T>>> Condense<Planar<T>, Full<T>, L> for Pin
where
    L::InJoint: Term<T>,
{
    type Out = Point<T, L::InJoint>;

    #[inline(always)]
    fn condense(
        &self,
        outer: Full<T>,
        _: Posture<'_, Planar<T>, Self>,
        loads: Applied<'_, Planar<T>, Self, L>,
        kept: &mut Gain<T>,
    ) -> Self::Out {
        let (relation, gain) = outer.pinned(*loads.in_joints);
        *kept = gain;
        relation
    }
}

lift!(Pin);
