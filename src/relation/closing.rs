//! The closure forces of a chain, from what its relation says at the root: −Wᵀ p + Λ λ + y₀ = 0.

use super::{AccelerationOf, Closures, Empty, Full, Geometry, Open, Point, Solvable};
use crate::relation::geometry::dot;

/// The relation at the root of a chain, from which the closure forces follow.
#[diagnostic::on_unimplemented(
    message = "a root cannot hold `{Self}`",
    label = "what this chain begins with needs something between it and the root",
    note = "a robot begins with `BodyAxes`, unless it stands on a `Base`"
)]
pub trait Close<G: Geometry, C: Closures> {
    /// λ, for the acceleration of the root.
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar>;
    /// Λ.
    fn compliance(&self) -> C::Pairs<G::Scalar>;
}

impl<G: Geometry> Close<G, Open> for Empty {
    #[inline(always)]
    fn multipliers(&self, _: &AccelerationOf<G>) {}
    #[inline(always)]
    fn compliance(&self) {}
}

impl<G: Geometry, M: Copy, C: Solvable> Close<G, C> for Point<G, M, C> {
    #[cfg_attr(optimised, inline(always))]
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar> {
        let cuts = &self.cuts;
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| dot(w, root.linear) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<G::Scalar> {
        self.cuts.compliance
    }
}

impl<G: Geometry, C: Solvable> Close<G, C> for Full<G, C> {
    #[cfg_attr(optimised, inline(always))]
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar> {
        let cuts = &self.cuts;
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| w.work(root) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<G::Scalar> {
        self.cuts.compliance
    }
}
