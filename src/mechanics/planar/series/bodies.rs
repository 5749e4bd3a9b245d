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
//! so two convolutions give p and two the moment, whatever the body: Im(z̄ Y) is i z · Y, so that all four have i z. Of a rod z is its arm,
//! so that o is one and Y is F.

use super::products::Products;
use super::{Articulated, Pushed, Swung, pulled};
use crate::mechanics::planar::body::Base;
use crate::mechanics::planar::{Acceleration, Body, Internal, Planar, PointMass, RigidBody, Rod, Turn};
use crate::relation::planar::algebra::{Symmetric2, add_scaled, dot, normal, plus_dot};
use crate::relation::{Closures, Symmetric};
use crate::scalar::Scalar;
use crate::series::{Borne, ExpandLoads, Order};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use core::array::from_fn;
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
    /// Of the present order: p, and what is known of Y.
    pub(super) curl: Vector2<T>,
    pub(super) known: Vector2<T>,
    /// How what it finds hangs on α, where this is a body.
    pub(super) found: Found<T>,
    /// What is convolved.
    pub(super) products: Products<T, N>,
}

/// How what a body finds hangs on α: of the next number i z and Y, four numbers side by side, and the newest products,
///
/// ```text
/// (i z, Y) = known + (A / (k + 1) (k + 2) + B) α      newest = (ω₀, i z₁) (i z, Y) + (i z₁, 0) α / (k + 1)
/// ```
///
/// entry by entry, A of i z alone and B of Y. So all but two products are at hand when α comes, for which the next order waits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found<T> {
    /// A and B.
    turned: [T; 4],
    pulled: [T; 4],
    /// What the newest products have of these four, and of ω.
    of_found: [T; 4],
    of_rate: [T; 4],
}

impl<T: Scalar> Found<T> {
    fn new() -> Self {
        let none = [T::zero(); 4];
        Self { turned: none, pulled: none, of_found: none, of_rate: none }
    }

    /// Of a body at z₀ with the rate ω₀, of i z₁ and of what α does to Y.
    #[inline(always)]
    fn of(axes: Vector2<T>, spin: T, turned: Vector2<T>, moment: Vector2<T>) -> Self {
        let zero = T::zero();
        Self {
            turned: [-axes.x, -axes.y, zero, zero],
            pulled: [zero, zero, moment.x, moment.y],
            of_found: [spin, spin, turned.x, turned.y],
            of_rate: [turned.x, turned.y, zero, zero],
        }
    }

    /// The four numbers of an angular acceleration, and the newest products.
    #[cfg_attr(optimised, inline(always))]
    fn by(&self, angular: T, known: [T; 4], order: &Order<T::Real>) -> [[T; 4]; 2] {
        let by_angular: [T; 4] = from_fn(|i| self.pulled[i].add_scaled(order.twice, self.turned[i]));
        let found: [T; 4] = from_fn(|i| by_angular[i].mul_add(angular, known[i]));
        let of_rate: [T; 4] = from_fn(|i| self.of_rate[i].scale(order.once) * angular);
        [found, from_fn(|i| self.of_found[i].mul_add(found[i], of_rate[i]))]
    }
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
        let zero = Vector2::new(T::zero(), T::zero());
        Self {
            axes: zero,
            lever: zero,
            force: [zero; 2],
            inner: Symmetric2::diagonal(T::zero()),
            moment: zero,
            curl: zero,
            known: zero,
            found: Found::new(),
            products: Products::new(),
        }
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
                let (axes, spin, zero) = (Vector2::new(*x, *y), turn.rate, T::zero());
                room.axes = axes;
                room.lever = if Self::MOMENT { normal(times(base(self).outboard, axes)) } else { normal(axes) };
                let [x, y]: [T; 2] = (axes * -spin).into();
                room.products.begin([x, y, x, y], [spin, spin, zero, zero]);
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
                let Articulated { linear, coupling, angular, .. } = outer;
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
                let [[x, y, ..], [spin, ..]] = room.products.start();
                room.found = Found::of(room.axes, spin, Vector2::new(x, y), room.moment);
                Articulated { linear, coupling, angular, lever: Some(lever) }
            }
        }
        impl<T: Scalar, A: ExpandLoads<Planar<T>, N>, C: Closures, const N: usize> Takes<Planar<T>, Push<Planar<T>, A, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                Push { order, gaps, .. }: &mut Push<Planar<T>, A, N, C>,
                outer: Pushed<T>,
                ((room, (), columns), (), load): Of<'_, Planar<T>, Push<Planar<T>, A, N, C>, Self>,
            ) -> Pushed<T> {
                let [x, y, m, n] = room.products.of(order.k);
                let (last, outer) = (matches!(outer, Pushed::None), outer.felt());
                let curl = Vector2::new(x.scale(order.next), y.scale(order.next));
                room.curl = curl;
                *gaps = C::zip(gaps, columns, |gap, w| gap - dot(w.force, curl));
                let force = if Self::MOMENT {
                    let [along_x, along_y] = room.force;
                    room.known = room.inner.apply_onto(curl, back(base(self).outboard, outer.force));
                    add_scaled(along_x * curl.x, curl.y, along_y)
                } else {
                    let force = room.inner.apply(curl);
                    room.known = force + outer.force;
                    force
                };
                let torque = room.moment.x.mul_add(curl.x, m) + room.moment.y.mul_add(curl.y, n) + outer.torque;
                let known = Internal { force, torque };
                let felt =
                    if last { Pushed::Felt(known) } else { Pushed::Levered { known, force: outer.force, lever: room.lever } };
                load.relieve(order, felt)
            }
        }
        impl<T: Scalar, A: ExpandLoads<Planar<T>, N>, C: Closures, const N: usize> Takes<Planar<T>, Swing<Planar<T>, A, N, C>> for $Body<T> {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                walk: &mut Swing<Planar<T>, A, N, C>,
                inboard: Swung<T>,
                ((room, (), columns), (), load): Of<'_, Planar<T>, Swing<Planar<T>, A, N, C>, Self>,
            ) -> Swung<T> {
                let Swing { order, forces, .. } = walk;
                load.note(order, inboard);
                let Acceleration { linear, angular } = inboard.acceleration();
                let known = pulled::<T, C>(room.known, columns, forces);
                let (force, moved) = if Self::MOMENT {
                    let [along_x, along_y] = room.force;
                    let force = Vector2::new(plus_dot(known.x, along_x, linear), plus_dot(known.y, along_y, linear));
                    (force, times(base(self).outboard, room.curl))
                } else {
                    (room.inner.apply_onto(linear, known), room.curl)
                };
                let still = normal(room.curl);
                // i z of the next number but one, and with ω of the next what is convolved of this one.
                let known = [still.x.scale(order.twice), still.y.scale(order.twice), force.x, force.y];
                let [[x, y, m, n], newest] = room.found.by(angular, known, order);
                let spin = angular.scale(order.once);
                room.products.keep_with(order.k + 1, [x, y, x, y], [spin, spin, m, n], newest);
                Swung::At(Acceleration { linear: inboard.beyond(moved, room.lever), angular })
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
