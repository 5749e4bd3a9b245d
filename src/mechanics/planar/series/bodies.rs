//! Taylor series in the plane: what bodies do.
//!
//! A body's axes are a complex number z, whose derivatives obey ż = i z ω. Its second one is z̈ = i z₀ α + p of each order, with p = i X and
//! X = (k + 1) Σ z_j ω_{k+1−j} of what is known, j from 1 on. With the outboard end o and the first moment μ in body axes, the force F on
//! what lies outboard of o (its point mass included) and the moment of inertia J,
//!
//! ```text
//! a′ = a + o z̈      f = F + μ z̈      τ = τ′ + J α + Im(z̄ Y)      Y = ō F + μ̄ a
//! ```
//!
//! so two convolutions give X and two the moment, whatever the body. Of a rod z is its arm, so that o is one and Y is F.

use super::{Articulated, pulled};
use crate::mechanics::planar::body::Base;
use crate::mechanics::planar::{Acceleration, Body, Internal, Planar, PointMass, RigidBody, Rod, Turn};
use crate::relation::planar::algebra::{Symmetric2, add_scaled, dot, normal, plus_dot};
use crate::relation::{Closures, Part, Symmetric};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector2;

/// What a body keeps of its axes; a joint that slides has two.
#[derive(Clone, Copy, Debug)]
pub struct AxesSeries<T, const N: usize> {
    /// z₀, and i o z₀.
    pub(super) axes: Vector2<T>,
    pub(super) lever: Vector2<T>,
    /// What p does to f (columns of x and y), to ō F and to the moment.
    pub(super) force: [Vector2<T>; 2],
    pub(super) inner: Symmetric2<T>,
    pub(super) moment: Vector2<T>,
    /// What α does to Y, as (y, −x).
    pub(super) swing: [T; 2],
    /// Of the present order: p, and what is known of Y.
    pub(super) curl: Vector2<T>,
    pub(super) known: Vector2<T>,
    /// What is convolved, four products in four lanes: z_j twice from j = 1 on;
    pub(super) turned: [[T; 4]; N],
    /// ω_j twice, and Y of the order before as (y, −x).
    pub(super) turning: [[T; 4]; N],
}

/// The number with the parts `by` times `v`.
#[inline(always)]
fn times<T: Scalar>(by: [T; 2], v: Vector2<T>) -> Vector2<T> {
    let [x, y] = by;
    Vector2::new(x.mul_add(v.x, -(y * v.y)), x.mul_add(v.y, y * v.x))
}

/// The number conjugate to `by` times `v`.
#[inline(always)]
fn back<T: Scalar>([x, y]: [T; 2], v: Vector2<T>) -> Vector2<T> {
    times([x, -y], v)
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    pub(super) fn new() -> Self {
        let (none, zero) = ([[T::zero(); 4]; N], Vector2::new(T::zero(), T::zero()));
        Self {
            axes: zero,
            lever: zero,
            force: [zero; 2],
            inner: Symmetric2::diagonal(T::zero()),
            moment: zero,
            swing: [T::zero(); 2],
            curl: zero,
            known: zero,
            turned: none,
            turning: none,
        }
    }

    /// Products of all coefficients whose numbers add up to `k`. Those of the newest come last: others need not wait for them. The rest
    /// goes two at a time.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn convolved(&self, k: usize) -> [T; 4] {
        let (Some((first, turned)), Some((last, turning))) =
            (self.turned[..=k].split_first(), self.turning[..=k].split_first())
        else {
            return [T::zero(); 4];
        };
        let (Some((newest, turned)), Some((recent, turning))) = (turned.split_last(), turning.split_last()) else {
            return core::array::from_fn(|i| first[i] * last[i]);
        };
        let ((few, turned), (turning, others)) = (turned.as_rchunks::<2>(), turning.as_chunks::<2>());
        let (mut even, mut odd) = ([T::zero(); 4], [T::zero(); 4]);
        if let ([a], [b]) = (few, others) {
            even = core::array::from_fn(|i| a[i] * b[i]);
        }
        for ([a, b], [c, d]) in turned.iter().zip(turning.iter().rev()) {
            even = core::array::from_fn(|i| a[i].mul_add(d[i], even[i]));
            odd = core::array::from_fn(|i| b[i].mul_add(c[i], odd[i]));
        }
        let sum: [T; 4] = core::array::from_fn(|i| first[i].mul_add(recent[i], even[i] + odd[i]));
        core::array::from_fn(|i| newest[i].mul_add(last[i], sum[i]))
    }
}

