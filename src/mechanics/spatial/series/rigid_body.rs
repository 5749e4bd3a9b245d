//! Taylor series in space: what rigid bodies do.
//!
//! The body's axes e_i are three vectors that turn. With the outboard end o = Σ o_i e_i, the first moment μ = Σ μ_i e_i, the second
//! moments P = ½ tr J 1 − J about the inboard end in body axes, and F the force on what lies outboard of o (its point mass included),
//!
//! ```text
//! a′ = a + ö      f = F + μ̈      τ = τ′ + Σ e_i × Y_i      Y_i = o_i F + μ_i a + Σ P_ij ë_j
//! ```
//!
//! for the angular momentum about the inboard end is Σ P_ij e_i × ė_j + μ × v.

use super::products::{Rows, curl, none, row, scaled as scaled_rows, swing};
use super::rods::scaled;
use super::{AxesSeries, Swung, parted, pulled};
use crate::mechanics::spatial::{Acceleration, Internal, RigidBody, Spatial};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::{Columns, Symmetric3, cross, cross_onto, dot, zero};
use crate::relation::{Closures, Relation, Symmetric};
use crate::scalar::{Real, Scalar};
use crate::series::{Borne, ExpandLoads};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

/// Vectors side by side, entries as rows.
#[inline(always)]
fn side_by_side<T: Scalar>(Columns { x, y, z }: &Columns<T>) -> Rows<T> {
    let o = T::zero();
    [[x.x, y.x, z.x, o], [x.y, y.y, z.y, o], [x.z, y.z, z.z, o]]
}

/// The sum of vectors side by side, each times a number.
#[inline(always)]
fn combined<T: Scalar>([x, y, z]: &Rows<T>, [a, b, c]: [T; 3]) -> Vector3<T> {
    let of = |row: &[T; 4]| row[0].mul_add(a, row[1].mul_add(b, row[2] * c));
    Vector3::new(of(x), of(y), of(z))
}

impl<T: Scalar> RigidBody<T> {
    /// P.
    #[cfg_attr(optimised, inline(always))]
    fn second_moments(&self) -> Symmetric3<T> {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = self.about_inboard;
        let half = (xx + yy + zz).scale(T::Real::of(0.5));
        Symmetric3 { xx: half - xx, xy: -xy, xz: -xz, yy: half - yy, yz: -yz, zz: half - zz }
    }
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Keeps axes of the next number, and angular velocity beside what is convolved with them.
    #[cfg_attr(optimised, inline(always))]
    fn keep_axes(&mut self, number: usize, axes: Rows<T>, forces: &Rows<T>, spin: Vector3<T>) {
        if let (Some(turned), Some(turning)) = (self.turned.get_mut(number), self.turning.get_mut(number)) {
            let [x, y, z] = forces;
            *turned = axes;
            *turning = [[x[0], x[1], x[2], spin.x], [y[0], y[1], y[2], spin.y], [z[0], z[1], z[2], spin.z]];
        }
    }
}

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Begin<N>> for RigidBody<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        spin: Vector3<T>,
        (attitude, _, _, _, (room, ())): Of<'_, Spatial<T>, Begin<N>, Self>,
    ) -> Vector3<T> {
        let Columns { x, y, z } = *attitude;
        room.axes = side_by_side(attitude);
        room.shares = [self.outboard(), self.moment].map(|share| row(share.into()));
        room.moments = side_by_side(&self.second_moments().columns());
        let turned = Columns { x: cross(spin, x), y: cross(spin, y), z: cross(spin, z) };
        room.keep_axes(0, side_by_side(&turned), &none(), spin);
        spin
    }
}

impl<T: Scalar, C: Closures, const N: usize> Takes<Spatial<T>, Articulate<Spatial<T>, N, C>> for RigidBody<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Spatial<T>, N, C>,
        outer: Full<T>,
        (room, (), columns): Of<'_, Spatial<T>, Articulate<Spatial<T>, N, C>, Self>,
    ) -> Full<T> {
        let of = |list: [T; 3]| combined(&room.axes, list);
        *columns = cuts.columns;
        let full = outer.cut(*cuts).with_mass(self.lumped).carried(of(self.outboard()), zero());
        let (moment, axis) =
            (of(self.moment), |i: usize| Vector3::new(room.axes[0][i], room.axes[1][i], room.axes[2][i]));
        let attitude = Columns { x: axis(0), y: axis(1), z: axis(2) };
        (room.linear, room.coupling) = (full.linear, full.coupling);
        let inertia = self.about_inboard.turned(&attitude);
        parted(full.with_first_moment(moment, zero()).with_inertia(inertia, zero()), cuts)
    }
}

impl<T: Scalar, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize> Takes<Spatial<T>, Push<Spatial<T>, A, N, C>>
    for RigidBody<T>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Spatial<T>, A, N, C>,
        outer: Internal<T>,
        ((room, (), columns), (), load): Of<'_, Spatial<T>, Push<Spatial<T>, A, N, C>, Self>,
    ) -> Internal<T> {
        let [curls, moment] = curl(room.known(order.k), (&room.axes, &room.moments), order.next);
        let arm = combined(&curls, self.outboard());
        *gaps = C::zip(gaps, columns, |gap, w| gap - dot(w.force, arm));
        let moment = combined(&moment, [T::one(); 3]) + outer.torque;
        (room.curls, room.force) = (curls, room.linear.apply_onto(arm, outer.force));
        let lever = combined(&room.axes, self.outboard());
        let torque = cross_onto(lever, outer.force, room.coupling.transposed_onto(arm, moment));
        load.relieve(order, Internal { force: room.force + combined(&curls, self.moment), torque })
    }
}

impl<T: Scalar, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize>
    Takes<Spatial<T>, Swing<Spatial<T>, A, N, C>> for RigidBody<T>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces: by, .. }: &mut Swing<Spatial<T>, A, N, C>,
        inboard: Swung<T>,
        ((room, (), columns), (), load): Of<'_, Spatial<T>, Swing<Spatial<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        load.note(order, inboard);
        let Acceleration { linear, angular } = inboard.acceleration();
        let force = room.pulled(inboard, pulled::<T, C>(room.force, columns, by));
        let [turned, forces] = swing((&room.axes, &room.moments, &room.curls), angular, (&room.shares, force, linear));
        room.keep_axes(order.k + 1, scaled_rows(&turned, order.twice), &forces, scaled(angular, order.once));
        Swung::At(Acceleration { linear: linear + combined(&turned, self.outboard()), angular })
    }
}
