//! Taylor series in the plane: what lies outboard, and ends.

mod bodies;
mod joints;

use crate::mechanics::planar::{Clamped, Free, Pinned, Planar};
use crate::relation::Additive;
use crate::relation::planar::algebra::Symmetric2;
use crate::scalar::Scalar;
use crate::series::{AtRest, Expandable, Unheld};
use nalgebra::Vector2;

/// Inertia of what lies outboard of a point, as it is felt there: force (f, τ) = S (a, α).
#[derive(Clone, Copy, Debug)]
pub struct Articulated<T> {
    /// f of a.
    pub(super) linear: Symmetric2<T>,
    /// f of α, and its mirror.
    pub(super) coupling: Vector2<T>,
    /// τ of α.
    pub(super) angular: T,
}

impl<T: Scalar> Expandable for Planar<T> {
    type Articulated = Articulated<T>;

    #[inline(always)]
    fn nothing() -> Articulated<T> {
        Articulated { linear: Symmetric2::null(), coupling: Vector2::null(), angular: T::zero() }
    }
    #[inline(always)]
    fn join(a: Articulated<T>, b: Articulated<T>) -> Articulated<T> {
        Articulated { linear: a.linear + b.linear, coupling: a.coupling + b.coupling, angular: a.angular + b.angular }
    }
}

impl<T: Scalar> AtRest<Planar<T>> for Pinned<[T; 2]> {}
impl<T: Scalar> AtRest<Planar<T>> for Clamped<[T; 2], T> {}
impl<T: Scalar> Unheld<Planar<T>> for Free {}
