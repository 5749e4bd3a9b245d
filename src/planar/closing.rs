//! The closure forces of a chain, from what its relation says at the root: −Wᵀ p + Λ λ + y₀ = 0.

use super::{Acceleration, Planar};
use crate::element::Close;
use crate::relation::plane::algebra::dot;
use crate::relation::plane::{Empty, Full, Point};
use crate::relation::{Open, Solvable};
use crate::scalar::Scalar;

impl<T: Scalar> Close<Planar<T>, Open> for Empty {
    #[inline(always)]
    fn multipliers(&self, _: &Acceleration<T>) {}
    #[inline(always)]
    fn compliance(&self) {}
}

impl<T: Scalar, M: Copy, C: Solvable> Close<Planar<T>, C> for Point<T, M, C> {
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

impl<T: Scalar, C: Solvable> Close<Planar<T>, C> for Full<T, C> {
    #[inline(always)]
    fn multipliers(&self, root: &Acceleration<T>) -> C::Each<T> {
        let cuts = &self.cuts;
        let demand =
            C::zip(&cuts.columns, &cuts.gap, |w, gap| w.torque.mul_add(root.angular, dot(w.force, root.linear)) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<T> {
        self.cuts.compliance
    }
}
