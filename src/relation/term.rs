//! Terms of sums that a scene may or may not have, and what is absent.

use super::Join;
use crate::scalar::Scalar;
use core::fmt::Debug;

/// A part that a scene does not have: it takes no space and no instruction.
///
/// A zero would not do: compilers may fold neither `x + 0.0` nor `0.0 * x`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Absent;

/// A value that a scene may or may not have.
pub trait Part: Copy + Debug + 'static {
    /// Whether the value is finite; nothing is.
    fn is_finite(self) -> bool;

    /// Whether two values are known to be the same, derivative parts included; nothing is nothing.
    fn is_same(self, other: Self) -> bool {
        let _ = other;
        false
    }
}

impl Part for Absent {
    fn is_finite(self) -> bool {
        true
    }
    fn is_same(self, _: Self) -> bool {
        true
    }
}

impl<T: Scalar> Part for T {
    fn is_finite(self) -> bool {
        Scalar::is_finite(self)
    }
    fn is_same(self, other: Self) -> bool {
        Scalar::is_identical(self, other)
    }
}

/// Something that adds to a sum, or is [`Absent`], decided by type.
pub trait Term<T>: Part {
    /// Zero, or nothing.
    fn none() -> Self;
    /// `self + sum`.
    fn add_to(self, sum: T) -> T;
    /// `sum − self`.
    fn take_from(self, sum: T) -> T;
}

impl<T> Term<T> for Absent {
    fn none() -> Self {
        Self
    }
    #[inline(always)]
    fn add_to(self, sum: T) -> T {
        sum
    }
    #[inline(always)]
    fn take_from(self, sum: T) -> T {
        sum
    }
}

impl<T: Scalar> Term<T> for T {
    fn none() -> Self {
        T::zero()
    }
    #[inline(always)]
    fn add_to(self, sum: T) -> T {
        sum + self
    }
    #[inline(always)]
    fn take_from(self, sum: T) -> T {
        sum - self
    }
}

/// A term whose opposite is one too: the torque in a joint, and what it does on the other side.
pub trait Reacting: Copy {
    /// The opposite.
    type Reaction: Copy;
    /// −self.
    fn reaction(self) -> Self::Reaction;
}

impl Reacting for Absent {
    type Reaction = Self;
    #[inline(always)]
    fn reaction(self) -> Self {
        self
    }
}

impl<T: Scalar> Reacting for T {
    type Reaction = Minus<T>;
    #[inline(always)]
    fn reaction(self) -> Minus<T> {
        Minus(self)
    }
}

/// A term given by its negative: of a spring that is k φ, and a negation less in every joint of a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minus<T>(pub T);

impl<T: Scalar> Part for Minus<T> {
    fn is_finite(self) -> bool {
        Scalar::is_finite(self.0)
    }
}

impl<T: Scalar> Term<T> for Minus<T> {
    fn none() -> Self {
        Self(T::zero())
    }
    #[inline(always)]
    fn add_to(self, sum: T) -> T {
        sum - self.0
    }
    #[inline(always)]
    fn take_from(self, sum: T) -> T {
        sum + self.0
    }
}

/// A coefficient that a scene may or may not have: of damping, for example.
pub trait Coefficient<T: Scalar>: Part {
    /// `self · factor + sum`.
    fn times_onto(self, factor: T, sum: T) -> T;
    /// `self · factor`, or nothing.
    fn times(self, factor: T) -> Self;
    /// −self · factor, or zero.
    fn against(self, factor: T) -> T;
    /// `self · factor`, or zero.
    fn scaled(self, factor: T::Real) -> T;
}

impl<T: Scalar> Coefficient<T> for Absent {
    #[inline(always)]
    fn times_onto(self, _: T, sum: T) -> T {
        sum
    }
    fn times(self, _: T) -> Self {
        self
    }
    #[inline(always)]
    fn against(self, _: T) -> T {
        T::zero()
    }
    #[inline(always)]
    fn scaled(self, _: T::Real) -> T {
        T::zero()
    }
}

impl<T: Scalar> Coefficient<T> for T {
    #[inline(always)]
    fn times_onto(self, factor: T, sum: T) -> T {
        self.mul_add(factor, sum)
    }
    fn times(self, factor: T) -> Self {
        self * factor
    }
    #[inline(always)]
    fn against(self, factor: T) -> T {
        -(self * factor)
    }
    #[inline(always)]
    fn scaled(self, factor: T::Real) -> T {
        self.scale(factor)
    }
}

impl<A: Copy> Join<A> for Absent {
    type Out = A;
    #[inline(always)]
    fn join(self, arm: A) -> A {
        arm
    }
}

impl<T: Scalar> Join<T> for T {
    type Out = T;
    #[inline(always)]
    fn join(self, arm: T) -> T {
        self + arm
    }
}

impl<T: Scalar> Join<Absent> for T {
    type Out = T;
    #[inline(always)]
    fn join(self, _: Absent) -> T {
        self
    }
}

impl<T: Scalar> Join<Minus<T>> for T {
    type Out = T;
    #[inline(always)]
    fn join(self, arm: Minus<T>) -> T {
        arm.add_to(self)
    }
}

impl<T: Scalar> Join<T> for Minus<T> {
    type Out = T;
    #[inline(always)]
    fn join(self, arm: T) -> T {
        self.add_to(arm)
    }
}

impl<T: Scalar> Join<Self> for Minus<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Self) -> Self {
        Self(self.0 + arm.0)
    }
}

impl<T: Scalar> Join<Absent> for Minus<T> {
    type Out = Self;
    #[inline(always)]
    fn join(self, _: Absent) -> Self {
        self
    }
}
