//! Condensed relations: what a chain's outboard part demands of the force at a station.
//!
//! Everything outboard of a station answers an acceleration p = (a, α) of that station with a force F = S p + e + Wλ: S is the
//! articulated-body inertia of the field and e the bias force, W λ is what constraint forces add. The inward pass of the Riccati
//! sweep carries such a relation from the tip to the root; each element maps the relation it meets to the one it hands on. How much
//! of S, e and W there is depends on what lies outboard, so it is decided by *type*: after a pin, for example, no
//! moment depends on the motion and a 2 × 2 block is all there is.
//!
//! S is symmetric positive semidefinite and only one triangle is stored. Stored full and merely assumed symmetric, its
//! antisymmetric rounding doubles with every body (a chain of 60 is lost); stored as a triangle it holds at 100 000.

mod arms;
mod closure;
mod geometry;
mod join;
mod kinds;
mod looped;
mod open;
pub mod planar;
mod redundancy;
mod shared;
pub mod spatial;
mod term;
mod way;
mod wrench;

pub use arms::{Carry, Forces, Kind, Wrenches};
pub use closure::{Close, Closures, Cut, Cuts, Open, Solvable, largest};
pub use geometry::{AccelerationOf, Additive, Angular, Geometry, Symmetric, VectorSpace, WrenchOf};
pub use kinds::{Empty, Full, Lump, Point, Relation};
pub use looped::{LoopGain, Looped, Own, Settle, Twisted};
pub use shared::Shared;
pub use term::{Absent, Coefficient, Minus, Part, Reacting, Term};
pub use way::Way;
pub use wrench::{Acceleration, Wrench};

/// A relation that can stand for a lesser one: what an array or vector without links hands on.
pub trait Promote<R> {
    /// `lesser` as a relation of this type.
    fn promote(lesser: R) -> Self;
}

impl<R> Promote<R> for R {
    fn promote(lesser: R) -> R {
        lesser
    }
}

/// A relation that links hand on, and what an array or vector of them hands on where a relation `R` lies outboard of it, which it hands on
/// itself if it has no links.
pub trait Meet<R>: Sized {
    /// What can say both.
    type Both: Copy;
    /// The relation of the links.
    fn of_links(own: Self) -> Self::Both;
    /// The relation outboard of no links.
    fn of_none(outer: R) -> Self::Both;
}

impl<R, Q: Promote<R> + Copy> Meet<R> for Q {
    type Both = Q;
    #[inline(always)]
    fn of_links(own: Q) -> Q {
        own
    }
    #[inline(always)]
    fn of_none(outer: R) -> Q {
        Q::promote(outer)
    }
}

/// A relation, or a part of one, to which that of an arm at the same station can be added.
#[diagnostic::on_unimplemented(
    message = "an arm that hands on `{A}` cannot leave the chain where that hands on `{Self}`",
    label = "these two have no sum",
    note = "an arm is a chain of the same space and scalar with a free tip, and ends with a body"
)]
pub trait Join<A>: Copy {
    /// The relation of both.
    type Out: Copy;
    /// The sum of both.
    fn join(self, arm: A) -> Self::Out;
}
