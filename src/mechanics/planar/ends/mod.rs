//! The ends of planar chains.

mod clamped;
mod compliance;
mod free;
mod guided;
mod pinned;

use super::Planar;
use crate::ends::Resting;
pub use crate::ends::{Ground, Moving, Turning};
use crate::scalar::Scalar;
pub use clamped::Clamped;
pub(super) use compliance::Compliance;
pub use free::{Floating, Free};
pub use guided::Guided;
pub use pinned::Pinned;

/// Motion of a point of the ground.
pub type GroundMotion<T> = crate::ends::GroundMotion<T, 2>;

impl<T: Scalar> Resting<Planar<T>> for Pinned<[T; 2]> {}
impl<T: Scalar> Resting<Planar<T>> for Clamped<[T; 2], T> {}
