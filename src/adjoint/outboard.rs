//! What lies outboard of a station on the costate sweep's way inward.

use crate::relation::{
    AccelerationOf, Carry, Closures, Cuts, Full, Geometry, Join, LoopGain, Looped, Open, Own, Settle, WrenchOf,
    Wrenches,
};
use num_traits::Zero;

/// What lies outboard of a station, S and e, and W, Λ and y₀ of closure forces, with a kind: bodies save what a joint whose moment does not
/// depend on the motion, or a free tip, leaves out.
#[derive(Clone, Copy)]
pub struct Outboard<S: Geometry, C: Closures = Open> {
    pub kind: Kind,
    pub relation: Full<S, C>,
}

impl<S: Geometry, C: Closures> Outboard<S, C> {
    /// Nothing but closure forces.
    #[inline(always)]
    pub fn cut(kind: Kind, columns: C::Each<WrenchOf<S>>, gap: C::Each<S::Scalar>) -> Self {
        Self { kind, relation: Full::massless().cut(Cuts::at_tip(columns, gap)) }
    }
    /// What lies beyond the last body where it is held: λ acts on the body by the wrenches c, and c · A of the body is that of the ground.
    #[inline(always)]
    pub fn held(kind: Kind, columns: C::Each<WrenchOf<S>>, still: &AccelerationOf<S>) -> Self {
        let columns = C::map(&columns, |column| -column);
        Self::cut(kind, columns, C::map(&columns, |column| column.work(still)))
    }
}

impl<S: Geometry, C: Closures> Outboard<S, C> {
    /// What lies beyond the ends of the main arm and of the side arm of a loop. λ acts ON the side arm by the wrenches c, so F on what lies
    /// outboard of it is −λ, and the opposite on what the main arm meets.
    #[cfg_attr(optimised, inline(always))]
    #[allow(clippy::type_complexity)] // two of them
    pub fn closed<O: Own>(
        self,
        kind: Kind,
        columns: O::Each<WrenchOf<S>>,
    ) -> (Outboard<S, Looped<C, O>>, Outboard<S, O>) {
        let relation = Carry::<S, O, Wrenches>::carry(self.relation, columns);
        let side = Outboard::cut(kind, O::map(&columns, |column| -column), O::each(|_| S::Scalar::zero()));
        (Outboard { kind: self.kind.and(kind), relation }, side)
    }
}

/// What there is of a relation.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// A free tip: nothing.
    Nothing,
    /// A pin or a ball: the moment does not depend on the motion.
    Point,
    /// All of it.
    Rigid,
}

impl Kind {
    /// What there is of a sum.
    #[cfg_attr(optimised, inline(always))]
    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Nothing, kind) | (kind, Self::Nothing) => kind,
            (Self::Point, Self::Point) => Self::Point,
            _ => Self::Rigid,
        }
    }
}

impl<S: Geometry> Outboard<S> {
    /// Nothing, beyond a free tip.
    #[inline(always)]
    pub fn nothing() -> Self {
        Self { kind: Kind::Nothing, relation: Full::massless() }
    }
}

impl<S: Geometry, C: Closures> Outboard<S, C> {
    /// All of a relation.
    #[inline(always)]
    pub fn rigid(relation: Full<S, C>) -> Self {
        Self { kind: Kind::Rigid, relation }
    }
    /// What lies beyond a station of which an arm leaves.
    #[inline(always)]
    pub fn join(self, arm: Outboard<S>) -> Self {
        Self { kind: self.kind.and(arm.kind), relation: self.relation.join(arm.relation) }
    }
}

impl<S: Geometry, C: Closures, O: Own> Outboard<S, Looped<C, O>> {
    /// What lies beyond a station where the arms of a loop begin, without the forces that close it.
    #[cfg_attr(optimised, inline(always))]
    #[allow(clippy::type_complexity)] // what is left, and how it is found again
    pub fn settle(
        self,
        side: Outboard<S, O>,
        measure: O::Measure<S::Scalar>,
    ) -> (Outboard<S, C>, LoopGain<WrenchOf<S>, S::Scalar, C, O>) {
        let (relation, gain) = self.relation.settle(side.relation, measure);
        (Outboard { kind: self.kind.and(side.kind), relation }, gain)
    }
}
