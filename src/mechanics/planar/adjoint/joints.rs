//! The costate sweep in the plane: what joints do whose points coincide.

use super::{Outboard, Pulled, Stirred, Turning};
use crate::adjoint::laws::{ReversibleLaw, force, strain};
use crate::adjoint::passes;
use crate::element::Springs;
use crate::mechanics::planar::{Acceleration, ElasticHinge, Pin, Planar, PointMass, RigidBody, Rod, Weld, Wrench};
use crate::relation::Closures;
use crate::relation::planar::algebra::{add_scaled, plus_dot};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes, Walk};
use crate::walks::{Factor, Meet, PullBack, Reach, Stir, Strain};

impl<T: Scalar, C: Closures, By: Springs<T>> Takes<Planar<T>, Factor<C, By>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (.., torque, gain, pivot): Of<'_, Planar<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        // The same quotient as in the elimination: it is formed once.
        *pivot = outer.relation.angular.recip();
        let (relation, found) = outer.relation.pinned(*torque);
        *gain = found;
        Outboard::of_pin(relation)
    }
}

impl<T: Scalar, C: Closures> Takes<Planar<T>, Reach<T, C>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (.., gain, acceleration, _): Of<'_, Planar<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        *acceleration = gain.angular(inner.linear, &walk.forces);
        Acceleration { angular: *acceleration, ..inner }
    }
}

impl<T: Scalar, C: Closures> Takes<Planar<T>, Meet<T, C>> for Pin {
    /// D w + u · W + m = λ, with w = free + gain · W.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (.., gain, pivot, costate, _): Of<'_, Planar<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let left = *costate - outer.torque;
        *costate = left * *pivot;
        walk.part(&gain.per_closure, left);
        Wrench { force: add_scaled(outer.force, -left, gain.per_acceleration), torque: T::zero() }
    }
}

impl<T: Scalar, C: Closures> Takes<Planar<T>, Stir<T, C>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        inner: Stirred<T>,
        (.., gain, (_, rate, acceleration, free), _, torque): Of<'_, Planar<T>, Stir<T, C>, Self>,
    ) -> Stirred<T> {
        let linear = inner.velocity.linear;
        let w = C::plus_dot(plus_dot(*free, gain.per_acceleration, linear), &gain.per_closure, &walk.forces);
        // A torque acts on the outboard body and against the inboard one.
        *torque += w - inner.velocity.angular;
        *free = w;
        let turning = Turning { rate: *rate, acceleration: *acceleration, stirring: w };
        Stirred { velocity: Acceleration { linear, angular: w }, turning }
    }
}

impl<T: Scalar> Takes<Planar<T>, PullBack> for Pin {
    /// The coordinate is the absolute angle of what the pin turns: nothing of that is left for what lies inboard.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (.., (_, &rate, &acceleration, &stirring), _, _, (of_position, of_rate)): Of<'_, Planar<T>, PullBack, Self>,
    ) -> Pulled<T> {
        [*of_position, *of_rate] = outer.turned(Turning { rate, acceleration, stirring });
        Pulled { angular: T::zero(), ..outer.summed(None) }
    }
}

passes!(Planar, Weld<T>);

impl<T: Scalar, C: Closures> Takes<Planar<T>, Stir<T, C>> for Weld<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Stir<T, C>,
        inner: Stirred<T>,
        (.., ((), kept, _), _): Of<'_, Planar<T>, Stir<T, C>, Self>,
    ) -> Stirred<T> {
        kept.turning = inner.turning;
        inner
    }
}

