//! Inertia of bodies in inertial axes, about the origin of [screws](super::screws), and what velocity makes of it.

use super::Moving;
use super::screws::Pair;
use crate::relation::Symmetric;
use crate::relation::spatial::algebra::{Columns, Symmetric3, add_scaled, cross, cross_onto};
use crate::scalar::{Real, Scalar};
use core::ops::Add;
use nalgebra::Vector3;

/// Mass, first moment ∫ r dm, and tensor of inertia.
#[derive(Clone, Copy)]
pub struct Inertial<T> {
    pub mass: T,
    pub moment: Vector3<T>,
    pub tensor: Symmetric3<T>,
}

/// J = tr Σ 1 − Σ of second moments Σ = ∫ r rᵀ dm.
#[inline(always)]
fn tensor<T: Scalar>(second: &Symmetric3<T>) -> Symmetric3<T> {
    let Symmetric3 { xx, xy, xz, yy, yz, zz } = *second;
    Symmetric3 { xx: yy + zz, xy: -xy, xz: -xz, yy: xx + zz, yz: -yz, zz: xx + yy }
}

impl<T: Scalar> Inertial<T> {
    /// Of a body, about its own origin.
    #[cfg_attr(optimised, inline(always))]
    pub fn own(body: &Moving<T>) -> Self {
        let [mass, x, y, z, xx, yy, zz, yz, xz, xy] = body.parameters;
        let attitude = &body.place.attitude;
        let tensor = Symmetric3 { xx, xy, xz, yy, yz, zz }.turned(attitude);
        Self { mass, moment: attitude.apply(Vector3::new(x, y, z)), tensor }
    }

    /// Of a body whose origin is at `arm` from the common one, with its second moments.
    #[cfg_attr(optimised, inline(always))]
    pub fn of(body: &Moving<T>, arm: Vector3<T>) -> (Self, Symmetric3<T>) {
        let [mass, x, y, z, xx, yy, zz, yz, xz, xy] = body.parameters;
        let attitude = &body.place.attitude;
        let half = (xx + yy + zz).scale(T::Real::of(0.5));
        let own = Symmetric3 { xx: half - xx, xy: -xy, xz: -xz, yy: half - yy, yz: -yz, zz: half - zz };
        let own_moment = attitude.apply(Vector3::new(x, y, z));
        let moment = add_scaled(own_moment, mass, arm);
        // Σ + s dᵀ + d (s + m d)ᵀ, which is symmetric.
        let second = own.turned(attitude).plus_outer(own_moment, arm).plus_outer(arm, moment);
        (Self { mass, moment, tensor: tensor(&second) }, second)
    }

    /// Momentum, and angular momentum about the origin, of a twist.
    #[inline(always)]
    pub fn moved(&self, [linear, angular]: Pair<T>) -> Pair<T> {
        let momentum = cross_onto(angular, self.moment, linear * self.mass);
        [momentum, self.tensor.apply_onto(angular, cross(self.moment, linear))]
    }
}

impl<T: Scalar> Add for Inertial<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (mass, moment) = (self.mass + other.mass, self.moment + other.moment);
        Self { mass, moment, tensor: self.tensor + other.tensor }
    }
}

/// What velocity v(r) makes of a body: momentum h = ∫ v dm and G = ∫ (r·v 1 − v rᵀ) dm.
///
/// A field of angular velocities ω′ takes ∫ ω′ × v dm of force, ω′ × h, and of torque, G ω′: the matrix B of S. Singh, R. P. Russell and
/// P. M. Wensing, *Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra*, IEEE Robotics and Automation
/// Letters 7, 2022, of which 12 numbers are all.
#[derive(Clone, Copy)]
pub struct Stirred<T> {
    pub momentum: Vector3<T>,
    pub stir: Columns<T>,
}

impl<T: Scalar> Stirred<T> {
    /// Of a body of second moments Σ at a twist.
    #[cfg_attr(optimised, inline(always))]
    pub fn of(inertial: &Inertial<T>, second: Symmetric3<T>, [linear, spin]: Pair<T>) -> Self {
        let (moment, columns) = (inertial.moment, second.columns());
        // ∫ v rᵀ dm, column by column.
        let column = |of: Vector3<T>, by: T| cross_onto(spin, of, linear * by);
        let [x, y, z] = [column(columns.x, moment.x), column(columns.y, moment.y), column(columns.z, moment.z)];
        let stir = Columns {
            x: Vector3::new(y.y + z.z, -x.y, -x.z),
            y: Vector3::new(-y.x, x.x + z.z, -y.z),
            z: Vector3::new(-z.x, -z.y, x.x + y.y),
        };
        Self { momentum: cross_onto(spin, moment, linear * inertial.mass), stir }
    }

    /// Momentum and angular momentum, ∫ r × v dm: what of G is not symmetric.
    #[inline(always)]
    pub fn momenta(&self) -> Pair<T> {
        let Columns { x, y, z } = self.stir;
        [self.momentum, Vector3::new(z.y - y.z, x.z - z.x, y.x - x.y)]
    }

    /// Wrench of angular velocities.
    #[inline(always)]
    pub fn apply(&self, angular: Vector3<T>) -> Pair<T> {
        [cross(angular, self.momentum), self.stir.apply(angular)]
    }

    /// Power of that wrench along a twist, by angular velocities.
    #[inline(always)]
    pub fn transposed(&self, [linear, angular]: Pair<T>) -> Vector3<T> {
        self.stir.transposed_onto(angular, cross(self.momentum, linear))
    }
}

impl<T: Scalar> Add for Stirred<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { momentum: self.momentum + other.momentum, stir: self.stir + other.stir }
    }
}
