//! Relations in the plane, F = S p + e + W λ with F = (q, −m) the force on the outboard part and p = (a, α).
//!
//! | type | outboard of it | stored |
//! |---|---|---|
//! | [`Empty`] | nothing: a free tip | 0 numbers |
//! | [`Lump`] | a point mass | 1 |
//! | [`Point`] | a pin: the moment does not depend on the motion | 5 (and the torque in the pin, if there is one) |
//! | [`Full`] | a body, a weld, a stiff spring | 9 |
//!
//! and for each closure force λ a column (2 numbers in a point relation, 3 in a full one), a row of Λ and an entry of y₀.
//! Moments are taken about the station; d is the vector to the next station outboard, n = ẑ × d its normal.

pub mod algebra;
mod pivots;
mod promote;
mod relative_gain;
mod slide;

pub use super::{Empty, Lump, Relation};
pub use algebra::Planar;
pub use pivots::{Gain, Rigid};
pub use relative_gain::RelativeGain;
pub use slide::{Slides, along, back};

use super::{Absent, Open};

/// A full relation in the plane.
pub type Full<T, C = Open> = super::Full<Planar<T>, C>;
/// A pin outboard.
pub type Point<T, M = Absent, C = Open> = super::Point<Planar<T>, M, C>;
/// A column of W: the force q and the torque −m on the outboard part for a unit closure force.
pub type FullColumn<T> = super::WrenchOf<Planar<T>>;
