//! Taylor series in space: what a prismatic joint does.
//!
//! Its axis n is a vector that turns with both bodies, and the outboard point is at r = s n from the inboard one. With Q what acts along
//! the axis, F the force through the joint, and p of the axis as for a body, of each order
//!
//! ```text
//! r̈ = s̈ n₀ + α × r₀ + κ      κ = s₀ p + (k + 1) (k + 2) Σ s_j n_{k+2−j}, j from 1 to k + 1      n · F = Q
//! ```
//!
//! and the torque about the inboard point has the part r × F.

use super::ball::Applied;
use super::products::{row, vector};
use super::rods::scaled;
use super::{AxesSeries, Swung, parted, pulled};
use crate::mechanics::spatial::axial::Axial;
use crate::mechanics::spatial::{Acceleration, Drive, Internal, Prismatic, Spatial};
use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot, zero};
use crate::relation::spatial::{Full, Pivot, Relation};
use crate::relation::{Absent, Closures, Symmetric, Way};
use crate::scalar::Scalar;
use crate::series::{ExpandLaw, ExpandLoads};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;
use num_traits::One;

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Keeps the axis and the arm of the next number, and what is convolved with them: the force, the angular velocity across, the
    /// coordinate of the next number.
    #[cfg_attr(optimised, inline(always))]
    fn keep_slide(&mut self, number: usize, [axis, arm]: [Vector3<T>; 2], beside: [Vector3<T>; 2], slide: T) {
        if let (Some(turned), Some(turning)) = (self.turned.get_mut(number), self.turning.get_mut(number)) {
            let ([x, y, z], [force, spin]) = (arm.into(), beside);
            let o = T::zero();
            *turned = [row(axis), [y, z, x, o], [z, x, y, o]];
            *turning =
                [[force.x, spin.y, spin.z, slide], [force.y, spin.z, spin.x, slide], [force.z, spin.x, spin.y, slide]];
        }
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, const N: usize> Takes<Spatial<T>, Begin<N>> for Prismatic<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        spin: Vector3<T>,
        (stored, _, _, (slide, rate), (axes, room)): Of<'_, Spatial<T>, Begin<N>, Self>,
    ) -> Vector3<T> {
        let (axis, arm) = (stored.x, stored.z);
        let [x, y, z] = axis.into();
        axes.axes = [[x, y, z, *slide], row(arm), [T::zero(); 4]];
        let moved = add_scaled(cross(spin, arm), *rate, axis);
        axes.keep_slide(0, [cross(spin, axis), moved], [zero(), spin], *rate);
        self.law().begin(&mut room.strain, *slide, *rate);
        spin
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, C: Closures, const N: usize> Takes<Spatial<T>, Articulate<Spatial<T>, N, C>>
    for Prismatic<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Spatial<T>, N, C>,
        outer: Full<T>,
        (axes, room, columns): Of<'_, Spatial<T>, Articulate<Spatial<T>, N, C>, Self>,
    ) -> Full<T> {
        let [axis, arm, _] = axes.axes.map(vector);
        let outer = outer.cut(*cuts).with_mass(self.lumped());
        room.minus_inverse = -dot(axis, outer.linear.apply(axis)).recip();
        let (full, Pivot { per_linear, per_angular, per_closure, .. }) =
            outer.released(Way::Slide, axis, T::zero(), Absent);
        (room.pivot.per_linear, room.pivot.per_angular) = (per_linear, per_angular);
        // Of each closure force the force that is left at the outboard point, and the acceleration along the axis instead of the torque.
        *columns = C::zip(&full.cuts.columns, &per_closure, |w, row| Internal { torque: axis * row, ..w });
        (axes.linear, axes.coupling) = (full.linear, full.coupling);
        parted(full.carried(arm, zero()), cuts)
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Spatial<T>, N, InJoint: Applied<T>>, C: Closures, const N: usize>
    Takes<Spatial<T>, Push<Spatial<T>, A, N, C>> for Prismatic<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Spatial<T>, A, N, C>,
        outer: Internal<T>,
        ((axes, room, columns), efforts, ()): Of<'_, Spatial<T>, Push<Spatial<T>, A, N, C>, Self>,
    ) -> Internal<T> {
        let ([x, y, z], moment) = axes.slid(order.k);
        let [axis, arm, _] = axes.axes.map(vector);
        // n × ω, the other way round.
        let turned = scaled(Vector3::new(z[2] - y[1], x[2] - z[1], y[2] - x[1]), order.next);
        axes.curls[0] = row(turned);
        let both = order.next * (order.next + T::Real::one());
        room.bias = add_scaled(scaled(Vector3::new(x[3], y[3], z[3]), both), axes.axes[0][3], turned);
        let effort = order.among(efforts).onto(0, room.strain.effort);
        let missed = dot(axis, outer.force) + (x[0] + y[0] + z[0]) - effort;
        room.pivot.free = missed * room.minus_inverse;
        *gaps = C::zip(gaps, columns, |gap, w| (-missed).mul_add(dot(axis, w.torque), gap - dot(w.force, room.bias)));
        axes.force = add_scaled(outer.force, missed, room.pivot.per_linear);
        let force = axes.linear.apply_onto(room.bias, axes.force);
        let torque = add_scaled(outer.torque + moment, missed, room.pivot.per_angular);
        let torque = axes.coupling.transposed_onto(room.bias, torque);
        Internal { force, torque: cross_onto(arm, force, torque) }
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize>
    Takes<Spatial<T>, Swing<Spatial<T>, A, N, C>> for Prismatic<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces, .. }: &mut Swing<Spatial<T>, A, N, C>,
        inboard: Swung<T>,
        ((axes, room, columns), acceleration, ()): Of<'_, Spatial<T>, Swing<Spatial<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let inboard = inboard.acceleration();
        let ([axis, arm, _], angular) = (axes.axes.map(vector), inboard.angular);
        let carried = cross_onto(angular, arm, inboard.linear + room.bias);
        *acceleration = room.pivot.acceleration(carried, angular, &());
        C::zip(columns, forces, |w, by| *acceleration = dot(axis, w.torque).mul_add(by, *acceleration));
        let force = axes.coupling.apply_onto(angular, pulled::<T, C>(axes.force, columns, forces));
        let force = axes.linear.apply_onto(carried, force);
        let linear = add_scaled(carried, *acceleration, axis);
        let turned = [cross_onto(angular, axis, vector(axes.curls[0])), linear - inboard.linear];
        let [turned, moved] = turned.map(|second| scaled(second, order.twice));
        let beside = [force, scaled(angular, order.once)];
        axes.keep_slide(order.k + 1, [turned, moved], beside, acceleration.scale(order.twice));
        self.law().follow(&mut room.strain, order, *acceleration);
        Swung::At(Acceleration { linear, angular })
    }
}