/// The body's unit of length: one, but for links along their x axis, whose posture is their arm.
#[cfg_attr(optimised, inline(always))]
fn base<T: Scalar, B: Body<T>>(body: &B) -> Base<T> {
    let base = body.base();
    match B::MOMENT {
        true => base,
        false => Base { outboard: [T::one(), T::zero()], ..base },
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const N: usize> Takes<Planar<T>, Begin<N>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut Begin<N>,
                turn: Turn<T>,
                (x, y, _, _, (room, ())): Of<'_, Planar<T>, Begin<N>, Self>,
            ) -> Turn<T> {
                let (axes, spin) = (Vector2::new(*x, *y), turn.rate);
                room.axes = axes;
                room.lever = if Self::MOMENT { normal(times(base(self).outboard, axes)) } else { normal(axes) };
                let [x, y]: [T; 2] = (normal(axes) * spin).into();
                room.turned[0] = [x, y, x, y];
                room.turning[0] = [spin, spin, T::zero(), T::zero()];
                turn
            }
        }
        impl<T: Scalar, C: Closures, const N: usize> Takes<Planar<T>, Articulate<Planar<T>, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                Articulate { cuts }: &mut Articulate<Planar<T>, N, C>,
                outer: Articulated<T>,
                (room, (), columns): Of<'_, Planar<T>, Articulate<Planar<T>, N, C>, Self>,
            ) -> Articulated<T> {
                let Base { outboard, moment, inertia, lumped } = base(self);
                let Articulated { linear, coupling, angular } = outer;
                let (linear, lever) = (linear.plus_diagonal(lumped), room.lever);
                let inner = |w: Vector2<T>| if Self::MOMENT { back(outboard, w) } else { w };
                *columns = C::map(&cuts.columns, |w| Internal { force: inner(w.force), torque: T::zero() });
                cuts.columns = C::map(&cuts.columns, |w| Internal { torque: plus_dot(w.torque, lever, w.force), ..w });
                let swung = linear.apply_onto(lever, coupling);
                let angular = plus_dot(angular + inertia, lever, coupling + swung);
                let coupling = if Self::MOMENT {
                    let [x, y] = outboard;
                    let along = [linear.apply(Vector2::new(x, y)), linear.apply(Vector2::new(-y, x))];
                    let [p, q] = along.map(|force| back(outboard, force));
                    room.inner = Symmetric2 { xx: p.x, xy: p.y, yy: q.y };
                    let [x, y] = moment;
                    room.force = [along[0] + Vector2::new(x, y), along[1] + Vector2::new(-y, x)];
                    room.moment = back(outboard, swung);
                    swung + normal(times(moment, room.axes))
                } else {
                    (room.inner, room.moment) = (linear, swung);
                    swung
                };
                room.swing = [room.moment.y, -room.moment.x];
                Articulated { linear, coupling, angular }
            }
        }
        impl<T: Scalar, Q: Part, C: Closures, const N: usize> Takes<Planar<T>, Push<Planar<T>, Q, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                Push { order, gaps, .. }: &mut Push<Planar<T>, Q, N, C>,
                outer: Internal<T>,
                ((room, (), columns), ()): Of<'_, Planar<T>, Push<Planar<T>, Q, N, C>, Self>,
            ) -> Internal<T> {
                let [x, y, m, n] = room.convolved(order.k);
                let curl = normal(Vector2::new(x.scale(order.next), y.scale(order.next)));
                let torque = plus_dot(plus_dot(m + n, room.moment, curl) + outer.torque, room.lever, outer.force);
                room.curl = curl;
                *gaps = C::zip(gaps, columns, |gap, w| gap - dot(w.force, curl));
                if Self::MOMENT {
                    let [along_x, along_y] = room.force;
                    room.known = room.inner.apply_onto(curl, back(base(self).outboard, outer.force));
                    Internal { force: add_scaled(add_scaled(outer.force, curl.x, along_x), curl.y, along_y), torque }
                } else {
                    room.known = room.inner.apply(curl) + outer.force;
                    Internal { force: room.known, torque }
                }
            }
        }
        impl<T: Scalar, C: Closures, const N: usize> Takes<Planar<T>, Swing<Planar<T>, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                walk: &mut Swing<Planar<T>, N, C>,
                inboard: Acceleration<T>,
                ((room, (), columns), ()): Of<'_, Planar<T>, Swing<Planar<T>, N, C>, Self>,
            ) -> Acceleration<T> {
                let (Swing { order, forces }, Acceleration { linear, angular }) = (walk, inboard);
                let known = pulled::<T, C>(room.known, columns, forces);
                let turned = add_scaled(room.curl, angular, normal(room.axes));
                let (force, outboard) = if Self::MOMENT {
                    let [along_x, along_y] = room.force;
                    let force = Vector2::new(plus_dot(known.x, along_x, linear), plus_dot(known.y, along_y, linear));
                    (force, linear + times(base(self).outboard, room.curl))
                } else {
                    (room.inner.apply_onto(linear, known), linear + room.curl)
                };
                // Last what waits for the inboard body.
                let outboard = add_scaled(outboard, angular, room.lever);
                if let (Some(axes), Some(spin)) = (room.turned.get_mut(order.k + 1), room.turning.get_mut(order.k + 1)) {
                    let (x, y) = (turned.x.scale(order.twice), turned.y.scale(order.twice));
                    *axes = [x, y, x, y];
                    // All lanes by the same operation: they are stored at once, and so can be loaded at once right after.
                    let (zero, once) = (T::zero(), T::constant(order.once));
                    let (parts, [y, x]) = ([zero, zero, force.y, -force.x], room.swing);
                    let weights = [once, once, y, x];
                    *spin = core::array::from_fn(|i| weights[i].mul_add(angular, parts[i]));
                }
                Acceleration { linear: outboard, angular }
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
