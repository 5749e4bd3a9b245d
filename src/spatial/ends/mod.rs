//! The ends of spatial chains.

mod clamped;
mod compliance;
mod floating;
mod free;
mod ground;
mod hinged;
mod pinned;

pub use clamped::{Attitude, AttitudeMotion, Clamped, Turning};
pub(super) use compliance::Compliance;
pub use floating::Floating;
pub use free::Free;
pub use ground::{Ground, GroundMotion, Moving};
pub use hinged::Hinged;
pub use pinned::Pinned;
