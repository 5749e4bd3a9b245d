//! Free ends.

use super::Floating;
use crate::ends::{Loose, Root, Tip};
use crate::error::Error;
use crate::lift::lift;
use crate::mechanics::spatial::{BodyMotion, Frame, Internal, Spatial, Turn};
use crate::relation::Open;
use crate::relation::spatial::Empty;
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// An end on which nothing acts. As a root it has the number of a joint: what a load says of joint 0 is left out. Act on
/// the first body instead.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Free;

impl<T: Scalar> Root<Spatial<T>> for Free {
    type Pairs = (Loose, Loose, Loose, Loose, Loose, Loose);
    type Joint = Floating<T>;

    const RESTS: bool = true;

    fn joint(&self) -> Floating<T> {
        Floating::new()
    }
    fn ground(&self, _: T::Real) -> Frame<T> {
        Frame::resting(zero())
    }
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl<T: Scalar> Tip<Spatial<T>> for Free {
    type Pairs = (Loose, Loose, Loose, Loose, Loose, Loose);
    type Closures = Open;
    type Relation = Empty;

    #[inline(always)]
    fn relation(&self, _: T::Real, _: Vector3<T>, _: &Turn<T>) -> Empty {
        Empty
    }
    fn internal(&self, _: T::Real, (): &()) -> Internal<T> {
        Internal::none()
    }
    fn residual(&self, _: T::Real, _: &Frame<T>) -> [(); 2] {
        [(), ()]
    }
    fn free_compliance(&self, _: T::Real, _: &BodyMotion<T>) {}
    fn names(&self) {}
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

lift!(Free);
