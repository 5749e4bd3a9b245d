//! The costate sweep in space: what revolute joints do.
//!
//! With s the axis and ω, α, w those of the outboard body, of which ω_I + s q̇, α_I + s q̈ + ω_I × s q̇ and w_I + s q̇_w are made,
//!
//! ```text
//! q̄ = s·(Θ + w × M + α × H + ω × Ω)        q̇⁻ = −[s·Ω + (ω × s)·H]        τ̄ = q̇_w        then Ω ← Ω + (s q̇) × H
//! ```
//!
//! and what a spring or damper does is that of a torque.
//!
//! An axis that turns by θ in the inboard body turns all that lies outboard with it, and beyond the joint back by the same numbers in axes of
//! the outboard body. With Θ_O the bracket above and Θ_I what it is inboard of the joint, where motions are ω_I, α_I and w_I,
//!
//! ```text
//! Θ_I = Θ_O − s × X        X = q̇_w M + q̈ H + q̇ (Ω − ω_I × H)
//! ```
//!
//! The difference v of both, each in axes of its body, is across the axis. With a column e of the bodies' axes that is not along s, e_I and
//! e_O in inertial axes, u = e_I − e_O, and Y = X × s,
//!
//! ```text
//! v·e = e_I·Θ_I − e_O·Θ_O = u·Θ_O + e_I·Y        v·(s × e) = u·(Θ_O × s) + e_I·(Y × s)
//! ```

use super::{Outboard, Pulled, Stirred, Turning};
use crate::adjoint::laws::{ReversibleLaw, force, strain};
use crate::adjoint::{Reversed, unless_rows};
use crate::element::{Element, Springs};
use crate::mechanics::spatial::{Acceleration, Revolute, Spatial, Turn, Wrench};
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{Columns, add_scaled, cross, dot, dot_onto};
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Factor, Meet, Orient, PullBack, Reach, Stir, Strain};
use nalgebra::Vector3;

