//! Robots: arms and legged machines of hinges, slides and links, in axes of their bodies, with what is zero as types.

pub use crate::mechanics::spatial::body_axes::*;
pub use crate::spatial::*;
