//! Derivatives through kept gains where body axes begin.

use super::super::mount::{BodyAxes, Upright};
use super::super::relation::Local;
use crate::mechanics::spatial::Spatial;
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::sensitive::columns::{Vectors, apply, crossed, none, transposed};
use crate::mechanics::spatial::sensitive::{Answering, Passing, Pulling};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Jet, Scalar};
use crate::sensitive::{At, Seeds, Sensitive};
use nalgebra::Vector3;

/// A vector v of inertial axes in those of a body turned by φ, and its columns: Aᵀ (dv + v × φ).
#[cfg_attr(optimised, inline(always))]
fn into_body<T: Scalar, const K: usize>(
    attitude: &Columns<T>,
    angle: &Vectors<T, K>,
    v: &mut Vector3<T>,
    columns: &mut Vectors<T, K>,
) {
    let mut seen = *columns;
    apply(&mut seen, &crossed(*v), angle);
    *columns = none();
    apply(columns, &transposed(attitude), &seen);
    *v = attitude.transposed(*v);
}

/// A vector v of a body's axes in inertial ones, and its columns: A dv + φ × A v.
#[cfg_attr(optimised, inline(always))]
fn out_of_body<T: Scalar, const K: usize>(
    attitude: &Columns<T>,
    angle: &Vectors<T, K>,
    v: &mut Vector3<T>,
    columns: &mut Vectors<T, K>,
) {
    let own = *columns;
    *v = attitude.apply(*v);
    *columns = none();
    apply(columns, attitude, &own);
    apply(columns, &crossed(-*v), angle);
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for BodyAxes {
    type Plain = Self;
    /// Columns of φ.
    type Room = Vectors<T, K>;

    fn room(&self) -> Self::Room {
        none()
    }
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, (): &(), _: &Effort<Jet<T, K>>, _: &mut Self::Room) {}
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(&self, at: At<'_, Spatial<Jet<T, K>>, Self>, outer: Full<T>, _: &mut Self::Room) -> Full<T> {
        Local::of_own(&outer).turned(at.posture.x)
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        angle: &mut Self::Room,
        (): &mut (),
    ) {
        let attitude = at.posture.x;
        *angle = carried.angle;
        into_body(attitude, angle, &mut carried.turn.spin, &mut carried.spin);
        into_body(attitude, angle, &mut carried.acceleration.linear, &mut carried.linear);
        into_body(attitude, angle, &mut carried.acceleration.angular, &mut carried.angular);
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        angle: &mut Self::Room,
        (): &mut (),
    ) {
        out_of_body(at.posture.x, angle, &mut carried.force, &mut carried.forces);
        out_of_body(at.posture.x, angle, &mut carried.torque, &mut carried.torques);
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(&self, at: At<'_, Spatial<Jet<T, K>>, Self>, carried: &mut Answering<T, K>, _: &Self::Room, (): &mut ()) {
        let back = transposed(at.posture.x);
        for columns in [&mut carried.linear, &mut carried.angular] {
            let inertial = core::mem::replace(columns, none());
            apply(columns, &back, &inertial);
        }
    }
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Upright {
    type Plain = Self;
    type Room = ();

    fn room(&self) {}
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, (): &(), _: &Effort<Jet<T, K>>, (): &mut ()) {}
    #[inline(always)]
    fn factor<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, outer: Full<T>, (): &mut ()) -> Full<T> {
        outer
    }
    #[inline(always)]
    fn vary<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Passing<T, K>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn gather<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Pulling<T, K>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn answer(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Answering<T, K>, (): &(), (): &mut ()) {}
}
