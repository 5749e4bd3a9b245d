//! The ends of spatial chains.

mod clamped;
mod compliance;
mod floating;
mod free;
mod hinged;
mod pinned;

use super::{Rotation, Spatial};
use crate::ends::Resting;
pub use crate::ends::{Ground, Moving, Turning};
use crate::scalar::Scalar;
pub use clamped::{AttitudeMotion, Clamped};
pub(super) use compliance::Compliance;
pub use floating::Floating;
pub use free::Free;
pub use hinged::Hinged;
pub use pinned::Pinned;

/// Motion of a point of the ground.
pub type GroundMotion<T> = crate::ends::GroundMotion<T, 3>;

impl<T: Scalar> Resting<Spatial<T>> for Pinned<[T; 3]> {}
impl<T: Scalar> Resting<Spatial<T>> for Clamped<[T; 3], Rotation<T>> {}
impl<T: Scalar> Resting<Spatial<T>> for Hinged<[T; 3], Rotation<T>, T> {}
