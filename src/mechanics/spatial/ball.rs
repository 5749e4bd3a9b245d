//! The ball joint.

use super::loads::Drive;
use super::release::{self, Release};
use super::{Acceleration, Frame, Joint, JointMotion, Rotation, Spatial, Turn, stored::One, stored::Stored};
use crate::element::{Condense, Given, InJoint, Posture, Sweep};
use crate::lift::lift;
use crate::relation::Closures;
use crate::relation::spatial::algebra::{Columns, zero};
use crate::relation::spatial::{Gain, Point, Rigid};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A smooth ball joint: two bodies share a point, and turn freely but for the torque that is applied in the joint.
///
/// Its coordinate is the *absolute* attitude of the outboard body, its rate the angular velocity in axes of that body, and its torque
/// is given in these axes. It has no parameters and takes no space; after it the relation is a [`Point`] relation. Its pivot, the
/// inertia tensor of all that lies outboard about the joint, is positive definite wherever mechanics is regular; (40) of the paper
/// inverts another matrix, which is singular at centres of percussion and at θ₂ = ±π/2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ball;

impl<T: Scalar> Joint<T> for Ball {
    type Position = Rotation<T>;
    type Rate = [T; 3];
    type Kept<C: Closures> = Gain<T, C>;
    type Sets = One;

    fn still() -> (Rotation<T>, [T; 3]) {
        (Rotation::identity(), [T::zero(); 3])
    }
    fn kept<C: Closures>() -> Gain<T, C> {
        Gain::blank()
    }
    fn is_finite<C: Closures>(kept: &Gain<T, C>) -> bool {
        kept.is_finite()
    }
    /// Three absolute angles 1-2-3.
    fn configure(&self, position: &mut Rotation<T>, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        *position = Rotation::from_angles([(); 3].map(|()| next(inboard)));
        Turn { attitude: position.matrix(), spin: zero() }
    }
    #[cfg_attr(optimised, inline(always))]
    fn oriented(&self, position: &Rotation<T>, rate: &[T; 3], _: Turn<T>) -> (Turn<T>, Stored<T>) {
        let attitude = position.matrix();
        let spin = attitude.apply(Vector3::from(*rate));
        (Turn { attitude, spin }, (attitude, [zero(); 2]))
    }
    #[inline(always)]
    fn store((attitude, _): Stored<T>, x: &mut Columns<T>, _: &mut [Vector3<T>; 2]) {
        *x = attitude;
    }
    #[inline(always)]
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
        release::ball(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, inboard: Frame<T>, position: &Rotation<T>, rate: &[T; 3], acceleration: &[T; 3]) -> JointMotion<T> {
        let (turn, (attitude, _)) = self.oriented(position, rate, inboard.turn);
        let angular = attitude.apply(Vector3::from(*acceleration));
        let outboard = Frame { turn, acceleration: Acceleration { angular, ..inboard.acceleration }, ..inboard };
        let relative = attitude.transposed(turn.spin - inboard.turn.spin);
        let none = [T::zero(); 3];
        JointMotion {
            inboard,
            outboard,
            position: none,
            rate: relative.into(),
            effort: none,
            energy: T::zero(),
            inertia: none,
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Gain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let angular = kept.angular(inboard.linear, multipliers);
        *rate = attitude.transposed(angular).into(); // A ω̇ is the acceleration: A ω~ ω = 0
        Acceleration { angular, ..inboard }
    }
    #[cfg_attr(optimised, inline(always))]
    fn responded<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        stored: (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Gain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut [T; 3],
    ) -> Acceleration<T> {
        let homogeneous = Gain { free: zero(), ..*kept };
        Joint::recovered::<C>(self, inboard, stored, &homogeneous, multipliers, rate)
    }
}

impl<T: Scalar, R: Rigid<T>, W: Sweep<Spatial<T>, Closures = R::Closures>> Condense<Spatial<T>, R, W> for Ball
where
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = Point<T, <InJoint<Spatial<T>, W> as Drive<T>>::Couple, W::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut Gain<T, W::Closures>,
    ) -> Self::Out {
        let (relation, gain) = outer.full().balled(given.in_joints.couple(posture.x));
        *kept = gain;
        relation
    }
}

lift!(Ball);
