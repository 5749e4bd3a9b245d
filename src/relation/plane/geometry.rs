//! The plane's numbers in relations, and their products.

use super::Full;
use super::algebra::{Symmetric2, add_scaled, dot, normal, plus_dot};
use crate::relation::{Cuts, Geometry, Symmetric};
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
