//! The costate sweep in the plane: what joints do.

use super::{Pulled, Stirred};
use crate::adjoint::Takes;
use crate::planar::{Pin, Planar, Weld, Wrench};
use crate::relation::plane::Full;
use crate::relation::plane::algebra::{add_scaled, plus_dot};
use crate::scalar::Scalar;
use crate::shape::Of;
use crate::walks::factor::Factor;
use crate::walks::meet::Meet;
use crate::walks::pull_back::PullBack;
use crate::walks::stir::Stir;

impl<T: Scalar> Takes<Planar<T>, Factor> for Pin {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Factor,
        outer: Full<T>,
        (.., torque, gain, pivot): Of<'_, Planar<T>, Factor, Self>,
    ) -> Full<T> {
        // The same quotient as in the elimination: it is formed once.
        *pivot = outer.angular.recip();
        let (relation, found) = outer.pinned(*torque);
        *gain = found;
        // Its torque on the outboard part acts on the inboard one as well.
        relation.whole()
    }
}

impl<T: Scalar> Takes<Planar<T>, Meet> for Pin {
    /// D w + u · W + m = λ, with w = free + gain · W.
    #[inline(always)]
    fn take(
        &self,
        _: &mut Meet,
        outer: Wrench<T>,
        (.., gain, pivot, costate): Of<'_, Planar<T>, Meet, Self>,
    ) -> Wrench<T> {
        let left = *costate - outer.torque;
        *costate = left * *pivot;
        Wrench { force: add_scaled(outer.force, -left, gain.per_acceleration), torque: T::zero() }
    }
}

impl<T: Scalar> Takes<Planar<T>, Stir> for Pin {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Stir,
        inner: Stirred<T>,
        (.., gain, rate, acceleration, free, (), torque): Of<'_, Planar<T>, Stir, Self>,
    ) -> Stirred<T> {
        let Stirred { acceleration: mut at, mut stirring, .. } = inner;
        let w = plus_dot(*free, gain.per_acceleration, stirring.linear);
        // A torque acts on the outboard body and against the inboard one.
        *torque += w - stirring.angular;
        stirring.angular = w;
        at.angular = *acceleration;
        Stirred { acceleration: at, stirring, rate: *rate }
    }
}

impl<T: Scalar> Takes<Planar<T>, PullBack> for Pin {
    /// Its coordinate is the absolute angle of what it turns: nothing of that is left for what lies inboard.
    #[inline(always)]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (.., position, rate): Of<'_, Planar<T>, PullBack, Self>,
    ) -> Pulled<T> {
        (*position, *rate) = (outer.angle, outer.rate);
        Pulled { angle: T::zero(), rate: T::zero(), ..outer }
    }
}

impl<T: Scalar> Takes<Planar<T>, Factor> for Weld<T> {
    #[inline(always)]
    fn take(&self, _: &mut Factor, outer: Full<T>, _: Of<'_, Planar<T>, Factor, Self>) -> Full<T> {
        outer
    }
}

impl<T: Scalar> Takes<Planar<T>, Meet> for Weld<T> {
    #[inline(always)]
    fn take(&self, _: &mut Meet, outer: Wrench<T>, _: Of<'_, Planar<T>, Meet, Self>) -> Wrench<T> {
        outer
    }
}

impl<T: Scalar> Takes<Planar<T>, Stir> for Weld<T> {
    #[inline(always)]
    fn take(&self, _: &mut Stir, inner: Stirred<T>, _: Of<'_, Planar<T>, Stir, Self>) -> Stirred<T> {
        inner
    }
}

impl<T: Scalar> Takes<Planar<T>, PullBack> for Weld<T> {
    /// Its angle turns all that has been met since the last pin.
    #[inline(always)]
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (.., sum, (), ()): Of<'_, Planar<T>, PullBack, Self>,
    ) -> Pulled<T> {
        *sum += outer.angle;
        outer
    }
}