impl<T: Scalar> Takes<Planar<T>, PullBack> for Weld<T> {
    /// The angle of a weld turns all that has been met since the last pin.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (.., (.., kept, _, _), (_, sums), _): Of<'_, Planar<T>, PullBack, Self>,
    ) -> Pulled<T> {
        sums[0] += outer.turned(kept.turning)[0];
        outer
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>, By: Springs<T>> Takes<Planar<T>, Factor<C, By>> for ElasticHinge<L> {
    /// Under an implicit rule the pivot knows the stiffness, and what lies inboard the moment.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (.., (position, rate, led), torque, gain, pivot): Of<'_, Planar<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let [of_law, stiffness] = force(&self.rotary, [*position, *rate], [*led.0, *led.1, *led.2], walk.springs);
        let torque = *torque + of_law;
        if const { By::STIFF } {
            *pivot = (outer.relation.angular + stiffness).recip();
            let (relation, found) = outer.relation.hinged(torque, stiffness);
            *gain = found;
            return Outboard::rigid(relation);
        }
        *pivot = outer.relation.angular.recip();
        let (relation, found) = outer.relation.pinned(torque);
        gain.absolute(found);
        Outboard::of_pin(relation)
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Reach<T, C>> for ElasticHinge<L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (.., gain, acceleration, _): Of<'_, Planar<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        *acceleration = gain.relative(inner.linear, inner.angular, &walk.forces);
        Acceleration { angular: inner.angular + *acceleration, ..inner }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Meet<T, C>> for ElasticHinge<L> {
    /// D w + U · (W, w_I) + m = λ, of the relative w.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (.., gain, pivot, costate, _): Of<'_, Planar<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let left = *costate - outer.torque;
        let torque = (-left).mul_add(gain.per_angular, outer.torque);
        *costate = left * *pivot;
        walk.part(&gain.per_closure, left);
        Wrench { force: add_scaled(outer.force, -left, gain.per_acceleration), torque }
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Planar<T>, Stir<T, C>> for ElasticHinge<L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        inner: Stirred<T>,
        (.., gain, (_, rate, acceleration, free), (_, kept, _), torque): Of<'_, Planar<T>, Stir<T, C>, Self>,
    ) -> Stirred<T> {
        let Acceleration { linear, angular } = inner.velocity;
        *free += gain.homogeneous().relative(linear, angular, &walk.forces);
        let w = angular + *free;
        *torque += *free;
        let inboard = inner.turning;
        let turning =
            Turning { rate: inboard.rate + *rate, acceleration: inboard.acceleration + *acceleration, stirring: w };
        kept.turning = turning;
        Stirred { velocity: Acceleration { linear, angular: w }, turning }
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Planar<T>, PullBack> for ElasticHinge<L> {
    /// The coordinate turns all that lies outboard, and so do those inboard of it. The law pushes against w.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (.., (position, rate, _, w), (.., kept, _, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Planar<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let turned = outer.turned(kept.turning);
        let of_law = if walk.laws { self.rotary.pull_back(*position, *rate, *w, sums) } else { [T::zero(); 2] };
        (*of_position, *of_rate) = (turned[0] + of_law[0], turned[1] + of_law[1]);
        outer.summed(Some(turned))
    }
}

/// Joints without a law.
macro_rules! lawless {
    ($($Joint:ty),*) => {$(
        impl<T: Scalar> Takes<Planar<T>, Strain<T>> for $Joint {
            #[inline(always)]
            fn take(&self, _: &mut Strain<T>, (): (), _: Of<'_, Planar<T>, Strain<T>, Self>) {}
        }
    )*};
}
lawless!(Pin, Weld<T>, Rod<T>, RigidBody<T>, PointMass<T>);

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Planar<T>, Strain<T>> for ElasticHinge<L> {
    fn take(
        &self,
        walk: &mut Strain<T>,
        (): (),
        (position, rate, w, sums, of_position, of_rate, led, of_led): Of<'_, Planar<T>, Strain<T>, Self>,
    ) {
        let at = ([*position, *rate, *w], [*led.0, *led.1, *led.2]);
        let ([more, also], [q, v, a]) = strain(const { !L::LINEAR }, &self.rotary, walk, at, sums);
        (*of_position, *of_rate) = (*of_position + more, *of_rate + also);
        if const { !L::LINEAR } {
            (*of_led.0, *of_led.1, *of_led.2) = (*of_led.0 + q, *of_led.1 + v, *of_led.2 + a);
        }
    }
}
