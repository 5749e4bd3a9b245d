//! Taylor series in the plane: what lies outboard.

mod bodies;
mod joints;
mod loops;
mod slider;
mod tips;

use crate::mechanics::planar::{Internal, Planar, Turn};
use crate::relation::planar::algebra::{Symmetric2, add_scaled};
use crate::relation::{Additive, Closures, Symmetric};
use crate::scalar::Scalar;
use crate::series::Expandable;
use bodies::AxesSeries;
use joints::JointSeries;
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
    type AxesSeries<const N: usize> = AxesSeries<T, N>;
    type JointSeries = JointSeries<T>;
    type Begun = Turn<T>;

    #[inline(always)]
    fn nothing() -> Articulated<T> {
        Articulated { linear: Symmetric2::null(), coupling: Vector2::null(), angular: T::zero() }
    }
    #[inline(always)]
    fn join(a: Articulated<T>, b: Articulated<T>) -> Articulated<T> {
        Articulated { linear: a.linear + b.linear, coupling: a.coupling + b.coupling, angular: a.angular + b.angular }
    }
    #[cfg_attr(optimised, inline(always))]
    fn closed(open: Articulated<T>, wrench: Internal<T>, inverse: T) -> Articulated<T> {
        let (Internal { force, torque }, Articulated { linear, coupling, angular }) = (wrench, open);
        let share = torque * inverse;
        Articulated {
            linear: linear.plus_outer(force, force * inverse),
            coupling: add_scaled(coupling, share, force),
            angular: torque.mul_add(share, angular),
        }
    }
    #[inline(always)]
    fn begun(ground: Turn<T>) -> Turn<T> {
        ground
    }
    #[inline(always)]
    fn untouched<const N: usize>() -> (AxesSeries<T, N>, JointSeries<T>) {
        (AxesSeries::new(), JointSeries::new())
    }
}

/// A force with those that closure forces cause by their columns.
#[cfg_attr(optimised, inline(always))]
fn pulled<T: Scalar, C: Closures>(
    force: Vector2<T>,
    columns: &C::Each<Internal<T>>,
    forces: &C::Each<T>,
) -> Vector2<T> {
    let mut sum = force;
    C::zip(columns, forces, |w, by| sum = add_scaled(sum, by, w.force));
    sum
}
