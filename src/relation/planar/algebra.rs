//! Vectors and symmetric matrices of the plane, with products fused where the target can.

pub use crate::relation::geometry::{add_scaled, dot, zero};
use crate::relation::{Additive, Symmetric};
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector2;

/// `sum` + a · b, fused where the target can.
#[inline(always)]
pub fn plus_dot<T: Scalar>(sum: T, a: Vector2<T>, b: Vector2<T>) -> T {
    a.x.mul_add(b.x, a.y.mul_add(b.y, sum))
}

/// a × b, the component along ẑ.
#[inline(always)]
pub fn cross<T: Scalar>(a: Vector2<T>, b: Vector2<T>) -> T {
    a.x.mul_add(b.y, -(a.y * b.x))
}

/// ẑ × d.
#[inline(always)]
pub fn normal<T: Scalar>(d: Vector2<T>) -> Vector2<T> {
    Vector2::new(-d.y, d.x)
}

/// A symmetric 2 × 2 matrix, one triangle stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric2<T> {
    /// Row x, column x.
    pub xx: T,
    /// Row x, column y, and its mirror.
    pub xy: T,
    /// Row y, column y.
    pub yy: T,
}

impl<T: Scalar> Add for Symmetric2<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { xx: self.xx + other.xx, xy: self.xy + other.xy, yy: self.yy + other.yy }
    }
}

impl<T: Scalar> Additive for Symmetric2<T> {
    #[inline(always)]
    fn null() -> Self {
        Self::diagonal(T::zero())
    }
}

impl<T: Scalar> Symmetric<Vector2<T>> for Symmetric2<T> {
    #[inline(always)]
    fn diagonal(value: T) -> Self {
        Self { xx: value, xy: T::zero(), yy: value }
    }
    #[inline(always)]
    fn plus_diagonal(self, value: T) -> Self {
        Self { xx: self.xx + value, xy: self.xy, yy: self.yy + value }
    }
    #[inline(always)]
    fn plus_outer(self, u: Vector2<T>, w: Vector2<T>) -> Self {
        Self { xx: u.x.mul_add(w.x, self.xx), xy: u.x.mul_add(w.y, self.xy), yy: u.y.mul_add(w.y, self.yy) }
    }
    #[cfg_attr(optimised, inline(always))]
    fn apply_onto(self, v: Vector2<T>, sum: Vector2<T>) -> Vector2<T> {
        Vector2::new(
            self.xx.mul_add(v.x, self.xy.mul_add(v.y, sum.x)),
            self.xy.mul_add(v.x, self.yy.mul_add(v.y, sum.y)),
        )
    }
}

impl<T: Scalar> Symmetric2<T> {
    /// S v.
    #[inline(always)]
    pub fn apply(self, v: Vector2<T>) -> Vector2<T> {
        Vector2::new(self.xx.mul_add(v.x, self.xy * v.y), self.xy.mul_add(v.x, self.yy * v.y))
    }

    /// S along axes in the direction `d` and its normal.
    #[cfg_attr(optimised, inline(always))]
    pub fn along(self, d: Vector2<T>) -> Self {
        // Rows of S in the new axes, then their components.
        let (x, y) = (self.apply(d), self.apply(normal(d)));
        Self { xx: dot(x, d), xy: dot(y, d), yy: dot(y, normal(d)) }
    }

    /// S with x and y exchanged.
    #[inline(always)]
    pub fn swapped(self) -> Self {
        Self { xx: self.yy, xy: self.xy, yy: self.xx }
    }
}
