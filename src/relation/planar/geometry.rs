//! The plane's numbers in relations, and their products.

use super::Full;
use super::algebra::{Symmetric2, add_scaled, dot, normal, plus_dot};
use crate::relation::{Acceleration, Additive, Angular, Cuts, Geometry, Symmetric, VectorSpace, Wrench};
use crate::scalar::Scalar;
use core::fmt;
use core::marker::PhantomData;
use nalgebra::Vector2;

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
