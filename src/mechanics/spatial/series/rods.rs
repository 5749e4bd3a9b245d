//! Taylor series in space: what bodies do that are alike around their line.
//!
//! Of the arm d, with F the force on what lies outboard of the outboard end (its point mass included), J∥ the moment of inertia along the
//! arm and e = (J∥ − J′) / l², J′ that across it beyond what point masses have,
//!
//! ```text
//! a′ = a + d̈      f = F      τ = τ′ + J∥ α + d × Y      Y = F − e d̈
//! ```
//!
//! for the angular momentum of the body is J∥ ω − e d × ḋ. So all of it that is not linear is one cross product, whatever it does.

use super::products::{across, crossed, row, vector};
use super::{AxesSeries, Swung, parted, pulled};
use crate::mechanics::spatial::body::{Body, Pose};
use crate::mechanics::spatial::{Acceleration, Internal, PointMass, Rod, Spatial};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::{Columns, add_scaled, cross, cross_onto, dot, zero};
use crate::relation::{Closures, Geometry, Symmetric};
use crate::scalar::Scalar;
use crate::series::{Borne, ExpandLoads};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

impl<T: Scalar> Rod<T> {
    /// e.
    #[inline(always)]
    fn excess(&self) -> T {
        self.excess
    }
}

impl<T: Scalar> PointMass<T> {
    /// No moments of inertia of its own.
    #[inline(always)]
    fn excess(&self) -> T {
        T::zero()
    }
}

/// A vector by a number of the clock.
#[inline(always)]
pub(super) fn scaled<T: Scalar>(v: Vector3<T>, factor: T::Real) -> Vector3<T> {
    v.map(|x| x.scale(factor))
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Keeps the arm of the next number, and angular velocity beside what is convolved with the arm.
    #[cfg_attr(optimised, inline(always))]
    fn keep(&mut self, number: usize, arm: Vector3<T>, force: Vector3<T>, spin: Vector3<T>) {
        if let (Some(turned), Some(turning)) = (self.turned.get_mut(number), self.turning.get_mut(number)) {
            turned[0] = row(arm);
            *turning = across(force, spin);
        }
    }
}

macro_rules! rods {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const N: usize> Takes<Spatial<T>, Begin<N>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Begin<N>,
                spin: Vector3<T>,
                (_, _, arm, _, (room, ())): Of<'_, Spatial<T>, Begin<N>, Self>,
            ) -> Vector3<T> {
                room.axes[0] = row(*arm);
                room.keep(0, cross(spin, *arm), zero(), spin);
                spin
            }
        }
        impl<T: Scalar, C: Closures, const N: usize> Takes<Spatial<T>, Articulate<Spatial<T>, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                Articulate { cuts }: &mut Articulate<Spatial<T>, N, C>,
                outer: Full<T>,
                (room, (), columns): Of<'_, Spatial<T>, Articulate<Spatial<T>, N, C>, Self>,
            ) -> Full<T> {
                let (arm, none) = (vector(room.axes[0]), zero());
                let pose = Pose { attitude: Columns::identity(), turning: none, arm, centripetal: none };
                *columns = cuts.columns;
                let full = Body::condense(self, outer.cut(*cuts), &pose);
                room.linear = full.linear;
                room.coupling = Spatial::levered_onto(Symmetric::diagonal(-self.excess()), arm, full.coupling);
                parted(full, cuts)
            }
        }
        impl<T: Scalar, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize> Takes<Spatial<T>, Push<Spatial<T>, A, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                walk: &mut Push<Spatial<T>, A, N, C>,
                outer: Internal<T>,
                ((room, (), columns), (), load): Of<'_, Spatial<T>, Push<Spatial<T>, A, N, C>, Self>,
            ) -> Internal<T> {
                let Push { order, gaps, .. } = walk;
                let sums = room.swept(order.k);
                let curl = scaled(crossed(&sums, 2), -order.next);
                *gaps = C::zip(gaps, columns, |gap, w| gap - dot(w.force, curl));
                let known = room.coupling.transposed_onto(curl, crossed(&sums, 0)) + outer.torque;
                let force = room.linear.apply_onto(curl, outer.force);
                (room.curls[0], room.force) = (row(curl), add_scaled(force, -self.excess(), curl));
                load.relieve(order, Internal { force, torque: cross_onto(vector(room.axes[0]), outer.force, known) })
            }
        }
        impl<T: Scalar, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize> Takes<Spatial<T>, Swing<Spatial<T>, A, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                walk: &mut Swing<Spatial<T>, A, N, C>,
                inboard: Swung<T>,
                ((room, (), columns), (), load): Of<'_, Spatial<T>, Swing<Spatial<T>, A, N, C>, Self>,
            ) -> Swung<T> {
                let Swing { order, forces, .. } = walk;
                load.note(order, inboard);
                let Acceleration { linear, angular } = inboard.acceleration();
                let turned = cross_onto(angular, vector(room.axes[0]), vector(room.curls[0]));
                let force = room.pulled(inboard, pulled::<T, C>(room.force, columns, forces));
                room.keep(order.k + 1, scaled(turned, order.twice), force, scaled(angular, order.once));
                Swung::At(Acceleration { linear: linear + turned, angular })
            }
        }
    )*};
}
rods!(Rod, PointMass);
