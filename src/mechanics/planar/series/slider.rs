//! Taylor series in the plane: what a joint that slides does.
//!
//! The outboard point is at r = s z from the inboard one, z along the line, ż = i z ω. Of each order r̈ = s̈ z₀ + i r₀ α + κ with
//! κ = s₀ p + (k + 1) (k + 2) Σ s_j z_{k+2−j} of what is known, j from 1 to k + 1, and p of z as for a body. The force F through the joint
//! has the part Re(z̄ F) = Q along the line, and the moment Im(r̄ F) about the inboard point. So eight convolutions: two sets of four lanes.

use super::{Articulated, Pushed, Swung, pulled};
use crate::mechanics::planar::{Acceleration, Internal, Planar, Slider, Turn};
use crate::relation::planar::algebra::{add_scaled, dot, normal, plus_dot};
use crate::relation::{Closures, Symmetric, Term};
use crate::scalar::Scalar;
use crate::series::{ExpandLaw, ExpandLoads};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector2;

/// What is convolved: z twice with ω twice and F; s twice and r with z of the next number and F across.
#[cfg_attr(optimised, inline(always))]
fn pairs<T: Scalar>((z, spin, force): (Vector2<T>, T, Vector2<T>), (s, r): (T, Vector2<T>)) -> [[[T; 4]; 2]; 2] {
    [[[z.x, z.y, z.x, z.y], [spin, spin, force.x, force.y]], [[s, s, r.x, r.y], [z.x, z.y, force.y, -force.x]]]
}

impl<T: Scalar, L: ExpandLaw<T, N>, const N: usize> Takes<Planar<T>, Begin<N>> for Slider<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (x, y, _, (position, rate), (axes, room)): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        let (z, r) = (Vector2::new(x[0], y[0]), Vector2::new(x[1], y[1]));
        (axes[0].axes, axes[0].lever) = (z, normal(r));
        room.place = *position;
        self.spring.begin(&mut room.strain, *position, *rate);
        let turned = normal(z) * turn.rate;
        let moved = add_scaled(normal(r) * turn.rate, *rate, z);
        let none = Vector2::new(T::zero(), T::zero());
        for (axes, [turned, turning]) in axes.iter_mut().zip(pairs((turned, turn.rate, none), (*rate, moved))) {
            axes.products.begin(turned, turning);
        }
        turn
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, C: Closures, const N: usize> Takes<Planar<T>, Articulate<Planar<T>, N, C>>
    for Slider<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Planar<T>, N, C>,
        Articulated { linear, coupling, angular, .. }: Articulated<T>,
        ([line, arm], room, columns): Of<'_, Planar<T>, Articulate<Planar<T>, N, C>, Self>,
    ) -> Articulated<T> {
        // Before the line yields in one set, after it in the other.
        let linear = linear.plus_diagonal(self.lumped);
        (arm.inner, arm.moment) = (linear, coupling);
        let (along, across) = (linear.apply(line.axes), dot(line.axes, coupling));
        room.minus_inverse = -dot(line.axes, along).recip();
        room.gain = along * room.minus_inverse;
        room.gain_of_turning = across * room.minus_inverse;
        let share = |w: Internal<T>| dot(line.axes, w.force);
        let reduced = C::map(&cuts.columns, |w| {
            let by = share(w);
            let torque = by.mul_add(room.gain_of_turning, w.torque);
            Internal { force: add_scaled(w.force, by, room.gain), torque }
        });
        *columns = C::zip(&cuts.columns, &reduced, |w, reduced| Internal { torque: share(w), ..reduced });
        (*cuts, _) = cuts.eliminated(room.minus_inverse, T::zero(), share, |w, _| w);
        cuts.columns = C::map(&reduced, |w| Internal { torque: plus_dot(w.torque, line.lever, w.force), ..w });
        let linear = linear.plus_outer(along, room.gain);
        let coupling = add_scaled(coupling, room.gain_of_turning, along);
        let angular = across.mul_add(room.gain_of_turning, angular);
        (line.inner, line.moment) = (linear, coupling);
        let swung = linear.apply_onto(line.lever, coupling);
        let angular = plus_dot(angular, line.lever, coupling + swung);
        Articulated { linear, coupling: swung, angular, lever: None }
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Planar<T>, N, InJoint: Term<T>>, C: Closures, const N: usize>
    Takes<Planar<T>, Push<Planar<T>, A, N, C>> for Slider<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Planar<T>, A, N, C>,
        outer: Pushed<T>,
        (([line, arm], room, columns), efforts, ()): Of<'_, Planar<T>, Push<Planar<T>, A, N, C>, Self>,
    ) -> Pushed<T> {
        let outer = outer.felt();
        let [x, y, along, more] = line.products.of(order.k);
        let curl = normal(Vector2::new(x.scale(order.next), y.scale(order.next)));
        let [u, v, moment, rest] = arm.products.of(order.k);
        let factor = T::constant(order.next * (order.next + num_traits::One::one()));
        let known = add_scaled(curl * room.place, factor, Vector2::new(u, v));
        (arm.curl, line.curl) = (curl, known);
        let force = arm.inner.apply_onto(known, outer.force);
        let torque = plus_dot(outer.torque, arm.moment, known);
        let missed = dot(line.axes, force) + (along + more) - order.among(efforts).add_to(room.strain.effort);
        room.free = missed * room.minus_inverse;
        // Columns are kept as they are once the line has yielded.
        let left = room.free - dot(room.gain, known);
        *gaps = C::zip(gaps, columns, |gap, w| (-w.torque).mul_add(left, gap - dot(w.force, known)));
        let force = add_scaled(force, missed, room.gain);
        line.known = force;
        let torque = missed.mul_add(room.gain_of_turning, torque + (moment + rest));
        Pushed::Felt(Internal { force, torque: plus_dot(torque, line.lever, force) })
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Planar<T>, N>, C: Closures, const N: usize>
    Takes<Planar<T>, Swing<Planar<T>, A, N, C>> for Slider<T, L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces, .. }: &mut Swing<Planar<T>, A, N, C>,
        inboard: Swung<T>,
        ((axes, room, columns), acceleration, ()): Of<'_, Planar<T>, Swing<Planar<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let (Acceleration { linear, angular }, [line, arm]) = (inboard.acceleration(), &*axes);
        let known = pulled::<T, C>(line.known, columns, forces);
        let carried = add_scaled(linear, angular, line.lever);
        *acceleration =
            plus_dot(room.gain_of_turning.mul_add(angular, room.held::<C>(columns, forces)), room.gain, carried);
        let outboard = add_scaled(carried + line.curl, *acceleration, line.axes);
        let force = line.inner.apply_onto(carried, add_scaled(known, angular, line.moment));
        let turned = add_scaled(arm.curl, angular, normal(line.axes));
        let half = |v: Vector2<T>| Vector2::new(v.x.scale(order.twice), v.y.scale(order.twice));
        let (turned, moved, slid) = (half(turned), half(outboard - linear), acceleration.scale(order.twice));
        let pairs = pairs((turned, angular.scale(order.once), force), (slid, moved));
        for (axes, [turned, turning]) in axes.iter_mut().zip(pairs) {
            axes.products.keep(order.k + 1, turned, turning);
        }
        self.spring.follow(&mut room.strain, order, *acceleration);
        Swung::At(Acceleration { linear: outboard, angular })
    }
}
