//! The costate sweep in the plane: what a joint that slides does.
//!
//! The outboard point O is at s along e of the inboard body, turned by θ; d = s e, n = s e⊥, e⊥ = ẑ × e. With
//!
//! ```text
//! A_O = A_I + α n − ω² d + 2 ω ṡ e⊥ + s̈ e        W_O = W_I + w n + w_s e
//! ```
//!
//! and the point mass μ at O, G and F at O those of μ included,
//!
//! ```text
//! θ̄ = (α d + ω² n)·G + w d·F + (2 ω ṡ e − s̈ e⊥)·G − w_s e⊥·F         ω̄ = 2 ω d·G − 2 ṡ e⊥·G
//! s̄ = −(α e⊥ − ω² e)·G − w e⊥·F        ṡ̄ = −2 ω e⊥·G        μ̄ = −A_O·W_O        τ̄ = w_s
//! ```
//!
//! and the direction of the line has θ̄ of these.

use super::{Outboard, Pulled, Stirred};
use crate::adjoint::laws::{ReversibleLaw, force, strain};
use crate::element::Springs;
use crate::mechanics::planar::axes::{Axes, Inboard, across};
use crate::mechanics::planar::{Acceleration, Planar, Slider, Wrench};
use crate::relation::Closures;
use crate::relation::planar::algebra::{add_scaled, dot, normal, plus_dot};
use crate::relation::planar::along;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Factor, Meet, PullBack, Reach, Stir, Strain};

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>, By: Springs<T>> Takes<Planar<T>, Factor<C, By>> for Slider<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (x, y, p, q, (position, rate, led), effort, gain, pivot): Of<'_, Planar<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let offset = Inboard::offset(x, y, p, q);
        let linear = outer.relation.linear.along(offset.direction);
        let [of_law, stiffness] = force(&self.spring, [*position, *rate], [*led.0, *led.1, *led.2], walk.springs);
        *pivot = (linear.xx + self.lumped + stiffness).recip();
        let effort = *effort + of_law;
        Outboard::rigid(self.loosen(outer.relation, offset, effort, stiffness, gain))
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Reach<T, C>> for Slider<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (x, y, p, q, gain, acceleration, (_, reached, _)): Of<'_, Planar<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        let offset = Inboard::offset(x, y, p, q);
        let carried = inner.shifted(offset.arm, offset.acceleration);
        *acceleration = gain.relative(along(carried.linear, offset.direction), carried.angular, &walk.forces);
        *reached = add_scaled(carried.linear, *acceleration, offset.direction);
        Acceleration { linear: *reached, ..carried }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Meet<T, C>> for Slider<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, gain, pivot, costate, _): Of<'_, Planar<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let offset = Inboard::offset(x, y, p, q);
        let left = *costate - dot(offset.direction, outer.force);
        *costate = left * *pivot;
        walk.part(&gain.per_closure, left);
        let force = add_scaled(outer.force, -left, across(gain.per_acceleration, offset.direction));
        let torque = (-left).mul_add(gain.per_angular, outer.torque);
        Wrench { force, torque: plus_dot(torque, normal(offset.arm), force) }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Stir<T, C>> for Slider<T, L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        inner: Stirred<T>,
        (x, y, p, q, gain, (.., free), (_, kept, _), force): Of<'_, Planar<T>, Stir<T, C>, Self>,
    ) -> Stirred<T> {
        let offset = Inboard::offset(x, y, p, q);
        let carried = inner.velocity.swung(offset.arm);
        let w =
            *free + gain.homogeneous().relative(along(carried.linear, offset.direction), carried.angular, &walk.forces);
        *free = w;
        *force += w;
        kept.turning = inner.turning;
        kept.velocity = add_scaled(carried.linear, w, offset.direction);
        Stirred { velocity: Acceleration { linear: kept.velocity, ..carried }, ..inner }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Planar<T>, PullBack> for Slider<T, L> {
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (x, y, p, q, (position, rate, acceleration, w), (_, a, _, kept, _, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Planar<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let offset = Inboard::offset(x, y, p, q);
        let (line, d, turning) = (offset.direction, offset.arm, kept.turning);
        let (beside, n, two) = (normal(line), normal(d), T::one() + T::one());
        let momentum = add_scaled(outer.momentum, self.lumped, kept.velocity);
        let force = add_scaled(outer.force, self.lumped, *a);
        // Along the line and beside it.
        let (along_line, pull, push) = (dot(line, momentum), dot(beside, momentum), dot(beside, force));
        let spin2 = turning.rate * turning.rate;
        let twice = two * turning.rate;
        let none = [T::zero(); 2];
        let of_law = if walk.laws { self.spring.pull_back(*position, *rate, *w, &mut sums[2..]) } else { none };
        *of_position = of_law[0] + spin2 * along_line - turning.acceleration * pull - turning.stirring * push;
        *of_rate = of_law[1] - twice * pull;
        let line_turns = [twice * *rate * along_line - *acceleration * pull - *w * push, -(two * *rate * pull)];
        let arm = Pulled {
            momentum,
            force,
            along: dot(d, momentum),
            across: dot(n, momentum),
            lever: dot(d, force),
            angular: dot(n, momentum),
            beyond: Some(line_turns),
        };
        sums[0] += arm.turned(turning)[0];
        sums[1] -= dot(*a, kept.velocity);
        // G and F are those at the line; the sums are of the body inboard and outboard of it.
        outer.turning_alone() + arm
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Planar<T>, Strain<T>> for Slider<T, L> {
    fn take(
        &self,
        walk: &mut Strain<T>,
        (): (),
        (position, rate, w, sums, of_position, of_rate, led, of_led): Of<'_, Planar<T>, Strain<T>, Self>,
    ) {
        let at = ([*position, *rate, *w], [*led.0, *led.1, *led.2]);
        let ([more, also], [q, v, a]) = strain(const { !L::LINEAR }, &self.spring, walk, at, &mut sums[2..]);
        (*of_position, *of_rate) = (*of_position + more, *of_rate + also);
        if const { !L::LINEAR } {
            (*of_led.0, *of_led.1, *of_led.2) = (*of_led.0 + q, *of_led.1 + v, *of_led.2 + a);
        }
    }
}
