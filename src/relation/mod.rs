//! Condensed relations: what a chain's outboard part demands of the force at a station.
//!
//! Everything outboard of a station answers an acceleration p = (a, α) of that station with a force F = S p + e + Wλ: S is the
//! articulated-body inertia of the field and e the bias force, W λ is what constraint forces add. The inward pass of the Riccati
//! sweep carries such a relation from the tip to the root; each element maps the relation it meets to the one it hands on. How much
//! of S, e and W there is depends on what lies outboard, so it is decided by *type*: after a pin, for example, no
//! moment depends on the motion and a 2 × 2 block is all there is.
//!
//! S is symmetric positive semidefinite and only one triangle is stored. Stored full and merely assumed symmetric, its
//! antisymmetric rounding doubles with every body (a chain of 60 is lost); stored as a triangle it holds at 100 000.

mod arms;
mod closing;
mod closure;
mod full;
mod geometry;
mod join;
mod kinds;
mod looped;
pub mod planar;
mod redundancy;
mod shared;
pub mod spatial;
mod way;
mod wrench;

pub use arms::{Carry, Forces, Wrenches};
pub use closing::Close;
pub use closure::{Closures, Cut, Cuts, Open, Solvable, largest};
pub use full::Full;
pub use geometry::{AccelerationOf, Additive, Angular, Geometry, Symmetric, VectorSpace, WrenchOf};
pub use kinds::{Empty, Lump, Point, Relation};
pub use looped::{LoopGain, Looped, Own, Settle, Twisted};
pub use shared::Shared;
pub use way::Way;
pub use wrench::{Acceleration, Wrench};

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

/// A relation that can stand for a lesser one: what an array or vector without links hands on.
pub trait Promote<R> {
    /// `lesser` as a relation of this type.
    fn promote(lesser: R) -> Self;
}

impl<R> Promote<R> for R {
    fn promote(lesser: R) -> R {
        lesser
    }
}

/// A relation that links hand on, and what an array or vector of them hands on where a relation `R` lies outboard of it, which it hands on
/// itself if it has no links.
pub trait Meet<R>: Sized {
    /// What can say both.
    type Both: Copy;
    /// The relation of the links.
    fn of_links(own: Self) -> Self::Both;
    /// The relation outboard of no links.
    fn of_none(outer: R) -> Self::Both;
}

impl<R, Q: Promote<R> + Copy> Meet<R> for Q {
    type Both = Q;
    #[inline(always)]
    fn of_links(own: Q) -> Q {
        own
    }
    #[inline(always)]
    fn of_none(outer: R) -> Q {
        Q::promote(outer)
    }
}

/// A relation, or a part of one, to which that of an arm at the same station can be added.
#[diagnostic::on_unimplemented(
    message = "an arm that hands on `{A}` cannot leave the chain where that hands on `{Self}`",
    label = "these two have no sum",
    note = "an arm is a chain of the same space and scalar with a free tip, and ends with a body"
)]
pub trait Join<A>: Copy {
    /// The relation of both.
    type Out: Copy;
    /// The sum of both.
    fn join(self, arm: A) -> Self::Out;
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
