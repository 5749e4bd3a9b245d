//! The ends of spatial chains.

mod clamped;
mod compliance;
mod floating;
mod free;
mod hinged;
mod pinned;

pub use crate::ends::{Ground, Moving};
pub use clamped::{Attitude, AttitudeMotion, Clamped, Turning};
pub(super) use compliance::Compliance;
pub use floating::Floating;
pub use free::Free;
pub use hinged::Hinged;
pub use pinned::Pinned;

/// Motion of a point of the ground.
pub type GroundMotion<T> = crate::ends::GroundMotion<T, 3>;
