//! A force and a torque, and the acceleration on which they do work.

use super::{Additive, Angular, Closures, Full, Geometry, Part, Term, VectorSpace, WrenchOf};
use core::ops::{Add, Neg, Sub};

/// A force and a torque.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Wrench<V, A> {
    /// Force (N).
    pub force: V,
    /// Torque (N·m), inertial axes.
    pub torque: A,
}

impl<V: Additive, A: Additive> Wrench<V, A> {
    /// No force, no torque.
    #[inline(always)]
    pub fn none() -> Self {
        Self { force: V::null(), torque: A::null() }
    }

    /// A force without a torque.
    #[inline(always)]
    pub fn of_force(force: V) -> Self {
        Self { force, torque: A::null() }
    }
}

impl<V: VectorSpace, A: Angular<V, Scalar = V::Scalar>> Wrench<V, A> {
    /// `self + factor · other`.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn plus_scaled(self, factor: V::Scalar, other: Self) -> Self {
        Self {
            force: self.force.plus_scaled(factor, other.force),
            torque: self.torque.plus_scaled(factor, other.torque),
        }
    }

    /// w · p, the work on an acceleration.
    #[inline(always)]
    pub fn work(self, acceleration: &Acceleration<V, A>) -> V::Scalar {
        A::work(self, acceleration)
    }
}

impl<V: Add<Output = V>, A: Add<Output = A>> Add for Wrench<V, A> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, torque: self.torque + other.torque }
    }
}

impl<V: Sub<Output = V>, A: Sub<Output = A>> Sub for Wrench<V, A> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { force: self.force - other.force, torque: self.torque - other.torque }
    }
}

impl<V: Neg<Output = V>, A: Neg<Output = A>> Neg for Wrench<V, A> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { force: -self.force, torque: -self.torque }
    }
}

impl<V: Additive, A: Additive> Additive for Wrench<V, A> {
    #[inline(always)]
    fn null() -> Self {
        Self::none()
    }
}

impl<V: Additive, A: Additive> Default for Wrench<V, A> {
    fn default() -> Self {
        Self::none()
    }
}

impl<V: VectorSpace, A: VectorSpace> Part for Wrench<V, A> {
    fn is_finite(self) -> bool {
        self.force.all_finite() && self.torque.all_finite()
    }
}

impl<G: Geometry, C: Closures> Term<Full<G, C>> for WrenchOf<G> {
    fn none() -> Self {
        Self::none()
    }
    #[inline(always)]
    fn add_to(self, sum: Full<G, C>) -> Full<G, C> {
        Full { force: sum.force + self.force, torque: sum.torque + self.torque, ..sum }
    }
    #[inline(always)]
    fn take_from(self, sum: Full<G, C>) -> Full<G, C> {
        Full { force: sum.force - self.force, torque: sum.torque - self.torque, ..sum }
    }
}

/// Acceleration p of a station.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Acceleration<V, A> {
    /// Of its point (m/s²).
    pub linear: V,
    /// Of the body on its inboard side (rad/s²), inertial axes.
    pub angular: A,
}

impl<V: Additive, A: Additive> Acceleration<V, A> {
    /// No acceleration.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { linear: V::null(), angular: A::null() }
    }
}

impl<V: VectorSpace, A: Angular<V>> Acceleration<V, A> {
    /// The acceleration of another point, at the vector `d` from this one, which has the acceleration `c` besides that of rigid
    /// rotation: a + α × d + c. For a point of the same body c = ω × (ω × d), which is −ω² d in the plane.
    #[inline(always)]
    pub fn shifted(&self, d: V, c: V) -> Self {
        Self { linear: self.angular.swing_onto(d, self.linear + c), angular: self.angular }
    }

    /// The acceleration of another point of a body at rest: a + α × d.
    #[inline(always)]
    pub fn swung(&self, d: V) -> Self {
        Self { linear: self.angular.swing_onto(d, self.linear), angular: self.angular }
    }
}
