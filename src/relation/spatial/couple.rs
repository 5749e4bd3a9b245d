//! Torques in balls.

use super::Point;
use super::algebra::zero;
use crate::relation::{Absent, Closures, Join, Meet, Part, Promote, Reacting, Term};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A torque vector (N·m), inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Couple<T>(pub Vector3<T>);

impl<T: Scalar> Part for Couple<T> {
    fn is_finite(self) -> bool {
        super::algebra::is_finite(self.0)
    }
}

impl<T: Scalar> Term<Vector3<T>> for Couple<T> {
    fn none() -> Self {
        Self(zero())
    }
    #[inline(always)]
    fn add_to(self, sum: Vector3<T>) -> Vector3<T> {
        sum + self.0
    }
    #[inline(always)]
    fn take_from(self, sum: Vector3<T>) -> Vector3<T> {
        sum - self.0
    }
}

impl<T: Scalar> Reacting for Couple<T> {
    type Reaction = Self;
    #[inline(always)]
    fn reaction(self) -> Self {
        Self(-self.0)
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

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, Couple<T>, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { mass, offset, cuts, .. } = lesser;
        Self { mass, offset, torque: Couple(zero()), cuts }
    }
}

/// Links that end with a ball, inboard of a joint with a spring or a torque.
impl<T: Scalar, C: Closures> Meet<Point<T, Couple<T>, C>> for Point<T, Absent, C> {
    type Both = Point<T, Couple<T>, C>;
    #[inline(always)]
    fn of_links(own: Self) -> Self::Both {
        Promote::promote(own)
    }
    #[inline(always)]
    fn of_none(outer: Self::Both) -> Self::Both {
        outer
    }
}
