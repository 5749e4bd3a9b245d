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
use crate::element::Element;
use crate::mechanics::spatial::{Acceleration, Ball, Spatial, Turn, Wrench};
use crate::relation::spatial::Couple;
use crate::relation::spatial::algebra::{cross, zero};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::factor::Factor;
use crate::walks::meet::Meet;
use crate::walks::orient::Orient;
use crate::walks::pull_back::PullBack;
use crate::walks::reach::Reach;
use crate::walks::stir::Stir;
use nalgebra::Vector3;

impl<T: Scalar> Takes<Spatial<T>, Orient> for Ball {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Orient,
        turn: Turn<T>,
        (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
    ) -> Turn<T> {
        self.orient(position, rate, turn, x, y, p, q)
    }
}

impl<T: Scalar> Takes<Spatial<T>, Factor> for Ball {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Factor,
        outer: Outboard<T>,
        (attitude, .., torque, gain, pivot): Of<'_, Spatial<T>, Factor, Self>,
    ) -> Outboard<T> {
        // The same factors as in the elimination: they are formed once.
        *pivot = Pivot { factor: outer.relation.angular.factor(), torque: attitude.apply(Vector3::from(torque.0)) };
        let (relation, found) = outer.relation.balled(Couple(pivot.torque));
        *gain = found;
        Outboard::of_ball(relation)
    }
}

impl<T: Scalar> Takes<Spatial<T>, Reach<T>> for Ball {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Reach<T>,
        inner: Acceleration<T>,
        (attitude, .., gain, acceleration, _): Of<'_, Spatial<T>, Reach<T>, Self>,
    ) -> Acceleration<T> {
        let angular = gain.angular(inner.linear, &());
        *acceleration = attitude.transposed(angular).into();
        Acceleration { angular, ..inner }
    }
}

impl<T: Scalar> Takes<Spatial<T>, Meet<T>> for Ball {
    /// H w + Kᵀ W + e_m = A λ, with w = free + G W and G = −H⁻¹ Kᵀ; what is left in place of λ is free, in inertial axes.
    #[inline(always)]
    fn take(
        &self,
        _: &mut Meet<T>,
        outer: Wrench<T>,
        (attitude, .., gain, pivot, costate, _): Of<'_, Spatial<T>, Meet<T>, Self>,
    ) -> Wrench<T> {
        let left = attitude.apply(Vector3::from(*costate)) - outer.torque;
        *costate = pivot.factor.solve(left).into();
        Wrench { force: outer.force - gain.per_acceleration.transposed(left), torque: zero() }
    }
}

impl<T: Scalar> Takes<Spatial<T>, Stir<T>> for Ball {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Stir<T>,
        Stirred { velocity, turning: inner }: Stirred<T>,
        (attitude, .., gain, (rate, acceleration, free), ((), kept, _), torque): Of<'_, Spatial<T>, Stir<T>, Self>,
    ) -> Stirred<T> {
        let stirring = gain.per_acceleration.apply_onto(velocity, Vector3::from(*free));
        torque.0 = attitude.transposed_onto(stirring - inner.stirring, Vector3::from(torque.0)).into();
        *kept = inner;
        let [spin, acceleration] = [rate, acceleration].map(|list| attitude.apply(Vector3::from(*list)));
        Stirred { velocity, turning: Turning { spin, acceleration, stirring } }
    }
}

impl<T: Scalar> Takes<Spatial<T>, PullBack> for Ball {
    #[inline(always)]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (.., inner, pivot, _), _, (of_position, of_rate)): Of<'_, Spatial<T>, PullBack, Self>,
    ) -> Pulled<T> {
        let torque = pivot.torque;
        let turn = cross(torque, inner.stirring);
        *of_position = attitude.transposed(outer.turn - turn).into();
        *of_rate = attitude.transposed(-outer.spin).into();
        Pulled { turn, torque, angular: zero(), spin: zero(), ..outer }
    }
}
