//! The costate sweep in space: what balls with a rotary spring do.
//!
//! The coordinate is the attitude of the outboard body relative to the inboard one, its rate q̇ and its torque in axes A of the outboard body. With
//! u = A q̇, ω = ω_I + u, α = α_I + ω_I × u + A q̈ and w = w_I + A q̇_w,
//!
//! ```text
//! Ψ̄ = Aᵀ(Θ + w_I × M + α_I × H + ω_I × (Ω + u × H))        q̇⁻ = −Aᵀ(Ω + H × ω_I)        τ̄ = q̇_w        then Ω ← Ω + u × H
//! ```
//!
//! for a turn Ψ of what lies outboard takes u along and leaves ω_I, α_I and w_I. The [law](super::rotary) acts as a torque does.

use super::rotary::{HingeRule, ReversibleRotary, add, strain};
use super::{Outboard, Pulled, Stirred, Turning};
use crate::adjoint::BodyLaw;
use crate::element::{Element, Reading};
use crate::mechanics::spatial::adjoint::Felt;
use crate::mechanics::spatial::elastic_hinge::Place;
use crate::mechanics::spatial::{Acceleration, ElasticHinge, Joint, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::cross_onto;
use crate::relation::spatial::{BallGain, Gain};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector3;

impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, Orient> for ElasticHinge<R> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Orient,
        turn: Turn<T>,
        (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
    ) -> Turn<T> {
        self.orient(position, rate, turn, x, y, p, q)
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>, By: HingeRule<T>> Takes<Spatial<T>, Factor<C, By>>
    for ElasticHinge<R>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (attitude, bias, .., (position, rate, led), torque, gain, pivot): Of<'_, Spatial<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let reading = Reading { position: led.0, rate: led.1, acceleration: led.2 };
        let place = Place { attitude: *attitude, state: (position, rate), reading };
        let torque = attitude.apply(Vector3::from(torque.0));
        let relation;
        (relation, *gain, *pivot) = walk.springs.turned_out(outer, &self.rotary, torque, place, bias[1]);
        relation
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Reach<T, C>> for ElasticHinge<R> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (attitude, bias, .., gain, acceleration, _): Of<'_, Spatial<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        Joint::recovered(self, inner, (attitude, bias), gain, &walk.forces, acceleration)
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Meet<T, C>> for ElasticHinge<R> {
    /// Δ w + H w_I + Kᵀ W + e_m = A λ, of the w in the joint.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (attitude, .., gain, pivot, costate, _): Of<'_, Spatial<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let left = attitude.apply(Vector3::from(*costate)) - outer.torque;
        *costate = pivot.factor.solve(left).into();
        walk.part_along(&gain.absolute.per_closure, left);
        Wrench {
            force: outer.force - gain.absolute.per_acceleration.transposed(left),
            torque: outer.torque - gain.per_angular.transposed(left),
        }
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Stir<T, C>> for ElasticHinge<R> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        Stirred { velocity, turning: inner }: Stirred<T>,
        (attitude, bias, .., gain, (_, rate, acceleration, free), ((), kept, _), torque): Of<
            '_,
            Spatial<T>,
            Stir<T, C>,
            Self,
        >,
    ) -> Stirred<T> {
        let gain = BallGain { absolute: Gain { free: Vector3::from(*free), ..gain.absolute }, ..*gain };
        let turned = gain.relative(velocity, inner.stirring, &walk.forces);
        let (own, stirring) = (attitude.transposed(turned), inner.stirring + turned);
        *free = own.into();
        torque.0 = (Vector3::from(torque.0) + own).into();
        kept.turning = inner;
        let [rate, acceleration] = [rate, acceleration].map(|list| attitude.apply(Vector3::from(*list)));
        let acceleration = inner.acceleration + bias[1] + acceleration;
        Stirred { velocity, turning: Turning { spin: inner.spin + rate, acceleration, stirring } }
    }
}

impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, PullBack> for ElasticHinge<R> {
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (position, rate, _, own), (_, _, _, kept, ..), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let (inner, moved) = (kept.turning, attitude.apply(Vector3::from(*rate)));
        let inboard = Pulled { spin: cross_onto(moved, outer.angular, outer.spin), ..outer };
        let mut found = [inboard.turned(inner), -cross_onto(outer.angular, inner.spin, outer.spin)]
            .map(|sum| attitude.transposed(sum));
        if walk.laws {
            let [turn, rate, of_law @ ..] = self.rotary.pull_back(position, rate, own);
            found = [found[0] + Vector3::from(turn), found[1] + Vector3::from(rate)];
            sums.add_rotary(&of_law);
        }
        [*of_position, *of_rate] = found.map(Into::into);
        inboard
    }
}

impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, Strain<T>> for ElasticHinge<R> {
    fn take(
        &self,
        walk: &mut Strain<T>,
        (): (),
        (_, _, w, sums, _, _, led, of_led): Of<'_, Spatial<T>, Strain<T>, Self>,
    ) {
        let [q, v, a] = strain(&self.rotary, walk, led, w, sums);
        add(of_led.0, q);
        add(of_led.1, v);
        add(of_led.2, a);
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Burden<T, C>> for ElasticHinge<R> {
    fn take(
        &self,
        walk: &mut Burden<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, (), gain, pivot): Of<'_, Spatial<T>, Burden<T, C>, Self>,
    ) -> Wrench<T> {
        let mut more = [T::zero(); 3];
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, gain, pivot, &mut more, &mut ()));
        gain.absolute.free += Vector3::from(more);
        inner
    }
}

impl<T: Scalar, L: BodyLaw<Spatial<T>>, R: ReversibleRotary<T>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>>
    for ElasticHinge<R>
{
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (attitude, .., (.., kept, _), _, (of_position, of_rate)): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        let turned = outer.turned_under::<L>(&kept.turning);
        *of_position = attitude.transposed_onto(turned, Vector3::from(*of_position)).into();
        *of_rate = attitude.transposed_onto(outer.spin, Vector3::from(*of_rate)).into();
        outer
    }
}
