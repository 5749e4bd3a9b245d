//! The ends of planar chains.

mod clamped;
mod compliance;
mod free;
mod ground;
mod guided;
mod pinned;

pub use clamped::{Attitude, Clamped, Turning};
pub(super) use compliance::Compliance;
pub use free::{Floating, Free};
pub use ground::{Ground, GroundMotion, Moving};
pub use guided::Guided;
pub use pinned::Pinned;
