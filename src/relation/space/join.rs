//! Sums of relations at one station: where an arm leaves a chain, their forces add up.

use super::algebra::zero;
use super::{Couple, Empty, Full, Point, Relation};
use crate::relation::{Absent, Closures, Join, Term};
use crate::scalar::Scalar;
use nalgebra::Vector3;

impl<A: Copy> Join<A> for Empty {
    type Out = A;
    #[inline(always)]
    fn join(self, arm: A) -> A {
        arm
    }
}

impl<T: Scalar> Join<Self> for Couple<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Self) -> Self {
        Self(self.0 + arm.0)
    }
}

impl<T: Scalar> Join<Absent> for Couple<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, _: Absent) -> Self {
        self
    }
}

impl<T: Scalar, C: Closures> Join<Full<T>> for Full<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Full<T>) -> Self {
        Self {
            linear: self.linear.plus(arm.linear),
            coupling: self.coupling.plus(arm.coupling),
            angular: self.angular.plus(arm.angular),
            force: self.force + arm.force,
            torque: self.torque + arm.torque,
            cuts: self.cuts,
        }
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Join<Point<T, M>> for Full<T, C> {
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

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Join<Full<T>> for Point<T, M, C> {
    type Out = Full<T, C>;
    #[inline(always)]
    fn join(self, arm: Full<T>) -> Full<T, C> {
        self.carried(zero(), zero()).join(arm)
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
