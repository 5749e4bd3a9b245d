//! The closure forces of a chain, from what its relation says at the root: −Wᵀ p + Λ λ + y₀ = 0.

use super::{Acceleration, Spatial};
use crate::element::Close;
use crate::relation::space::algebra::dot;
use crate::relation::space::{Empty, Full, FullColumn, Point};
use crate::relation::{Open, Solvable};
use crate::scalar::Scalar;

impl<T: Scalar> Close<Spatial<T>, Open> for Empty {
    #[inline(always)]
    fn multipliers(&self, _: &Acceleration<T>) {}
    #[inline(always)]
    fn compliance(&self) {}
}

impl<T: Scalar, M: Copy, C: Solvable> Close<Spatial<T>, C> for Point<T, M, C> {
    #[inline(always)]
    fn multipliers(&self, root: &Acceleration<T>) -> C::Each<T> {
        let cuts = &self.cuts;
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| dot(w, root.linear) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<T> {
        self.cuts.compliance
    }
}

impl<T: Scalar, C: Solvable> Close<Spatial<T>, C> for Full<T, C> {
    #[inline(always)]
    fn multipliers(&self, root: &Acceleration<T>) -> C::Each<T> {
        let cuts = &self.cuts;
        let work = |w: FullColumn<T>| dot(w.force, root.linear) + dot(w.torque, root.angular);
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| work(w) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<T> {
        self.cuts.compliance
    }
}
