//! What springs and dampers of single coordinates add to pivots.

use crate::element::{Explicit, Implicit, Springs};
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::Scalar;

/// What a law adds to a pivot in a sweep.
pub trait PivotRule<T: Scalar>: Springs<T> {
    /// Nothing in an explicit sweep.
    type Stiffness: Term<T> + Coefficient<T>;
    /// K̂.
    fn stiffness(self, law: impl FnOnce(Implicit<T::Real>) -> T) -> Self::Stiffness;
}

impl<T: Scalar> PivotRule<T> for Explicit {
    type Stiffness = Absent;
    #[inline(always)]
    fn stiffness(self, _: impl FnOnce(Implicit<T::Real>) -> T) -> Absent {
        Absent
    }
}

impl<T: Scalar> PivotRule<T> for Implicit<T::Real> {
    type Stiffness = T;
    #[inline(always)]
    fn stiffness(self, law: impl FnOnce(Implicit<T::Real>) -> T) -> T {
        law(self)
    }
}
