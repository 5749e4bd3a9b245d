//! The numbers of space in relations, and their products.

use super::Full;
use super::algebra::{self, Columns, Symmetric3, add_scaled, cross, cross_onto, dot};
use crate::relation::{Acceleration, Additive, Angular, Cuts, Geometry, Symmetric, VectorSpace, Wrench};
use crate::scalar::Scalar;
use core::fmt;
use core::marker::PhantomData;
use nalgebra::Vector3;

/// Space, with numbers of type `T`.
#[derive(Clone, Copy, PartialEq)]
pub struct Spatial<T>(PhantomData<T>);

impl<T> fmt::Debug for Spatial<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Spatial")
    }
}

impl<T> crate::sealed::Sealed for Spatial<T> {}

impl<T: Scalar> Geometry for Spatial<T> {
    type Scalar = T;
    type Vector = Vector3<T>;
    type Angular = Vector3<T>;
    type Mass = Symmetric3<T>;
    type Inertia = Symmetric3<T>;
    type Coupling = Columns<T>;

    #[inline(always)]
    fn plus_outer(k: Columns<T>, f: Vector3<T>, torque: Vector3<T>) -> Columns<T> {
        k + Columns { x: f * torque.x, y: f * torque.y, z: f * torque.z }
    }
    #[inline(always)]
    fn transposed_onto(k: &Columns<T>, a: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
        k.transposed_onto(a, sum)
    }
    #[inline(always)]
    fn levered(l: Symmetric3<T>, d: Vector3<T>) -> Columns<T> {
        Self::levered_onto(l, d, Columns::null())
    }
    #[cfg_attr(optimised, inline(always))]
    fn levered_onto(l: Symmetric3<T>, d: Vector3<T>, k: Columns<T>) -> Columns<T> {
        let l = l.columns();
        Columns {
            x: add_scaled(add_scaled(k.x, -d.z, l.y), d.y, l.z),
            y: add_scaled(add_scaled(k.y, -d.x, l.z), d.z, l.x),
            z: add_scaled(add_scaled(k.z, -d.y, l.x), d.x, l.y),
        }
    }
    #[inline(always)]
    fn swung(d: Vector3<T>, moved: &Columns<T>) -> Symmetric3<T> {
        let (nx, ny, nz) = (cross(d, moved.x), cross(d, moved.y), cross(d, moved.z));
        Symmetric3 { xx: nx.x, xy: nx.y, xz: nx.z, yy: ny.y, yz: ny.z, zz: nz.z }
    }
    #[inline(always)]
    fn swung_onto(d: Vector3<T>, moved: &Columns<T>, h: Symmetric3<T>) -> Symmetric3<T> {
        Self::swung(d, moved) + h
    }
    #[cfg_attr(optimised, inline(always))]
    fn steiner(d: Vector3<T>, k: &Columns<T>, n: &Columns<T>, h: Symmetric3<T>) -> Symmetric3<T> {
        let crossed_x = |v: Vector3<T>, sum: T| d.y.mul_add(v.z, (-d.z).mul_add(v.y, sum));
        let crossed_y = |v: Vector3<T>, sum: T| d.z.mul_add(v.x, (-d.x).mul_add(v.z, sum));
        let crossed_z = |v: Vector3<T>, sum: T| d.x.mul_add(v.y, (-d.y).mul_add(v.x, sum));
        Symmetric3 {
            xx: crossed_x(k.x, crossed_x(n.x, h.xx)),
            xy: crossed_x(k.y, crossed_y(n.x, h.xy)),
            xz: crossed_x(k.z, crossed_z(n.x, h.xz)),
            yy: crossed_y(k.y, crossed_y(n.y, h.yy)),
            yz: crossed_y(k.z, crossed_z(n.y, h.yz)),
            zz: crossed_z(k.z, crossed_z(n.z, h.zz)),
        }
    }
    #[inline(always)]
    fn about(axis: Vector3<T>, angle: T) -> Vector3<T> {
        axis * angle
    }
    #[inline(always)]
    fn coupled_onto(k: &Columns<T>, a: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
        k.apply_onto(a, sum)
    }
    #[cfg_attr(optimised, inline(always))]
    fn of_lump(mass: T, d: Vector3<T>, c: Vector3<T>) -> Full<T> {
        let (o, moment) = (T::zero(), d * mass);
        let force = c * mass;
        let square = dot(d, moment);
        Full {
            linear: Symmetric3::diagonal(mass),
            coupling: Columns {
                x: Vector3::new(o, -moment.z, moment.y),
                y: Vector3::new(moment.z, o, -moment.x),
                z: Vector3::new(-moment.y, moment.x, o),
            },
            // m (d² 1 − d dᵀ)
            angular: Symmetric3::diagonal(square).plus_outer(-d, moment),
            force,
            torque: cross(d, force),
            cuts: Cuts::none(),
        }
    }
}

impl<T: Scalar> Additive for Vector3<T> {
    #[inline(always)]
    fn null() -> Self {
        Self::new(T::zero(), T::zero(), T::zero())
    }
}

impl<T: Scalar> VectorSpace for Vector3<T> {
    type Scalar = T;
    #[inline(always)]
    fn dot(a: Self, b: Self) -> T {
        a.x.mul_add(b.x, a.y.mul_add(b.y, a.z * b.z))
    }
    #[inline(always)]
    fn minus_dot(sum: T, a: Self, b: Self) -> T {
        sum - dot(a, b)
    }
    #[inline(always)]
    fn times(self, factor: T) -> Self {
        self * factor
    }
    #[inline(always)]
    fn plus_scaled(self, factor: T, v: Self) -> Self {
        Self::new(v.x.mul_add(factor, self.x), v.y.mul_add(factor, self.y), v.z.mul_add(factor, self.z))
    }
    fn all_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl<T: Scalar> Angular<Self> for Vector3<T> {
    #[inline(always)]
    fn moment(d: Self, f: Self) -> Self {
        cross(d, f)
    }
    #[inline(always)]
    fn moment_onto(d: Self, f: Self, sum: Self) -> Self {
        cross_onto(d, f, sum)
    }
    #[inline(always)]
    fn swing_onto(self, d: Self, sum: Self) -> Self {
        cross_onto(self, d, sum)
    }
    #[inline(always)]
    fn centripetal(self, d: Self) -> Self {
        algebra::centripetal(self, d)
    }
    #[inline(always)]
    fn work(w: Wrench<Self, Self>, p: &Acceleration<Self, Self>) -> T {
        dot(w.force, p.linear) + dot(w.torque, p.angular)
    }
}
