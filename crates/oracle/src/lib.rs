//! Second opinions for tests: the Newton-Euler equations of all bodies as one dense system, in the plane and in space, and what several
//! tests measure by. Nothing here depends on the library under test.

pub mod complementarity;
pub mod extrapolation;
mod linkage;
mod measure;
pub mod plane;
pub mod space;

pub use linkage::four_bar;
pub use measure::{Noise, derivative, farthest, has_order, near, slope};
