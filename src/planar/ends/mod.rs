//! The ends of planar chains.

mod clamped;
mod floating;
mod free;
mod ground;
mod pinned;

pub use clamped::{Attitude, Clamped, Turning};
pub use floating::Floating;
pub use free::Free;
pub use ground::{Ground, GroundMotion, Moving};
pub use pinned::Pinned;
