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

use super::AxesSeries;
use super::products::Rows;
use super::rods::scaled;
use crate::mechanics::spatial::{Acceleration, Internal, RigidBody, Spatial};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::{Columns, Symmetric3, add_scaled, cross, cross_onto, zero};
use crate::relation::{Part, Relation, Symmetric};
use crate::scalar::{Real, Scalar};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

/// The same of three vectors.
#[inline(always)]
fn each<T: Scalar>(vectors: Columns<T>, map: impl Fn(Vector3<T>) -> Vector3<T>) -> Columns<T> {
    Columns { x: map(vectors.x), y: map(vectors.y), z: map(vectors.z) }
}

/// Vectors side by side, entries as rows, and a last one beside them.
#[inline(always)]
fn rows<T: Scalar>(Columns { x, y, z }: &Columns<T>, last: Vector3<T>) -> Rows<T> {
    [[x.x, y.x, z.x, last.x], [x.y, y.y, z.y, last.y], [x.z, y.z, z.z, last.z]]
}

/// Three vectors from entries as rows.
#[inline(always)]
fn vectors<T: Scalar>([x, y, z]: &Rows<T>) -> Columns<T> {
    let of = |i: usize| Vector3::new(x[i], y[i], z[i]);
    Columns { x: of(0), y: of(1), z: of(2) }
}

impl<T: Scalar> RigidBody<T> {
    /// P.
    #[inline(always)]
    fn second_moments(&self) -> Symmetric3<T> {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = self.about_inboard;
        let half = (xx + yy + zz).scale(T::Real::of(0.5));
        Symmetric3 { xx: half - xx, xy: -xy, xz: -xz, yy: half - yy, yz: -yz, zz: half - zz }
    }
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Keeps axes of the next number, and angular velocity beside what is convolved with them.
    #[inline(always)]
    fn keep_axes(&mut self, number: usize, axes: &Columns<T>, forces: &Columns<T>, spin: Vector3<T>) {
        if let (Some(turned), Some(turning)) = (self.turned.get_mut(number), self.turning.get_mut(number)) {
            (*turned, *turning) = (rows(axes, zero()), rows(forces, spin));
        }
    }
}

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Begin<N>> for RigidBody<T> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Begin<N>,
        spin: Vector3<T>,
        (attitude, _, _, _, (room, ())): Of<'_, Spatial<T>, Begin<N>, Self>,
    ) -> Vector3<T> {
        room.axes = *attitude;
        let none = Columns { x: zero(), y: zero(), z: zero() };
        room.keep_axes(0, &each(*attitude, |axis| cross(spin, axis)), &none, spin);
        spin
    }
}

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Articulate<N>> for RigidBody<T> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Articulate<N>,
        outer: Full<T>,
        (room, ()): Of<'_, Spatial<T>, Articulate<N>, Self>,
    ) -> Full<T> {
        let of = |list: [T; 3]| room.axes.apply(Vector3::from(list));
        let full = outer.with_mass(self.lumped).carried(of(self.outboard()), zero());
        let moment = of(self.moment);
        (room.linear, room.coupling) = (full.linear, full.coupling);
        full.with_first_moment(moment, zero()).with_inertia(self.about_inboard.turned(&room.axes), zero())
    }
}

impl<T: Scalar, Q: Part, const N: usize> Takes<Spatial<T>, Push<Spatial<T>, Q, N>> for RigidBody<T> {
    #[inline(always)]
    fn take(
        &self,
        Push(order, _): &mut Push<Spatial<T>, Q, N>,
        outer: Internal<T>,
        ((room, ()), ()): Of<'_, Spatial<T>, Push<Spatial<T>, Q, N>, Self>,
    ) -> Internal<T> {
        let (moment, turning) = room.crossed(order.k);
        let curls = each(vectors(&turning), |v| scaled(v, order.next));
        let (axes, outboard) = (&room.axes, Vector3::from(self.outboard()));
        let arm = curls.apply(outboard);
        // What the body's own moments do.
        let own = curls.times(&self.second_moments().columns());
        let own = cross_onto(axes.x, own.x, cross_onto(axes.y, own.y, cross_onto(axes.z, own.z, moment)));
        let known = room.coupling.transposed_onto(arm, own) + outer.torque;
        (room.curls, room.force) = (curls, room.linear.apply_onto(arm, outer.force));
        Internal {
            force: curls.apply_onto(Vector3::from(self.moment), room.force),
            torque: cross_onto(axes.apply(outboard), outer.force, known),
        }
    }
}

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Swing<Spatial<T>, N>> for RigidBody<T> {
    #[inline(always)]
    fn take(
        &self,
        Swing(order): &mut Swing<Spatial<T>, N>,
        Acceleration { linear, angular }: Acceleration<T>,
        ((room, ()), ()): Of<'_, Spatial<T>, Swing<Spatial<T>, N>, Self>,
    ) -> Acceleration<T> {
        let (axes, curls) = (&room.axes, &room.curls);
        let turned = Columns {
            x: cross_onto(angular, axes.x, curls.x),
            y: cross_onto(angular, axes.y, curls.y),
            z: cross_onto(angular, axes.z, curls.z),
        };
        let outboard = self.outboard();
        let force = room.coupling.apply_onto(angular, room.linear.apply_onto(linear, room.force));
        let Columns { x, y, z } = turned.times(&self.second_moments().columns());
        let along = |i: usize, own| add_scaled(add_scaled(own, outboard[i], force), self.moment[i], linear);
        let forces = Columns { x: along(0, x), y: along(1, y), z: along(2, z) };
        let next = each(turned, |v| scaled(v, order.twice));
        room.keep_axes(order.k + 1, &next, &forces, scaled(angular, order.once));
        Acceleration { linear: turned.apply_onto(Vector3::from(outboard), linear), angular }
    }
}
