//! Taylor series in space: what a revolute joint does.
//!
//! Its axis n is a vector that turns with the inboard body. With q the angle, τ the torque through the joint and Q what acts about the
//! axis,
//!
//! ```text
//! ω′ = ω + q̇ n      α′ = α + q̈ n₀ + β      β = (k + 1) Σ q̇_{k+1−j} n_j      n · τ = Q
//! ```

use super::ball::Applied;
use super::products::{Rows, row, vector};
use super::rods::scaled;
use super::{AxesSeries, Swung, parted};
use crate::mechanics::spatial::{Acceleration, Drive, Internal, Revolute, Spatial};
use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot, zero};
use crate::relation::spatial::{Full, Pivot};
use crate::relation::{Absent, Closures, Symmetric, Way};
use crate::scalar::Scalar;
use crate::series::{ExpandLaw, ExpandLoads};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

/// Rows to be multiplied by the entries of the axis: the torque, the angular velocity across, the rate.
#[inline(always)]
fn beside<T: Scalar>(torque: Vector3<T>, spin: Vector3<T>, rate: T) -> Rows<T> {
    [[torque.x, spin.y, spin.z, rate], [torque.y, spin.z, spin.x, rate], [torque.z, spin.x, spin.y, rate]]
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Keeps the axis of the next number, and what is convolved with it.
    #[cfg_attr(optimised, inline(always))]
    fn keep_axis(&mut self, number: usize, axis: Vector3<T>, beside: Rows<T>) {
        if let (Some(turned), Some(turning)) = (self.turned.get_mut(number), self.turning.get_mut(number)) {
            turned[0] = row(axis);
            *turning = beside;
        }
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, const N: usize> Takes<Spatial<T>, Begin<N>> for Revolute<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        spin: Vector3<T>,
        (stored, _, _, (angle, rate), (axes, room)): Of<'_, Spatial<T>, Begin<N>, Self>,
    ) -> Vector3<T> {
        let axis = stored.x;
        axes.axes[0] = row(axis);
        axes.keep_axis(0, cross(spin, axis), beside(zero(), spin, *rate));
        self.law.begin(&mut room.strain, *angle, *rate);
        add_scaled(spin, *rate, axis)
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, C: Closures, const N: usize> Takes<Spatial<T>, Articulate<Spatial<T>, N, C>>
    for Revolute<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Spatial<T>, N, C>,
        outer: Full<T>,
        (axes, room, columns): Of<'_, Spatial<T>, Articulate<Spatial<T>, N, C>, Self>,
    ) -> Full<T> {
        let axis = vector(axes.axes[0]);
        room.minus_inverse = -dot(axis, outer.angular.apply(axis)).recip();
        let (full, Pivot { per_linear, per_angular, per_closure, .. }) =
            outer.cut(*cuts).released(Way::Turn, axis, T::zero(), Absent);
        (room.pivot.per_linear, room.pivot.per_angular) = (per_linear, per_angular);
        // Of each closure force the angular acceleration instead of the force, and the torque that is left.
        *columns = C::zip(&full.cuts.columns, &per_closure, |w, row| Internal { force: axis * row, ..w });
        (axes.coupling, axes.angular) = (full.coupling, full.angular);
        parted(full, cuts)
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Spatial<T>, N, InJoint: Applied<T>>, C: Closures, const N: usize>
    Takes<Spatial<T>, Push<Spatial<T>, A, N, C>> for Revolute<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Spatial<T>, A, N, C>,
        outer: Internal<T>,
        ((axes, room, columns), efforts, ()): Of<'_, Spatial<T>, Push<Spatial<T>, A, N, C>, Self>,
    ) -> Internal<T> {
        let [x, y, z] = axes.swept(order.k);
        // n × ω, the other way round.
        let turned = Vector3::new(z[2] - y[1], x[2] - z[1], y[2] - x[1]);
        axes.curls[0] = row(scaled(turned, order.next));
        room.bias = scaled(Vector3::new(x[3], y[3], z[3]), order.next);
        let effort = order.among(efforts).onto(0, room.strain.effort);
        let axis = vector(axes.axes[0]);
        let missed = dot(axis, outer.torque) + (x[0] + y[0] + z[0]) - effort;
        room.pivot.free = missed * room.minus_inverse;
        *gaps = C::zip(gaps, columns, |gap, w| (-missed).mul_add(dot(axis, w.force), gap - dot(w.torque, room.bias)));
        let force = add_scaled(outer.force, missed, room.pivot.per_linear);
        let torque = add_scaled(outer.torque, missed, room.pivot.per_angular);
        room.torque = axes.angular.apply_onto(room.bias, torque);
        Internal { force: axes.coupling.apply_onto(room.bias, force), torque: room.torque }
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize>
    Takes<Spatial<T>, Swing<Spatial<T>, A, N, C>> for Revolute<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces, .. }: &mut Swing<Spatial<T>, A, N, C>,
        inboard: Swung<T>,
        ((axes, room, columns), acceleration, ()): Of<'_, Spatial<T>, Swing<Spatial<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let Acceleration { linear, angular } = inboard.acceleration();
        let (axis, carried) = (vector(axes.axes[0]), angular + room.bias);
        *acceleration = room.pivot.acceleration(linear, carried, &());
        let mut torque = axes.coupling.transposed_onto(linear, axes.angular.apply_onto(angular, room.torque));
        C::zip(columns, forces, |w, by| {
            *acceleration = dot(axis, w.force).mul_add(by, *acceleration);
            torque = add_scaled(torque, by, w.torque);
        });
        let turned = scaled(cross_onto(angular, axis, vector(axes.curls[0])), order.twice);
        let (spin, rate) = (scaled(angular, order.once), acceleration.scale(order.once));
        axes.keep_axis(order.k + 1, turned, beside(torque, spin, rate));
        self.law.follow(&mut room.strain, order, *acceleration);
        inboard.turning(add_scaled(carried, *acceleration, axis))
    }
}
