//! What a sweep has to carry, decided by type.

use crate::loading::Loading;
use crate::relation::{Closures, Coefficient, Open};
use crate::scalar::Scalar;
use crate::sealed::Sealed;
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
pub trait Springs<T: Scalar>: Sealed + Copy {
    /// Whether springs add to pivots. Where they are torques given instead, gains are those of absolute angles.
    const STIFF: bool;

    /// K̂, what a spring and damper add to the pivot of their coordinate.
    fn pivot(self, stiffness: impl Coefficient<T>, damping: impl Coefficient<T>) -> T;
}

/// Springs as torques of the state given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Explicit;

impl Sealed for Explicit {}

impl<T: Scalar> Springs<T> for Explicit {
    const STIFF: bool = false;

    #[inline(always)]
    fn pivot(self, _: impl Coefficient<T>, _: impl Coefficient<T>) -> T {
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

/// A state that an acceleration leads to: the law of a spring is τ(q, v) + K̂ a less K̂ times the acceleration sought.
///
/// For a linear law any such state will do, that without acceleration among them. Others are exact where the acceleration is the one
/// sought, so that sweeps which repeat for it converge to them. An explicit sweep reads none.
#[derive(Debug)]
pub struct Reading<'a, P, V> {
    /// q.
    pub position: &'a P,
    /// v.
    pub rate: &'a V,
    /// a, that of the rates v.
    pub acceleration: &'a V,
}

impl<P, V> Clone for Reading<'_, P, V> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<P, V> Copy for Reading<'_, P, V> {}

impl<R> Sealed for Implicit<R> {}

impl<T: Scalar> Springs<T> for Implicit<T::Real> {
    const STIFF: bool = true;

    #[inline(always)]
    fn pivot(self, stiffness: impl Coefficient<T>, damping: impl Coefficient<T>) -> T {
        damping.times_onto(T::constant(self.rate), stiffness.scaled(self.position))
    }
}
