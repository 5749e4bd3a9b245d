//! The joint of a chain that floats.

use crate::element::{Condense, Given, Posture, Sweep};
use crate::lift::lift;
use crate::mechanics::spatial::release::{self, Release};
use crate::mechanics::spatial::stored::{One, Stored};
use crate::mechanics::spatial::{Acceleration, Ball, Frame, Joint, JointMotion, Rotation, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, Symmetric3, is_finite, zero};
use crate::relation::spatial::{Factor6, Point, Rigid};
use crate::relation::{Absent, Closures, Open, Symmetric};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// The joint of a chain that floats: place and attitude of its first body, whose rates are the velocity in inertial and the angular
/// velocity in body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Floating<T> {
    /// Point mass that the first body lumps at its inboard end.
    lumped: T,
}

impl<T: Scalar> Floating<T> {
    pub(super) fn new() -> Self {
        Self { lumped: T::zero() }
    }

    /// Point mass (kg) at its outboard side.
    pub(crate) fn lumped(&self) -> T {
        self.lumped
    }
}

/// What eliminating all six coordinates leaves behind.
#[derive(Clone, Copy)]
pub struct Afloat<T: Scalar, C: Closures = Open> {
    /// Acceleration of the first body's inboard end.
    pub(in crate::mechanics::spatial) acceleration: Acceleration<T>,
    /// What each closure force adds to that.
    per_closure: C::Each<Acceleration<T>>,
    /// S, ready to be solved for other forces: what only costates ask for, and sweeps do not write.
    pub(in crate::mechanics::spatial) factor: Factor6<T>,
}

impl<T: Scalar, C: Closures> Afloat<T, C> {
    /// The acceleration that closure forces add.
    #[inline(always)]
    fn pulled(&self, multipliers: &C::Each<T>) -> Acceleration<T> {
        let part =
            |read: fn(Acceleration<T>) -> T| C::plus_dot(T::zero(), &C::map(&self.per_closure, read), multipliers);
        let linear = Vector3::new(part(|p| p.linear.x), part(|p| p.linear.y), part(|p| p.linear.z));
        let angular = Vector3::new(part(|p| p.angular.x), part(|p| p.angular.y), part(|p| p.angular.z));
        Acceleration { linear, angular }
    }
}

impl<T: Scalar> Joint<T> for Floating<T> {
    type Position = ([T; 3], Rotation<T>);
    type Rate = ([T; 3], [T; 3]);
    type Kept<C: Closures> = Afloat<T, C>;
    type Sets = One;

    fn still() -> (Self::Position, Self::Rate) {
        (([T::zero(); 3], Rotation::identity()), ([T::zero(); 3], [T::zero(); 3]))
    }
    fn kept<C: Closures>() -> Afloat<T, C> {
        let none = Acceleration::zero();
        Afloat { acceleration: none, per_closure: C::each(|_| none), factor: Factor6::of_one() }
    }
    fn is_finite<C: Closures>(kept: &Afloat<T, C>) -> bool {
        is_finite(kept.acceleration.linear) && is_finite(kept.acceleration.angular)
    }
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        T::zero()
    }
    /// Three angles 1-2-3; the place stays.
    fn configure(
        &self,
        position: &mut Self::Position,
        inboard: Turn<T>,
        next: &mut impl FnMut(Turn<T>) -> T,
    ) -> Turn<T> {
        Joint::configure(&Ball, &mut position.1, inboard, next)
    }
    #[inline(always)]
    fn oriented(&self, position: &Self::Position, rate: &Self::Rate, inboard: Turn<T>) -> (Turn<T>, Stored<T>) {
        Joint::oriented(&Ball, &position.1, &rate.1, inboard)
    }
    #[inline(always)]
    fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
        release::floating(self, motion, position, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn moved(
        &self,
        inboard: Frame<T>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> JointMotion<T> {
        let mut motion = Joint::moved(&Ball, inboard, &position.1, &rate.1, &acceleration.1);
        motion.outboard.place += Vector3::from(position.0);
        motion.outboard.velocity += Vector3::from(rate.0);
        motion.outboard.acceleration.linear += Vector3::from(acceleration.0);
        motion
    }
    #[cfg_attr(optimised, inline(always))]
    fn recovered<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Afloat<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T> {
        // The sweep's ground falls upward by gravity; coordinates are relative to the ground.
        let mut found = kept.acceleration;
        if const { C::COUNT > 0 } {
            let Acceleration { linear, angular } = kept.pulled(multipliers);
            found = Acceleration { linear: found.linear + linear, angular: found.angular + angular };
        }
        *rate = ((found.linear - inboard.linear).into(), attitude.transposed(found.angular).into());
        found
    }
    fn responded<C: Closures>(
        &self,
        _: Acceleration<T>,
        (attitude, _): (&Columns<T>, &[Vector3<T>; 2]),
        kept: &Afloat<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut Self::Rate,
    ) -> Acceleration<T> {
        let found = kept.pulled(multipliers);
        *rate = (found.linear.into(), attitude.transposed(found.angular).into());
        found
    }
}

impl<T: Scalar, R: Rigid<T>, W: Sweep<Spatial<T>, Closures = R::Closures>> Condense<Spatial<T>, R, W> for Floating<T> {
    /// Closure forces alone: nothing else reaches the ground.
    type Out = Point<T, Absent, R::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        _: Posture<'_, Spatial<T>, Self>,
        _: Given<'_, Spatial<T>, Self, W>,
        kept: &mut Afloat<T, R::Closures>,
    ) -> Self::Out {
        let (acceleration, per_closure, cuts) = outer.afloat_with(self.lumped);
        (kept.acceleration, kept.per_closure) = (acceleration, per_closure);
        Point { mass: Symmetric3::diagonal(T::zero()), offset: zero(), torque: Absent, cuts }
    }
}

lift!(Floating { lumped });