/// Adds what turns of the axis do, from Θ_O and X.
#[cfg_attr(optimised, inline(always))]
pub(super) fn of_axis<T: Scalar>(axes: &Columns<T>, turned: Vector3<T>, x: Vector3<T>, sum: &mut Vector3<T>) {
    let (axis, inboard, apart) = (axes.x, axes.y, axes.y - axes.z);
    let y = cross(x, axis);
    sum.x += dot_onto(apart, turned, dot(inboard, y));
    sum.y += dot_onto(apart, cross(turned, axis), dot(inboard, cross(y, axis)));
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>, By: Springs<T>> Takes<Spatial<T>, Factor<C, By>> for Revolute<T, L> {
    /// Under an implicit rule the pivot knows the stiffness.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (axes, bias, .., (angle, rate, led), torque, [gain], pivot): Of<'_, Spatial<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let [of_law, stiffness] = force(&self.law, [*angle, *rate], [*led.0, *led.1, *led.2], walk.springs);
        let (axis, torque) = (axes.x, torque.0[0] + of_law);
        // The same quotient as in the elimination: it is formed once.
        let inertia = dot(axis, outer.relation.angular.apply(axis));
        let (relation, found) = if const { By::STIFF } {
            pivot.factor.set_number((inertia + stiffness).recip());
            outer.relation.released(Way::Turn, axis, torque, stiffness)
        } else {
            pivot.factor.set_number(inertia.recip());
            outer.relation.released(Way::Turn, axis, torque, Absent)
        };
        *gain = found;
        Outboard::rigid(relation.turning(bias[1]))
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Spatial<T>, Reach<T, C>> for Revolute<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (axes, bias, .., [gain], acceleration, _): Of<'_, Spatial<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        let angular = inner.angular + bias[1];
        *acceleration = gain.acceleration(inner.linear, angular, &walk.forces);
        Acceleration { angular: add_scaled(angular, *acceleration, axes.x), ..inner }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Spatial<T>, Meet<T, C>> for Revolute<T, L> {
    /// Δ q̇_w + U · (W, w_I) + s · m = λ, with q̇_w = free + gain · (W, w_I).
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (axes, .., [gain], pivot, costate, _): Of<'_, Spatial<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let left = *costate - dot(axes.x, outer.torque);
        *costate = left * pivot.factor.number();
        walk.part(&gain.per_closure, left);
        Wrench {
            force: add_scaled(outer.force, -left, gain.per_linear),
            torque: add_scaled(outer.torque, -left, gain.per_angular),
        }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Spatial<T>, Stir<T, C>> for Revolute<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        Stirred { velocity, turning: inner }: Stirred<T>,
        (axes, bias, .., [gain], (_, rate, acceleration, free), ((), kept, _), torque): Of<
            '_,
            Spatial<T>,
            Stir<T, C>,
            Self,
        >,
    ) -> Stirred<T> {
        let axis = axes.x;
        let own = dot_onto(gain.per_linear, velocity, dot_onto(gain.per_angular, inner.stirring, *free));
        let own = C::plus_dot(own, &gain.per_closure, &walk.forces);
        torque.0[0] += own;
        *free = own;
        let turning = Turning {
            spin: add_scaled(inner.spin, *rate, axis),
            acceleration: add_scaled(inner.acceleration + bias[1], *acceleration, axis),
            stirring: add_scaled(inner.stirring, own, axis),
        };
        kept.turning = turning;
        Stirred { velocity, turning }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, PullBack> for Revolute<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (axes, .., (angle, rate, acceleration, own), (.., kept, _, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let (_, _, mut unread) = Spatial::of_nothing();
        let (axis, sums) = (axes.x, unless_rows::<T, _>(sums, &mut unread));
        let (turning, turned) = (kept.turning, outer.turned(kept.turning));
        let of_law = if walk.laws { self.law.pull_back(*angle, *rate, *own, &mut sums.law) } else { [T::zero(); 2] };
        let [of_angle, of_speed] = of_law;
        *of_position = of_angle + dot(axis, turned);
        let beside = cross(axis, outer.angular);
        *of_rate = of_speed - dot_onto(axis, outer.spin, dot(turning.spin, beside));
        let spin = add_scaled(outer.spin, *rate, beside);
        // Turns of the axis: Ω − ω_I × H = Ω + q̇ s × H − ω × H.
        let x = add_scaled(outer.torque * *own, *acceleration, outer.angular);
        let x = add_scaled(x, *rate, spin - cross(turning.spin, outer.angular));
        of_axis(axes, turned, x, &mut sums.turn);
        Pulled { spin, ..outer }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Strain<T>> for Revolute<T, L> {
    fn take(
        &self,
        walk: &mut Strain<T>,
        (): (),
        (angle, rate, w, sums, of_angle, of_rate, led, of_led): Of<'_, Spatial<T>, Strain<T>, Self>,
    ) {
        let at = ([*angle, *rate, *w], [*led.0, *led.1, *led.2]);
        let ([more, also], [q, v, a]) = strain(const { !L::LINEAR }, &self.law, walk, at, &mut sums.law);
        (*of_angle, *of_rate) = (*of_angle + more, *of_rate + also);
        if const { !L::LINEAR } {
            (*of_led.0, *of_led.1, *of_led.2) = (*of_led.0 + q, *of_led.1 + v, *of_led.2 + a);
        }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Orient> for Revolute<T, L> {
    /// Stores e in inertial axes as well, as either body turns it.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Orient,
        turn: Turn<T>,
        (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
    ) -> Turn<T> {
        let outboard = self.orient(position, rate, turn, x, y, p, q);
        let (inner, outer) = (&turn.attitude, &outboard.attitude);
        [x.y, x.z] = self.aside([inner.x, outer.x], [inner.y, outer.y]);
        outboard
    }
}
