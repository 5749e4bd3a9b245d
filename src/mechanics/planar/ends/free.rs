//! Free ends.

use crate::ends::{Loose, Root, Tip};
use crate::error::Error;
use crate::lift::lift;
use crate::mechanics::planar::{BodyMotion, ElasticHinge, Frame, Internal, Linear, Planar, Turn, Unbalanced};
use crate::relation::planar::Empty;
use crate::relation::{Absent, Open};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// An end on which nothing acts. As a root it has the number of a joint: a torque in joint 0 acts on the first body from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Free;

/// The joint of a chain that floats: coordinates x, y (m) and the absolute angle of its first body (rad), against which nothing
/// acts.
pub type Floating<T> = ElasticHinge<Absent, Linear<T, Absent, Absent, Unbalanced>>;

impl<T: Scalar> Root<Planar<T>> for Free {
    type Pairs = (Loose, Loose, Loose);
    type Joint = Floating<T>;

    const RESTS: bool = true;

    fn joint(&self) -> Floating<T> {
        ElasticHinge::linear(Absent, Absent).in_unbalanced_axes()
    }
    fn ground(&self, _: T::Real) -> Frame<T> {
        Frame::resting(Vector2::new(T::zero(), T::zero()))
    }
    fn check(&self) -> Result<(), Error> {
        Ok(())
    }
}

impl<T: Scalar> Tip<Planar<T>> for Free {
    type Pairs = (Loose, Loose, Loose);
    type Closures = Open;
    type Relation = Empty;

    #[inline(always)]
    fn relation(&self, _: T::Real, _: Vector2<T>, _: &Turn<T>) -> Empty {
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
