//! Sums of relations at one station: where an arm leaves a chain, their forces add up.

use super::{Closures, Empty, Full, Geometry, Join, Point, Term};

impl<A: Copy> Join<A> for Empty {
    type Out = A;
    #[inline(always)]
    fn join(self, arm: A) -> A {
        arm
    }
}

impl<G: Geometry, C: Closures> Join<Full<G>> for Full<G, C> {
    type Out = Self;
    #[cfg_attr(optimised, inline(always))]
    fn join(self, arm: Full<G>) -> Self {
        Self {
            linear: self.linear + arm.linear,
            coupling: self.coupling + arm.coupling,
            angular: self.angular + arm.angular,
            force: self.force + arm.force,
            torque: self.torque + arm.torque,
            cuts: self.cuts,
        }
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures> Join<Point<G, M>> for Full<G, C> {
    type Out = Self;
    #[cfg_attr(optimised, inline(always))]
    fn join(self, arm: Point<G, M>) -> Self {
        Self {
            linear: self.linear + arm.mass,
            force: self.force + arm.offset,
            torque: arm.torque.add_to(self.torque),
            ..self
        }
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures> Join<Full<G>> for Point<G, M, C> {
    type Out = Full<G, C>;
    #[inline(always)]
    fn join(self, arm: Full<G>) -> Full<G, C> {
        self.whole().join(arm)
    }
}

impl<G: Geometry, M: Join<N>, N: Copy, C: Closures> Join<Point<G, N>> for Point<G, M, C> {
    type Out = Point<G, M::Out, C>;
    #[cfg_attr(optimised, inline(always))]
    fn join(self, arm: Point<G, N>) -> Self::Out {
        Point {
            mass: self.mass + arm.mass,
            offset: self.offset + arm.offset,
            torque: self.torque.join(arm.torque),
            cuts: self.cuts,
        }
    }
}
