//! The ends of planar chains.

mod clamped;
mod compliance;
mod floating;
mod free;
mod ground;
mod guided;
mod pinned;

pub use clamped::{Attitude, Clamped, Turning};
use compliance::Compliance;
pub use floating::Floating;
pub use free::Free;
pub use ground::{Ground, GroundMotion, Moving};
pub use guided::Guided;
pub use pinned::Pinned;
