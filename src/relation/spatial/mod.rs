//! Relations in space, and their kernels.
//!
//! Acceleration p = (a, α) and force F = (q, −m) are six numbers: S is a symmetric 3 × 3 block that maps a to q, a 3 × 3 block that
//! couples q and α, and a symmetric 3 × 3 block that maps α to −m; 21 numbers, one triangle. After a ball the 3 × 3 block of q is all
//! there is.

pub mod algebra;
mod couple;
mod factor;
mod full;
mod geometry;
mod pivots;
mod slides;

pub use super::{Empty, Lump, Relation, Way};
pub use couple::Couple;
pub use factor::Factor6;
pub use full::{Afloat, Rigid};
pub use geometry::Spatial;
pub use pivots::{BallGain, Gain, Pivot};
pub use slides::Slides;

use super::{Absent, Open};

/// A full relation in space.
pub type Full<T, C = Open> = super::Full<Spatial<T>, C>;
/// A ball outboard.
pub type Point<T, M = Absent, C = Open> = super::Point<Spatial<T>, M, C>;
/// A column of W: the force q and the torque −m on the outboard part for a unit closure force.
pub type FullColumn<T> = super::WrenchOf<Spatial<T>>;
