//! Vectors and 3 × 3 matrices, with products fused where the target can.

use crate::lift::lift;
pub use crate::relation::geometry::{add_scaled, dot, zero};
use crate::relation::{Additive, Symmetric, VectorSpace};
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector3;

/// `sum` + a · b.
#[inline(always)]
pub fn dot_onto<T: Scalar>(a: Vector3<T>, b: Vector3<T>, sum: T) -> T {
    a.x.mul_add(b.x, a.y.mul_add(b.y, a.z.mul_add(b.z, sum)))
}

/// a × b.
#[inline(always)]
pub fn cross<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(a.y.mul_add(b.z, -(a.z * b.y)), a.z.mul_add(b.x, -(a.x * b.z)), a.x.mul_add(b.y, -(a.y * b.x)))
}

/// `sum` + a × b.
#[cfg_attr(optimised, inline(always))]
pub fn cross_onto<T: Scalar>(a: Vector3<T>, b: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
    Vector3::new(
        a.y.mul_add(b.z, (-a.z).mul_add(b.y, sum.x)),
        a.z.mul_add(b.x, (-a.x).mul_add(b.z, sum.y)),
        a.x.mul_add(b.y, (-a.y).mul_add(b.x, sum.z)),
    )
}

/// The centripetal acceleration ω × (ω × d).
#[inline(always)]
pub fn centripetal<T: Scalar>(spin: Vector3<T>, d: Vector3<T>) -> Vector3<T> {
    cross(spin, cross(spin, d))
}

/// A vector from its entries.
#[inline(always)]
pub fn vector<T: Scalar>([x, y, z]: [T; 3]) -> Vector3<T> {
    Vector3::new(x, y, z)
}

/// Whether every entry is finite.
pub fn is_finite<T: Scalar>(v: Vector3<T>) -> bool {
    v.all_finite()
}

/// A 3 × 3 matrix as three columns. That of an attitude holds the body's axes in inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "Vector3<T>: serde::Serialize", deserialize = "Vector3<T>: serde::Deserialize<'de>"))
)]
pub struct Columns<T> {
    /// First column.
    pub x: Vector3<T>,
    /// Second column.
    pub y: Vector3<T>,
    /// Third column.
    pub z: Vector3<T>,
}

impl<T: Scalar> Add for Columns<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<T: Scalar> Additive for Columns<T> {
    #[inline(always)]
    fn null() -> Self {
        Self { x: zero(), y: zero(), z: zero() }
    }
}

impl<T: Scalar> Columns<T> {
    /// The identity.
    #[inline(always)]
    pub fn identity() -> Self {
        let (o, i) = (T::zero(), T::one());
        Self { x: Vector3::new(i, o, o), y: Vector3::new(o, i, o), z: Vector3::new(o, o, i) }
    }

    /// M v.
    #[inline(always)]
    pub fn apply(&self, v: Vector3<T>) -> Vector3<T> {
        add_scaled(add_scaled(self.x * v.x, v.y, self.y), v.z, self.z)
    }

    /// `sum` + M v.
    #[inline(always)]
    pub fn apply_onto(&self, v: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
        add_scaled(add_scaled(add_scaled(sum, v.x, self.x), v.y, self.y), v.z, self.z)
    }

    /// Mᵀ v.
    #[inline(always)]
    pub fn transposed(&self, v: Vector3<T>) -> Vector3<T> {
        Vector3::new(dot(self.x, v), dot(self.y, v), dot(self.z, v))
    }

    /// `sum` + Mᵀ v.
    #[inline(always)]
    pub fn transposed_onto(&self, v: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
        Vector3::new(dot_onto(self.x, v, sum.x), dot_onto(self.y, v, sum.y), dot_onto(self.z, v, sum.z))
    }

    /// M N.
    #[inline(always)]
    pub fn times(&self, other: &Self) -> Self {
        Self { x: self.apply(other.x), y: self.apply(other.y), z: self.apply(other.z) }
    }
}

lift!(Columns { x, y, z });

/// A symmetric 3 × 3 matrix, one triangle stored.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Symmetric3<T> {
    /// Row x, column x.
    pub xx: T,
    /// Row x, column y, and its mirror.
    pub xy: T,
    /// Row x, column z, and its mirror.
    pub xz: T,
    /// Row y, column y.
    pub yy: T,
    /// Row y, column z, and its mirror.
    pub yz: T,
    /// Row z, column z.
    pub zz: T,
}

impl<T: Scalar> Add for Symmetric3<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, other: Self) -> Self {
        Self {
            xx: self.xx + other.xx,
            xy: self.xy + other.xy,
            xz: self.xz + other.xz,
            yy: self.yy + other.yy,
            yz: self.yz + other.yz,
            zz: self.zz + other.zz,
        }
    }
}

impl<T: Scalar> Additive for Symmetric3<T> {
    #[inline(always)]
    fn null() -> Self {
        Self::diagonal(T::zero())
    }
}

