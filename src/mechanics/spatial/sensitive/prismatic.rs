//! Derivatives through kept gains in space: what the prismatic joint does.
//!
//! With the arm d = n s the outboard point accelerates by α × d + ω × (ω × d) + 2 ω × n ṡ + n s̈ more than the inboard one.

use super::columns::{Vectors, add_along, add_scaled_vectors, apply, crossed, none, parts, project};
use super::{Answering, Passing, Pulling};
use crate::lift::Lift;
use crate::mechanics::spatial::axial::Axial;
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::{Prismatic, Spatial};
use crate::relation::Absent;
use crate::relation::spatial::algebra::{Columns, add_scaled, cross, dot, zero};
use crate::relation::spatial::{Full, Pivot, Relation, Way};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::{At, Seeds, Sensitive};
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// What a prismatic joint keeps.
#[derive(Clone, Copy)]
pub struct SlideStore<T: Scalar, const K: usize> {
    pivot: Pivot<T>,
    /// −1 / Δ.
    minus_inverse: T,
    axis: Vector3<T>,
    arm: Vector3<T>,
    /// Columns of the axis and of the arm.
    axes: Vectors<T, K>,
    arms: Vectors<T, K>,
    load: Jet<T, K>,
}

impl<T: Scalar, L, P, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Prismatic<Jet<T, K>, L>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T, Over = P>,
    P: SpringLaw<T>,
{
    type Plain = Prismatic<T, P>;
    type Room = SlideStore<T, K>;

    fn room(&self) -> Self::Room {
        SlideStore {
            pivot: Pivot::blank(),
            minus_inverse: T::zero(),
            axis: zero(),
            arm: zero(),
            axes: none(),
            arms: none(),
            load: Jet::of(T::zero()),
        }
    }
    #[inline(always)]
    fn read(position: &Jet<T, K>, rate: &Jet<T, K>, plain_position: &mut T, plain_rate: &mut T) {
        (*plain_position, *plain_rate) = (position.re, rate.re);
    }
    fn load(&self, (): &(), Effort([along, ..]): &Effort<Jet<T, K>>, store: &mut Self::Room) {
        store.load = *along;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Room,
    ) -> Full<T> {
        let (stored, bias) = (at.posture.x, at.posture.y);
        (store.axis, store.arm) = (stored.x, stored.z);
        let load = if N::LOADS { store.load.re } else { T::zero() };
        let force = load + at.plain.force(0, at.position.re, at.rate.re);
        let outer = outer.with_mass(at.plain.lumped());
        // The same quotient as in the elimination.
        store.minus_inverse = -dot(store.axis, outer.linear.apply(store.axis)).recip();
        let (relation, pivot) = outer.released(Way::Slide, store.axis, force, Absent);
        store.pivot = pivot;
        relation.carried(store.arm, bias[0])
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let (n, d, w, v) = (store.axis, store.arm, carried.turn.spin, at.rate.re);
        let mut outboard = carried.acceleration.shifted(d, at.posture.y[0]);
        let second = store.pivot.acceleration(outboard.linear, outboard.angular, &());
        outboard.linear = add_scaled(outboard.linear, second, n);
        acceleration.re = second;
        let mut of_axis = none();
        if N::PARAMETERS {
            let Columns { x, y, z } = carried.turn.attitude;
            let of = |v: Vector3<T>| v.map(Jet::of);
            of_axis = parts(&Columns { x: of(x), y: of(y), z: of(z) }.apply(self.axis()));
        }
        apply(&mut of_axis, &crossed(-n), &carried.angle);
        let mut of_arm = none();
        add_along(&mut of_arm, n, &at.position.eps);
        add_scaled_vectors(&mut of_arm, at.position.re, &of_axis);
        // Of ω × d + 2 n ṡ, but for ω' × d and 2 n' ṡ of the first cross product.
        let mut swept = none();
        apply(&mut swept, &crossed(-d), &carried.spin);
        apply(&mut swept, &crossed(w), &of_arm);
        add_scaled_vectors(&mut swept, v + v, &of_axis);
        add_along(&mut swept, n + n, &at.rate.eps);
        let sweeping = cross(w, d) + n * (v + v);
        apply(&mut carried.linear, &crossed(-sweeping), &carried.spin);
        apply(&mut carried.linear, &crossed(w), &swept);
        apply(&mut carried.linear, &crossed(-d), &carried.angular);
        apply(&mut carried.linear, &crossed(outboard.angular), &of_arm);
        add_scaled_vectors(&mut carried.linear, second, &of_axis);
        carried.acceleration = outboard;
        (store.axes, store.arms) = (of_axis, of_arm);
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        // Forces of bodies are those of their whole mass, what they have lumped here among it.
        let (n, d) = (store.axis, store.arm);
        let load = if N::LOADS { store.load } else { Jet::of(T::zero()) };
        let force = load + self.force(0, *at.position, *at.rate);
        let mut residual = force.eps.map(|x| -x);
        project(&mut residual, n, &carried.forces);
        project(&mut residual, carried.force, &store.axes);
        let Pivot { per_linear, per_angular, .. } = store.pivot;
        add_along(&mut carried.forces, per_linear, &residual);
        add_along(&mut carried.torques, per_angular, &residual);
        acceleration.eps = residual.map(|x| x * store.minus_inverse);
        // d × f of what acts on the outboard point.
        carried.torque += cross(d, carried.force);
        let forces = carried.forces;
        apply(&mut carried.torques, &crossed(d), &forces);
        apply(&mut carried.torques, &crossed(-carried.force), &store.arms);
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        _: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let Pivot { per_linear, per_angular, .. } = store.pivot;
        apply(&mut carried.linear, &crossed(-store.arm), &carried.angular);
        project(&mut acceleration.eps, per_linear, &carried.linear);
        project(&mut acceleration.eps, per_angular, &carried.angular);
        add_along(&mut carried.linear, store.axis, &acceleration.eps);
    }
}
