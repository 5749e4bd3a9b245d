//! Attitudes as unit quaternions.
//!
//! # Steps
//!
//! A rule steps an attitude R in coordinates of the step: R = R₀ ∘ p with p = (√(1 − v²/4), v/2), so that v points along the axis
//! and has length 2 sin(φ/2) for an angle φ. At the start v = 0, v̇ = ω and v̈ = ω̇ (body axes); later
//!
//! ```text
//! v̇ = p₀ ω + ½ v × ω        v̈ = p₀ ω̇ + ½ v × ω̇ − ¼ ω² v
//! ```
//!
//! which is the vector part of the quaternion's own linear equation. Smooth coordinates keep the order of any rule, and these cost
//! one root and no sine; a steady spin is an entire function in them. They end at half a turn in one step, where the root is not a
//! number and the step is refused.

use super::axial::{check_length, squarable};
use crate::error::{Error, Fault};
use crate::lift::lift;
use crate::mirror::{Position, Retraction, Term};
use crate::relation::spatial::algebra::{Columns, add_scaled, cross, cross_onto, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;
use num_traits::Zero;

/// An attitude: a unit quaternion that turns body axes into inertial (or inboard) axes.
///
/// ```
/// use catena::spatial::Rotation;
/// let tilted = Rotation::from_angles([0.1, 0.2, -0.3]); // angles 1-2-3 (rad)
/// assert!((tilted.angles()[1] - 0.2_f64).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: Scalar + serde::Serialize", deserialize = "T: Scalar + serde::Deserialize<'de>"))
)]
#[cfg_attr(feature = "serde", serde(try_from = "Quaternion<T>", into = "Quaternion<T>"))]
pub struct Rotation<T> {
    pub(super) w: T,
    pub(super) v: Vector3<T>,
}

/// A rotation as it is written: `[w, x, y, z]`.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Quaternion<T>([T; 4]);

#[cfg(feature = "serde")]
impl<T: Scalar> From<Rotation<T>> for Quaternion<T> {
    fn from(rotation: Rotation<T>) -> Self {
        Self(rotation.quaternion())
    }
}

/// Bit by bit: a quaternion is not brought to length one, but has it.
#[cfg(feature = "serde")]
impl<T: Scalar> TryFrom<Quaternion<T>> for Rotation<T> {
    type Error = Error;

    fn try_from(Quaternion([w, x, y, z]): Quaternion<T>) -> Result<Self, Error> {
        let v = Vector3::new(x, y, z);
        let read = Self { w, v };
        read.check().map_err(Error::new)?;
        Ok(read)
    }
}

impl<T: Scalar> Default for Rotation<T> {
    fn default() -> Self {
        Self::identity()
    }
}

impl<T: Scalar> Rotation<T> {
    /// Unturned.
    pub fn identity() -> Self {
        Self { w: T::one(), v: Vector3::new(T::zero(), T::zero(), T::zero()) }
    }

    /// From a quaternion `[w, x, y, z]` of any length.
    ///
    /// # Errors
    /// [`Fault::NotFinite`], or [`Fault::NotPositive`] for a quaternion without length.
    pub fn from_quaternion(quaternion: [T; 4]) -> Result<Self, Error> {
        let [w, x, y, z] = squarable(quaternion);
        let v = Vector3::new(x, y, z);
        let square = w * w + dot(v, v);
        if !square.is_finite() {
            return Err(Error::new(Fault::NotFinite { parameter: "quaternion" }));
        }
        // A lane of length zero gives the least of them, and no other is less.
        if (-square).if_negative(T::zero(), T::one()).real() > T::Real::zero() {
            return Err(Error::new(Fault::NotPositive { parameter: "length of the quaternion", value: 0.0 }));
        }
        let inverse = square.sqrt().recip();
        Ok(Self { w: w * inverse, v: v * inverse })
    }

    /// Refuses what is of another length than one, as matrices of few digits make it: it would stretch what is turned by it.
    pub(super) fn check(&self) -> Result<(), Fault> {
        check_length("length of the quaternion", self.w * self.w + dot(self.v, self.v))
    }

    /// The quaternion `[w, x, y, z]`, of length one.
    pub fn quaternion(&self) -> [T; 4] {
        [self.w, self.v.x, self.v.y, self.v.z]
    }

    /// This rotation after `inner`: R(self) R(inner).
    #[inline(always)]
    #[must_use]
    pub fn after(&self, inner: &Self) -> Self {
        let (a, b) = (self, inner);
        Self { w: a.w.mul_add(b.w, -dot(a.v, b.v)), v: cross_onto(a.v, b.v, add_scaled(a.v * b.w, a.w, b.v)) }
    }

