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
//! An axis that is turned in the inboard body turns all that lies outboard with it, and beyond the joint back: the costates of these two
//! turns, each in axes of its body, are summed up over the stages of a run.

use super::{InJoint, Outboard, Pulled, Stirred, Turning};
use crate::mechanics::planar::adjoint::ReversibleLaw;
use crate::mechanics::spatial::maps::about;
use crate::mechanics::spatial::{Acceleration, Revolute, Spatial, Wrench};
use crate::relation::Absent;
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{Factor3, add_scaled, cross, cross_onto, dot, dot_onto};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::factor::Factor;
use crate::walks::meet::Meet;
use crate::walks::pull_back::PullBack;
use crate::walks::reach::Reach;
use crate::walks::stir::Stir;

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Factor> for Revolute<T, L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Factor,
        outer: Outboard<T>,
        (axes, bias, .., (angle, rate), torque, [gain], pivot): Of<'_, Spatial<T>, Factor, Self>,
    ) -> Outboard<T> {
        let axis = axes.x;
        // The same quotient as in the elimination: it is formed once.
        *pivot = Factor3::of_number(dot(axis, outer.relation.angular.apply(axis)).recip());
        let (relation, found) =
            outer.relation.released(Way::Turn, axis, torque.0[0] + self.law.force(*angle, *rate), Absent);
        *gain = found;
        Outboard::rigid(relation.turning(bias[1]))
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Reach> for Revolute<T, L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Reach,
        inner: Acceleration<T>,
        (axes, bias, .., [gain], acceleration, _): Of<'_, Spatial<T>, Reach, Self>,
    ) -> Acceleration<T> {
        let angular = inner.angular + bias[1];
        *acceleration = gain.acceleration(inner.linear, angular, &());
        Acceleration { angular: add_scaled(angular, *acceleration, axes.x), ..inner }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Meet> for Revolute<T, L> {
    /// Δ q̇_w + U · (W, w_I) + s · m = λ, with q̇_w = free + gain · (W, w_I).
    #[inline(always)]
    fn take(
        &self,
        _: &mut Meet,
        outer: Wrench<T>,
        (axes, .., [gain], pivot, costate): Of<'_, Spatial<T>, Meet, Self>,
    ) -> Wrench<T> {
        let left = *costate - dot(axes.x, outer.torque);
        *costate = left * pivot.number();
        Wrench {
            force: add_scaled(outer.force, -left, gain.per_linear),
            torque: add_scaled(outer.torque, -left, gain.per_angular),
        }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, Stir> for Revolute<T, L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Stir,
        Stirred { velocity, turning: inner, attitude: inboard }: Stirred<T>,
        (axes, bias, .., [gain], (angle, rate, acceleration, free), ((), kept), torque): Of<'_, Spatial<T>, Stir, Self>,
    ) -> Stirred<T> {
        let axis = axes.x;
        let own = dot_onto(gain.per_linear, velocity, dot_onto(gain.per_angular, inner.stirring, *free));
        torque.0[0] += own;
        *free = own;
        let turning = Turning {
            spin: add_scaled(inner.spin, *rate, axis),
            acceleration: add_scaled(inner.acceleration + bias[1], *acceleration, axis),
            stirring: add_scaled(inner.stirring, own, axis),
        };
        let attitude = inboard.times(&about(self.axis, *angle));
        *kept = InJoint { turning, inner, attitudes: [inboard, attitude] };
        Stirred { velocity, turning, attitude }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, PullBack> for Revolute<T, L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (axes, .., (angle, rate, _, own), (.., kept, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let axis = axes.x;
        let InJoint { turning, inner, attitudes: [inboard, outboard] } = kept;
        let turned = outer.turned(*turning);
        let [of_angle, of_speed] = self.law.pull_back(*angle, *rate, *own, &mut sums.law);
        *of_position = of_angle + dot(axis, turned);
        sums.outboard = outboard.transposed_onto(turned, sums.outboard);
        let swept = dot_onto(axis, outer.spin, dot(cross(turning.spin, axis), outer.angular));
        *of_rate = of_speed - swept;
        let pulled = Pulled { spin: cross_onto(axis * *rate, outer.angular, outer.spin), ..outer };
        sums.inboard = inboard.transposed_onto(pulled.turned(*inner), sums.inboard);
        pulled
    }
}
