//! Sums of relations at one station: where an arm leaves a chain, their forces add up.

use super::{Empty, Full, Point, Slides};
use crate::relation::{Closures, Join, Term};
use crate::scalar::Scalar;

impl<A: Copy> Join<A> for Empty {
    type Out = A;
    #[inline(always)]
    fn join(self, arm: A) -> A {
        arm
    }
}

impl<T: Scalar, C: Closures> Join<Full<T>> for Full<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Full<T>) -> Self {
        Self {
            linear: self.linear.plus(arm.linear),
            coupling: self.coupling + arm.coupling,
            angular: self.angular + arm.angular,
            force: self.force + arm.force,
            torque: self.torque + arm.torque,
            cuts: self.cuts,
        }
    }
}

impl<T: Scalar, M: Term<T>, C: Closures> Join<Point<T, M>> for Full<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Point<T, M>) -> Self {
        Self {
            linear: self.linear.plus(arm.stiffness),
            force: self.force + arm.offset,
            torque: arm.torque.add_to(self.torque),
            ..self
        }
    }
}

impl<T: Scalar, M: Term<T>, C: Closures> Join<Full<T>> for Point<T, M, C> {
    type Out = Full<T, C>;
    #[inline(always)]
    fn join(self, arm: Full<T>) -> Full<T, C> {
        self.full().join(arm)
    }
}

impl<T: Scalar, M: Join<N>, N: Copy, C: Closures> Join<Point<T, N>> for Point<T, M, C> {
    type Out = Point<T, M::Out, C>;
    #[inline(always)]
    fn join(self, arm: Point<T, N>) -> Self::Out {
        Point {
            stiffness: self.stiffness.plus(arm.stiffness),
            offset: self.offset + arm.offset,
            torque: self.torque.join(arm.torque),
            cuts: self.cuts,
        }
    }
}