    /// The rotation back.
    #[inline(always)]
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { w: self.w, v: -self.v }
    }

    /// The rotation of `self` as seen from `base`: R(base)ᵀ R(self).
    #[inline(always)]
    #[must_use]
    pub fn relative_to(&self, base: &Self) -> Self {
        base.inverse().after(self)
    }

    /// Body axes in inertial axes, as columns: the matrix A.
    #[cfg_attr(optimised, inline(always))]
    pub fn matrix(&self) -> Columns<T> {
        let (w, x, y, z) = (self.w, self.v.x, self.v.y, self.v.z);
        let one = T::one();
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (xx, yy, zz) = (x2 * x, y2 * y, z2 * z);
        let (xy, xz, yz) = (x2 * y, x2 * z, y2 * z);
        let (wx, wy, wz) = (x2 * w, y2 * w, z2 * w);
        Columns {
            x: Vector3::new(one - yy - zz, xy + wz, xz - wy),
            y: Vector3::new(xy - wz, one - xx - zz, yz + wx),
            z: Vector3::new(xz + wy, yz - wx, one - xx - yy),
        }
    }

    /// A vector of body axes in inertial axes.
    pub fn turned(&self, vector: [T; 3]) -> [T; 3] {
        self.matrix().apply(Vector3::from(vector)).into()
    }

    /// The length brought back to one, where it is one but for rounding: a step of Newton's, without root or branch. Derivatives
    /// along the quaternion vanish.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn normalised(self) -> Self {
        let square = self.w.mul_add(self.w, dot(self.v, self.v));
        let factor = T::literal(1.5) - square.scale(T::Real::of(0.5));
        Self { w: self.w * factor, v: self.v * factor }
    }

    /// The rotation that coordinates v of a step stand for.
    #[inline(always)]
    fn of_step(v: Vector3<T>) -> Self {
        let half = v * T::literal(0.5);
        Self { w: (T::one() - dot(half, half)).sqrt(), v: half }
    }

    #[inline(always)]
    fn stepped(&self, step: Vector3<T>) -> Self {
        self.after(&Self::of_step(step))
    }
}

impl<T: Scalar> Retraction<T> for Rotation<T> {
    type Rate = [T; 3];

    const CURVED: bool = true;

    #[inline(always)]
    fn each_turn(&self, rate: &[T; 3], visit: &mut impl FnMut([T; 3])) {
        visit(*rate);
    }

    // ω = p₀ v̇ + ¼ v (v · v̇) / p₀ − ½ v × v̇
    #[cfg_attr(optimised, inline(always))]
    fn retract_rate(&self, from: &Self, rate: &mut [T; 3]) {
        let step = self.relative_to(from);
        let derivative = Vector3::from(*rate);
        let along = dot(step.v, derivative) / step.w;
        let turned = cross_onto(derivative, step.v, derivative * step.w);
        *rate = add_scaled(turned, along, step.v).into();
    }

    #[cfg_attr(optimised, inline(always))]
    fn inverse_retract_acceleration(&self, from: &Self, rate: &[T; 3], acceleration: &mut [T; 3]) {
        let step = self.relative_to(from);
        let (spin, angular) = (Vector3::from(*rate), Vector3::from(*acceleration));
        let square = dot(spin, spin).scale(T::Real::of(-0.5));
        let second = add_scaled(angular * step.w, square, step.v);
        *acceleration = (second + cross(step.v, angular)).into();
    }

    // λ = p₀ σ − ½ v × σ
    #[cfg_attr(optimised, inline(always))]
    fn transposed_acceleration(&self, from: &Self, costate: &mut [T; 3]) {
        let step = self.relative_to(from);
        let of_second = Vector3::from(*costate);
        *costate = cross_onto(of_second, step.v, of_second * step.w).into();
    }

    // With σ the costate of v̈, Ψ that of the attitude (a rotation vector, body axes) and y that of ω, to which −½ (v·σ) ω belongs, too,
    //
    //   v̇ gets 𝒥ᵀ y, the attitude before the step R(p) Ψ, and v
    //   𝒥ᵀ Ψ − (ω̇·σ) v / (4 p₀) + ½ ω̇ × σ − ¼ ω² σ
    //        − (v̇·y) v / (4 p₀) + ¼ [(v·v̇) y + (v·y) v̇] / p₀ + (v·y) (v·v̇) v / (16 p₀³) − ½ v̇ × y
    //
    // where 𝒥ᵀ y = p₀ y + ¼ v (v·y) / p₀ + ½ v × y. Below u = v / 2.
    #[cfg_attr(optimised, inline(always))]
    fn transposed_step(
        &self,
        from: &Self,
        (rate, acceleration): (&[T; 3], &[T; 3]),
        of_second: &[T; 3],
        (of_position, of_rate): (&mut [T; 3], &mut [T; 3]),
        of_from: &mut [T; 3],
    ) {
        let [spin, angular, second] = [rate, acceleration, of_second].map(|list| Vector3::from(*list));
        let [place, given] = [&*of_position, &*of_rate].map(|list| Vector3::from(*list));
        let Self { w, v: u } = self.relative_to(from);
        let (inverse, half) = (w.recip(), T::literal(0.5));
        let back = |x: Vector3<T>| add_scaled(cross_onto(u, x, x * w), dot(u, x) * inverse, u);
        // R(p) x = x + 2 u × (p₀ x + u × x)
        let before = cross(u + u, cross_onto(u, place, place * w)) + place;
        *of_from = (Vector3::from(*of_from) + before).into();
        let y = add_scaled(given, -dot(u, second), spin);
        let derivative = cross_onto(u, spin, spin * w);
        let (along, across) = (dot(u, derivative), dot(u, y));
        let around = cross(angular, second) - cross(derivative, y);
        let inward = dot(angular, second) + dot(derivative, y) - along * across * inverse * inverse;
        let sum = add_scaled(back(place), half, around - u * (inward * inverse));
        let sum = add_scaled(sum, (along * half) * inverse, y);
        let sum = add_scaled(sum, (across * half) * inverse, derivative);
        *of_position = add_scaled(sum, -dot(spin, spin).scale(T::Real::of(0.25)), second).into();
        *of_rate = back(y).into();
    }

