//! The costate sweep in space: what balls do.
//!
//! The coordinate is the absolute attitude of what the ball turns, its rate and its torque τ are in axes A of that body. All that has been
//! met since the last balls turns with it, vectors and motion; what lies inboard knows of it by the torque A τ alone, which does
//! −(A τ)·(w − w_I) in P:
//!
//! ```text
//! Ψ̄ = Aᵀ(Θ + w_I × A τ)        ω̄ = −AᵀΩ        τ̄ = Aᵀ(w − w_I)        then Θ = A τ × w_I, M = A τ, H = Ω = 0
//! ```

use super::{Outboard, Pivot, Pulled, Stirred, Turning};
use crate::element::{Element, Springs};
use crate::mechanics::spatial::{Acceleration, Ball, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{cross, zero};
use crate::relation::spatial::{Couple, Gain};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Factor, Meet, Orient, PullBack, Reach, Stir};
use nalgebra::Vector3;

impl<T: Scalar> Takes<Spatial<T>, Orient> for Ball {
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

impl<T: Scalar, C: Closures, By: Springs<T>> Takes<Spatial<T>, Factor<C, By>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (attitude, .., torque, gain, pivot): Of<'_, Spatial<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        // The same factors as in the elimination: they are formed once.
        *pivot = Pivot { factor: outer.relation.angular.factor(), torque: attitude.apply(Vector3::from(torque.0)) };
        let (relation, found) = outer.relation.balled(Couple(pivot.torque));
        *gain = found;
        Outboard::of_ball(relation)
    }
}

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Reach<T, C>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (attitude, .., gain, acceleration, _): Of<'_, Spatial<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        let angular = gain.angular(inner.linear, &walk.forces);
        *acceleration = attitude.transposed(angular).into();
        Acceleration { angular, ..inner }
    }
}

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Meet<T, C>> for Ball {
    /// H w + Kᵀ W + e_m = A λ, with w = free + G W and G = −H⁻¹ Kᵀ; what is left in place of λ is free, in inertial axes.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (attitude, .., gain, pivot, costate, _): Of<'_, Spatial<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let left = attitude.apply(Vector3::from(*costate)) - outer.torque;
        *costate = pivot.factor.solve(left).into();
        walk.part_along(&gain.per_closure, left);
        Wrench { force: outer.force - gain.per_acceleration.transposed(left), torque: zero() }
    }
}

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Stir<T, C>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        Stirred { velocity, turning: inner }: Stirred<T>,
        (attitude, .., gain, (_, rate, acceleration, free), ((), kept, _), torque): Of<
            '_,
            Spatial<T>,
            Stir<T, C>,
            Self,
        >,
    ) -> Stirred<T> {
        let stirring = Gain { free: Vector3::from(*free), ..*gain }.angular(velocity, &walk.forces);
        *free = attitude.transposed(stirring).into();
        torque.0 = attitude.transposed_onto(stirring - inner.stirring, Vector3::from(torque.0)).into();
        kept.turning = inner;
        let [spin, acceleration] = [rate, acceleration].map(|list| attitude.apply(Vector3::from(*list)));
        Stirred { velocity, turning: Turning { spin, acceleration, stirring } }
    }
}

impl<T: Scalar> Takes<Spatial<T>, PullBack> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (.., inner, pivot, _), _, (of_position, of_rate)): Of<'_, Spatial<T>, PullBack, Self>,
    ) -> Pulled<T> {
        let torque = if walk.torques { pivot.torque } else { zero() };
        let turn = cross(torque, inner.turning.stirring);
        *of_position = attitude.transposed(outer.turn - turn).into();
        *of_rate = attitude.transposed(-outer.spin).into();
        Pulled { turn, torque, angular: zero(), spin: zero(), ..outer }
    }
}
