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
mod full;
mod join;
mod kinds;
mod looped;
mod slide;

pub use full::{Full, FullColumn, Gain, HingeGain, Rigid};
pub use kinds::{Empty, Lump, Point, Relation};
pub use slide::{SlideGain, Slides, along, back};
