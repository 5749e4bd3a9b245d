//! The plane's numbers in relations: vectors and symmetric matrices, with products fused where the target can.

use super::Full;
pub use crate::relation::geometry::{add_scaled, dot, zero};
use crate::relation::{Acceleration, Additive, Angular, Cuts, Geometry, Symmetric, VectorSpace, Wrench};
use crate::scalar::Scalar;
use core::fmt;
use core::marker::PhantomData;
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

/// The plane, with numbers of type `T`.
#[derive(Clone, Copy, PartialEq)]
pub struct Planar<T>(PhantomData<T>);

impl<T> fmt::Debug for Planar<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Planar")
    }
}

impl<T> crate::sealed::Sealed for Planar<T> {}

impl<T: Scalar> Geometry for Planar<T> {
    type Scalar = T;
    type Vector = Vector2<T>;
    type Angular = T;
    type Mass = Symmetric2<T>;
    type Inertia = T;
    type Coupling = Vector2<T>;

    #[inline(always)]
    fn plus_outer(k: Vector2<T>, f: Vector2<T>, torque: T) -> Vector2<T> {
        add_scaled(k, torque, f)
    }
    #[inline(always)]
    fn transposed_onto(k: &Vector2<T>, a: Vector2<T>, sum: T) -> T {
        plus_dot(sum, *k, a)
    }
    #[inline(always)]
    fn levered(l: Symmetric2<T>, d: Vector2<T>) -> Vector2<T> {
        l.apply(normal(d))
    }
    #[inline(always)]
    fn levered_onto(l: Symmetric2<T>, d: Vector2<T>, k: Vector2<T>) -> Vector2<T> {
        l.apply_onto(normal(d), k)
    }
    #[inline(always)]
    fn swung(d: Vector2<T>, moved: &Vector2<T>) -> T {
        dot(normal(d), *moved)
    }
    #[inline(always)]
    fn swung_onto(d: Vector2<T>, moved: &Vector2<T>, h: T) -> T {
        plus_dot(h, normal(d), *moved)
    }
    #[inline(always)]
    fn steiner(d: Vector2<T>, k: &Vector2<T>, moved: &Vector2<T>, h: T) -> T {
        plus_dot(h, normal(d), *k + *moved)
    }
    #[inline(always)]
    fn about(_: Vector2<T>, angle: T) -> T {
        angle
    }
    #[inline(always)]
    fn coupled_onto(k: &Vector2<T>, a: T, sum: Vector2<T>) -> Vector2<T> {
        add_scaled(sum, a, *k)
    }
    #[cfg_attr(optimised, inline(always))]
    fn of_lump(mass: T, d: Vector2<T>, c: Vector2<T>) -> Full<T> {
        let n = normal(d);
        let coupling = n * mass;
        Full {
            linear: Symmetric2::diagonal(mass),
            coupling,
            angular: dot(n, coupling),
            force: c * mass,
            torque: T::zero(), // only bodies meet lumps, and their centripetal force has no moment about the station: n · d = 0
            cuts: Cuts::none(),
        }
    }
}

impl<T: Scalar> Additive for Vector2<T> {
    #[inline(always)]
    fn null() -> Self {
        Self::new(T::zero(), T::zero())
    }
}

impl<T: Scalar> VectorSpace for Vector2<T> {
    type Scalar = T;
    #[inline(always)]
    fn dot(a: Self, b: Self) -> T {
        a.x.mul_add(b.x, a.y * b.y)
    }
    #[inline(always)]
    fn minus_dot(sum: T, a: Self, b: Self) -> T {
        (-a.x).mul_add(b.x, (-a.y).mul_add(b.y, sum))
    }
    #[inline(always)]
    fn times(self, factor: T) -> Self {
        self * factor
    }
    #[inline(always)]
    fn plus_scaled(self, factor: T, v: Self) -> Self {
        Self::new(v.x.mul_add(factor, self.x), v.y.mul_add(factor, self.y))
    }
    fn all_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

/// Moments of the plane are numbers.
impl<T: Scalar> Angular<Vector2<T>> for T {
    #[inline(always)]
    fn moment(d: Vector2<T>, f: Vector2<T>) -> T {
        dot(normal(d), f)
    }
    #[inline(always)]
    fn moment_onto(d: Vector2<T>, f: Vector2<T>, sum: T) -> T {
        plus_dot(sum, normal(d), f)
    }
    #[inline(always)]
    fn swing_onto(self, d: Vector2<T>, sum: Vector2<T>) -> Vector2<T> {
        add_scaled(sum, self, normal(d))
    }
    #[inline(always)]
    fn centripetal(self, d: Vector2<T>) -> Vector2<T> {
        d * -(self * self)
    }
    #[inline(always)]
    fn work(w: Wrench<Vector2<T>, T>, p: &Acceleration<Vector2<T>, T>) -> T {
        w.torque.mul_add(p.angular, dot(w.force, p.linear))
    }
}