    // Of v, for given accelerations, −(ω̇·σ) v / (4 p₀) + ½ ω̇ × σ − ¼ ω² σ, which 𝒥⁻ᵀ x = p₀ x − ½ v × x turns into Ψ. Below u = v / 2.
    #[cfg_attr(optimised, inline(always))]
    fn transposed_second(
        &self,
        from: &Self,
        (rate, acceleration): (&[T; 3], &[T; 3]),
        of_second: &[T; 3],
        (of_position, of_rate): (&mut [T; 3], &mut [T; 3]),
        of_from: &mut [T; 3],
    ) {
        let [spin, angular, second] = [rate, acceleration, of_second].map(|list| Vector3::from(*list));
        let (Self { w, v: u }, half) = (self.relative_to(from), T::literal(0.5));
        let of_step = cross(angular, second) - u * (dot(angular, second) * w.recip());
        let of_step = add_scaled(of_step * half, -dot(spin, spin).scale(T::Real::of(0.25)), second);
        let turned = of_step * w - cross(u, of_step);
        let before = cross(u + u, cross_onto(u, turned, turned * w)) + turned;
        *of_position = (Vector3::from(*of_position) + turned).into();
        *of_rate = add_scaled(Vector3::from(*of_rate), -dot(u, second), spin).into();
        *of_from = (Vector3::from(*of_from) - before).into();
    }
}

impl<T: Scalar> Position<T> for Rotation<T> {
    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, [T; 3]>) {
        // Not normalised: for no time this is a copy, which must be one to the last bit.
        *self = from.stepped(Vector3::from(*rate).map(|x| x.scale(time)));
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, [T; 3]>, (u, a): Term<'_, T, [T; 3]>) {
        let step = core::array::from_fn(|i| rate[i].scale(time).add_scaled(u, a[i]));
        *self = from.stepped(Vector3::from(step)).normalised();
    }
    #[cfg_attr(optimised, inline(always))]
    fn drift_2(
        &mut self,
        from: &Self,
        (time, rate): Term<'_, T, [T; 3]>,
        (u, a): Term<'_, T, [T; 3]>,
        (v, b): Term<'_, T, [T; 3]>,
    ) {
        let step = core::array::from_fn(|i| rate[i].scale(time).add_scaled(u, a[i]).add_scaled(v, b[i]));
        *self = from.stepped(Vector3::from(step)).normalised();
    }
    #[inline(always)]
    fn measure(&self, displacement: &[T; 3], note: &mut impl FnMut(T, T)) {
        displacement.iter().for_each(|x| note(*x, T::zero()));
    }
    #[inline(always)]
    fn apart(&self, from: &Self, displacement: &mut [T; 3]) {
        let step = self.relative_to(from).shortest();
        *displacement = (step.v + step.v).into();
    }
    #[inline(always)]
    fn displace(&mut self, step: &[T; 3]) {
        *self = self.stepped(Vector3::from(*step)).normalised();
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        self.quaternion().into_iter().for_each(visit);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        *self = Self { w: make(self.w), v: self.v.map(make) };
    }
    #[inline(always)]
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        self.quaternion().iter().zip(other.quaternion()).all(|(a, b)| test(*a, b))
    }
    /// A quaternion whose length is one but for rounding stays as it is, to the last bit.
    fn normalise(&mut self) -> bool {
        let over = (self.w.mul_add(self.w, dot(self.v, self.v)) - T::one()).real(); // of lanes the worst
        if over.abs() <= T::Real::EPSILON * T::Real::of(64.0) {
            return true;
        }
        Self::from_quaternion(self.quaternion()).is_ok_and(|unit| {
            *self = unit;
            true
        })
    }
}

lift!(Rotation { w, v });
