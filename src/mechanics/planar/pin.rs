//! The smooth pin.

use super::axes::Coincident;
use super::{Acceleration, Frame, Joint, JointMotion, Planar, Turn, release};
use crate::element::{Condense, Given, InJoint, Posture, Sweep};
use crate::lift::lift;
use crate::relation::planar::{Gain, Point, Rigid};
use crate::relation::{Closures, Term};
use crate::release::Release;
use crate::scalar::Scalar;

/// A smooth pin: two bodies share a point, and turn freely but for the torque that is applied in the joint.
///
/// Its coordinate is the *absolute* angle of the outboard body. It has no parameters and takes no space; after it the
/// relation is a [`Point`] relation, for the moment no longer depends on the motion. Its pivot is the inertia of all that
/// lies outboard about the pin, which is positive wherever mechanics is regular, so that the centre of percussion, where
/// (40) of the paper breaks down, is nothing special.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Pin;

impl<T: Scalar> Joint<T> for Pin {
    type Position = T;
    type Rate = T;
    type Kept<C: Closures> = Gain<T, C>;

    type Axes = Coincident;

    const ABSOLUTE: bool = true;

    fn still() -> (T, T) {
        (T::zero(), T::zero())
    }
    fn kept<C: Closures>() -> Gain<T, C> {
        Gain::blank()
    }
    #[inline(always)]
    fn homogeneous<C: Closures>(kept: &Gain<T, C>) -> Gain<T, C> {
        Gain { free: T::zero(), ..*kept }
    }
    fn is_finite<C: Closures>(kept: &Gain<T, C>) -> bool {
        kept.is_finite()
    }
    fn configure(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        *position = next(inboard);
        Turn { angle: *position, rate: T::zero() }
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, _: Turn<T>) -> Turn<T> {
        Turn { angle: *position, rate: *rate }
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> JointMotion<T> {
        let outboard = Frame {
            turn: Turn { angle: *position, rate: *rate },
            acceleration: Acceleration { angular: *acceleration, ..inboard.acceleration },
            ..inboard
        };
        JointMotion::coincident(inboard, outboard, true)
    }
    fn release(&self, _: &JointMotion<T>, _: &T, _: &T) -> Release<Planar<T>> {
        release::pin()
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (): (),
        kept: &Gain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        *rate = kept.angular(inboard.linear, multipliers);
        Acceleration { angular: *rate, ..inboard }
    }
}

impl<T: Scalar, R: Rigid<T>, W: Sweep<Planar<T>, Closures = R::Closures>> Condense<Planar<T>, R, W> for Pin
where
    InJoint<Planar<T>, W>: Term<T>,
{
    type Out = Point<T, InJoint<Planar<T>, W>, W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Planar<T>, Self>,
        given: Given<'_, Planar<T>, Self, W>,
        kept: &mut Gain<T, W::Closures>,
    ) -> Self::Out {
        let (relation, gain) = outer.full().pinned(*given.in_joints);
        *kept = gain;
        relation
    }
}

lift!(Pin);
