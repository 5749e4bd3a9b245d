//! Relations in space, and their kernels.
//!
//! Acceleration p = (a, α) and force F = (q, −m) are six numbers: S is a symmetric 3 × 3 block that maps a to q, a 3 × 3 block that
//! couples q and α, and a symmetric 3 × 3 block that maps α to −m; 21 numbers, one triangle. After a ball the 3 × 3 block of q is all
//! there is.

pub mod algebra;
mod full;
mod join;
mod kinds;
mod looped;
mod pivots;
mod slides;

pub use crate::relation::Way;
pub use full::{Full, FullColumn, Rigid};
pub use kinds::{Couple, Empty, Lump, Point, Relation};
pub use pivots::{BallGain, Gain, Pivot};
pub use slides::Slides;
