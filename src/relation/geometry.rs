//! What differs between the plane and space in the algebra of relations: the numbers, and a few products of them.
//!
//! A product with a sum and one without are two kernels: no compiler folds `x + 0.0`, and each is fused where the target can, in an
//! order of its own.

use super::{Absent, Acceleration, Full, Wrench};
use crate::scalar::Scalar;
use crate::sealed::Sealed;
use core::fmt::Debug;
use core::ops::{Add, Neg, Sub};

/// The numbers of a space, and their products. All else of a relation is written in these words.
///
/// Implemented by `Planar<T>` and `Spatial<T>`: no type of a user's does.
pub trait Geometry: Sealed + Copy + Debug + PartialEq + 'static {
    /// The numbers of the scene.
    type Scalar: Scalar;
    /// Places, velocities, forces.
    type Vector: VectorSpace<Scalar = Self::Scalar>;
    /// Angular velocities and accelerations, torques.
    type Angular: Angular<Self::Vector, Scalar = Self::Scalar>;
    /// S_qq (kg).
    type Mass: Symmetric<Self::Vector>;
    /// S_mm (kg·m²).
    type Inertia: Symmetric<Self::Angular>;
    /// S_qm (kg·m).
    type Coupling: Additive;

    /// K + f τᵀ.
    fn plus_outer(k: Self::Coupling, f: Self::Vector, torque: Self::Angular) -> Self::Coupling;
    /// `sum` + Kᵀ a.
    fn transposed_onto(k: &Self::Coupling, a: Self::Vector, sum: Self::Angular) -> Self::Angular;
    /// −L d~.
    fn levered(l: Self::Mass, d: Self::Vector) -> Self::Coupling;
    /// K − L d~.
    fn levered_onto(l: Self::Mass, d: Self::Vector, k: Self::Coupling) -> Self::Coupling;
    /// d~ K′, for K′ = −L d~.
    fn swung(d: Self::Vector, moved: &Self::Coupling) -> Self::Inertia;
    /// H + d~ K′, for K′ = −L d~.
    fn swung_onto(d: Self::Vector, moved: &Self::Coupling, h: Self::Inertia) -> Self::Inertia;
    /// H + d~ K′ + (d~ K)ᵀ, for K′ = K − L d~.
    fn steiner(d: Self::Vector, k: &Self::Coupling, moved: &Self::Coupling, h: Self::Inertia) -> Self::Inertia;
    /// A turn about a unit vector; in the plane about ẑ, whatever the vector.
    fn about(axis: Self::Vector, angle: Self::Scalar) -> Self::Angular;
    /// `sum` + K α.
    fn coupled_onto(k: &Self::Coupling, a: Self::Angular, sum: Self::Vector) -> Self::Vector;
    /// The relation of a point mass at the vector d, which has the acceleration c besides: mostly zeros.
    fn of_lump(mass: Self::Scalar, d: Self::Vector, c: Self::Vector) -> Full<Self>;
}

/// The force and torque of a space.
pub type WrenchOf<G> = Wrench<<G as Geometry>::Vector, <G as Geometry>::Angular>;
/// The acceleration of a station of a space.
pub type AccelerationOf<G> = Acceleration<<G as Geometry>::Vector, <G as Geometry>::Angular>;

/// What adds up, from zero.
pub trait Additive: Copy + Debug + PartialEq + Add<Output = Self> + 'static {
    /// Zero.
    fn null() -> Self;
}

/// What adds up and scales: a number, a vector.
pub trait VectorSpace: Additive + Sub<Output = Self> + Neg<Output = Self> {
    /// Numbers of the space.
    type Scalar: Scalar;

    /// a · b.
    fn dot(a: Self, b: Self) -> Self::Scalar;
    /// `sum` − a · b.
    fn minus_dot(sum: Self::Scalar, a: Self, b: Self) -> Self::Scalar;
    /// `self · factor`.
    fn times(self, factor: Self::Scalar) -> Self;
    /// `self + factor · v`.
    fn plus_scaled(self, factor: Self::Scalar, v: Self) -> Self;
    /// Whether each entry is finite.
    fn all_finite(self) -> bool;
}

/// Angular velocities and accelerations, and torques: what comes of the cross product with a vector `V`.
pub trait Angular<V>: VectorSpace {
    /// d × f.
    fn moment(d: V, f: V) -> Self;
    /// `sum` + d × f.
    fn moment_onto(d: V, f: V, sum: Self) -> Self;
    /// `sum` + α × d.
    fn swing_onto(self, d: V, sum: V) -> V;
    /// ω × (ω × d).
    fn centripetal(self, d: V) -> V;
    /// w · p.
    fn work(wrench: Wrench<V, Self>, acceleration: &Acceleration<V, Self>) -> Self::Scalar;
}

/// A symmetric matrix that maps a `V` to a `V`, one triangle stored.
pub trait Symmetric<V: VectorSpace>: Additive {
    /// `value` on the diagonal.
    fn diagonal(value: V::Scalar) -> Self;
    /// S + value·1.
    fn plus_diagonal(self, value: V::Scalar) -> Self;
    /// S + u wᵀ for parallel u and w, so that the result is symmetric.
    fn plus_outer(self, u: V, w: V) -> Self;
    /// `sum` + S v.
    fn apply_onto(self, v: V, sum: V) -> V;
}

/// Nothing and nothing is nothing.
impl Add for Absent {
    type Output = Self;
    #[inline(always)]
    fn add(self, _: Self) -> Self {
        self
    }
}

impl Additive for Absent {
    #[inline(always)]
    fn null() -> Self {
        Self
    }
}

impl<T: Scalar> Additive for T {
    #[inline(always)]
    fn null() -> T {
        T::zero()
    }
}

impl<T: Scalar> VectorSpace for T {
    type Scalar = T;
    #[inline(always)]
    fn dot(a: T, b: T) -> T {
        a * b
    }
    #[inline(always)]
    fn minus_dot(sum: T, a: T, b: T) -> T {
        (-a).mul_add(b, sum)
    }
    #[inline(always)]
    fn times(self, factor: T) -> T {
        self * factor
    }
    #[inline(always)]
    fn plus_scaled(self, factor: T, v: T) -> T {
        v.mul_add(factor, self)
    }
    fn all_finite(self) -> bool {
        self.is_finite()
    }
}

/// A number maps numbers.
impl<T: Scalar> Symmetric<T> for T {
    #[inline(always)]
    fn diagonal(value: T) -> T {
        value
    }
    #[inline(always)]
    fn plus_diagonal(self, value: T) -> T {
        self + value
    }
    #[inline(always)]
    fn plus_outer(self, u: T, w: T) -> T {
        u.mul_add(w, self)
    }
    #[inline(always)]
    fn apply_onto(self, v: T, sum: T) -> T {
        self.mul_add(v, sum)
    }
}

/// No vector.
#[inline(always)]
pub fn zero<V: Additive>() -> V {
    V::null()
}

/// a · b.
#[inline(always)]
pub fn dot<V: VectorSpace>(a: V, b: V) -> V::Scalar {
    V::dot(a, b)
}

/// `sum + factor · v`.
#[inline(always)]
pub fn add_scaled<V: VectorSpace>(sum: V, factor: V::Scalar, v: V) -> V {
    sum.plus_scaled(factor, v)
}
