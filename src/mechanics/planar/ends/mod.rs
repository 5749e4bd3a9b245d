//! The ends of planar chains.

mod clamped;
mod compliance;
mod free;
mod guided;
mod pinned;

pub use crate::ends::{Ground, Moving};
pub use clamped::{Attitude, Clamped, Turning};
pub(super) use compliance::Compliance;
pub use free::{Floating, Free};
pub use guided::Guided;
pub use pinned::Pinned;

/// Motion of a point of the ground.
pub type GroundMotion<T> = crate::ends::GroundMotion<T, 2>;
