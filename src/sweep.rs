//! What a sweep has to carry, decided by type.

use crate::loading::Loading;
use crate::relation::{Closures, Coefficient, Open};
use crate::scalar::Scalar;
use crate::space::Space;
use core::marker::PhantomData;

/// What a sweep has to carry besides inertia: what is not there costs nothing.
pub trait Sweep<S: Space> {
    /// Loads on bodies and in joints.
    type Loads: Loading<S>;
    /// How springs enter: explicitly, or linearly implicitly.
    type Springs: Springs<S::Scalar>;
    /// Forces of closures.
    type Closures: Closures;
}

/// A sweep with loads `L`, springs that enter by `K` and closures `C`.
pub struct Carrying<L, K = Explicit, C = Open>(PhantomData<(L, K, C)>);

impl<S: Space, L: Loading<S>, K: Springs<S::Scalar>, C: Closures> Sweep<S> for Carrying<L, K, C> {
    type Loads = L;
    type Springs = K;
    type Closures = C;
}

/// How springs enter a sweep.
pub trait Springs<T: Scalar>: Copy {
    /// K̂, what a spring and damper add to the pivot of their coordinate.
    fn pivot(self, stiffness: T, damping: impl Coefficient<T>) -> T;
}

/// Springs as torques of the state given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explicit;

impl<T: Scalar> Springs<T> for Explicit {
    #[inline(always)]
    fn pivot(self, _: T, _: impl Coefficient<T>) -> T {
        T::zero()
    }
}

/// Springs as affine functions of the acceleration sought: a coordinate moves by `position` (s²) and its rate by `rate` (s) for
/// each unit of its acceleration, so that a joint's pivot gains position · stiffness + rate · damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Implicit<R> {
    /// ∂q/∂a = β h² κ (s²).
    pub position: R,
    /// ∂v/∂a = γ h κ (s).
    pub rate: R,
}

impl<T: Scalar> Springs<T> for Implicit<T::Real> {
    #[inline(always)]
    fn pivot(self, stiffness: T, damping: impl Coefficient<T>) -> T {
        damping.times_onto(T::constant(self.rate), stiffness.scale(self.position))
    }
}