impl<T: Scalar> Symmetric<Vector3<T>> for Symmetric3<T> {
    #[inline(always)]
    fn diagonal(value: T) -> Self {
        let o = T::zero();
        Self { xx: value, xy: o, xz: o, yy: value, yz: o, zz: value }
    }
    #[inline(always)]
    fn plus_diagonal(self, value: T) -> Self {
        Self { xx: self.xx + value, yy: self.yy + value, zz: self.zz + value, ..self }
    }
    #[cfg_attr(optimised, inline(always))]
    fn plus_outer(self, u: Vector3<T>, w: Vector3<T>) -> Self {
        Self {
            xx: u.x.mul_add(w.x, self.xx),
            xy: u.y.mul_add(w.x, self.xy),
            xz: u.z.mul_add(w.x, self.xz),
            yy: u.y.mul_add(w.y, self.yy),
            yz: u.z.mul_add(w.y, self.yz),
            zz: u.z.mul_add(w.z, self.zz),
        }
    }
    #[inline(always)]
    fn apply_onto(self, v: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
        self.columns().apply_onto(v, sum)
    }
}

impl<T: Scalar> Symmetric3<T> {
    /// The symmetric matrix with these values on its diagonal.
    #[inline(always)]
    pub fn of_diagonal(values: Vector3<T>) -> Self {
        let o = T::zero();
        Self { xx: values.x, xy: o, xz: o, yy: values.y, yz: o, zz: values.z }
    }

    /// S · factor.
    #[cfg_attr(optimised, inline(always))]
    pub fn scaled(self, factor: T::Real) -> Self {
        let of = |x: T| x.scale(factor);
        let Self { xx, xy, xz, yy, yz, zz } = self;
        Self { xx: of(xx), xy: of(xy), xz: of(xz), yy: of(yy), yz: of(yz), zz: of(zz) }
    }

    /// The columns.
    #[cfg_attr(optimised, inline(always))]
    pub fn columns(self) -> Columns<T> {
        Columns {
            x: Vector3::new(self.xx, self.xy, self.xz),
            y: Vector3::new(self.xy, self.yy, self.yz),
            z: Vector3::new(self.xz, self.yz, self.zz),
        }
    }

    /// S v.
    #[inline(always)]
    pub fn apply(self, v: Vector3<T>) -> Vector3<T> {
        self.columns().apply(v)
    }

    /// S + K G, of which the sum is known to be symmetric: the rows of G are given as columns of Gᵀ.
    #[inline(always)]
    pub fn plus_product(self, k: &Columns<T>, rows: &Columns<T>) -> Self {
        self.plus_outer(k.x, rows.x).plus_outer(k.y, rows.y).plus_outer(k.z, rows.z)
    }

    /// B Bᵀ-like transform A S Aᵀ for an attitude A.
    #[cfg_attr(optimised, inline(always))]
    pub fn turned(self, attitude: &Columns<T>) -> Self {
        // A S, column by column; its product with Aᵀ is symmetric.
        let half = attitude.times(&self.columns());
        Self::null().plus_product(&half, attitude)
    }

    /// L D Lᵀ, for right-hand sides.
    #[cfg_attr(optimised, inline(always))]
    pub fn factor(self) -> Factor3<T> {
        let dx = self.xx.recip();
        let (yx, zx) = (self.xy * dx, self.xz * dx);
        let dy = yx.mul_add(-self.xy, self.yy).recip();
        let reduced = yx.mul_add(-self.xz, self.yz);
        let zy = reduced * dy;
        let dz = zy.mul_add(-reduced, zx.mul_add(-self.xz, self.zz)).recip();
        Factor3 { yx, zx, zy, inverse: Vector3::new(dx, dy, dz) }
    }
}

lift!(Symmetric3 { xx, xy, xz, yy, yz, zz });

/// L D Lᵀ of a symmetric positive definite 3 × 3 matrix; not finite where it is singular.
#[derive(Clone, Copy, Debug)]
pub struct Factor3<T> {
    yx: T,
    zx: T,
    zy: T,
    /// 1 / D.
    inverse: Vector3<T>,
}

impl<T: Scalar> Factor3<T> {
    /// Of a number in place of a matrix, given its inverse.
    #[inline(always)]
    pub fn of_number(inverse: T) -> Self {
        let o = T::zero();
        Self { yx: o, zx: o, zy: o, inverse: Vector3::new(inverse, o, o) }
    }

    /// Sets the inverse of that number.
    #[inline(always)]
    pub fn set_number(&mut self, inverse: T) {
        self.inverse.x = inverse;
    }

    /// The inverse of that number.
    #[inline(always)]
    pub fn number(&self) -> T {
        self.inverse.x
    }

    /// S⁻¹ v.
    #[cfg_attr(optimised, inline(always))]
    pub fn solve(&self, v: Vector3<T>) -> Vector3<T> {
        let x = v.x;
        let y = self.yx.mul_add(-x, v.y);
        let z = self.zy.mul_add(-y, self.zx.mul_add(-x, v.z));
        let z = z * self.inverse.z;
        let y = self.zy.mul_add(-z, y * self.inverse.y);
        let x = self.zx.mul_add(-z, self.yx.mul_add(-y, x * self.inverse.x));
        Vector3::new(x, y, z)
    }
}
