//! The exponential map of rotations, its tangent, and the logarithm.
//!
//! Everything here is made of functions without poles or branches at zero: sin x / x, cos x and (sin x / x − cos x)/x² by their
//! series, of x = φ/2, and the arctangent of a quarter of a quarter of an angle. So derivatives of any kind are right everywhere, and
//! lanes do not part.

use super::Rotation;
use crate::relation::spatial::algebra::{Columns, Symmetric3, add_scaled, cross, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// Terms that give the series to 1e-17 up to x = π, a turn.
const TERMS: usize = 16;

/// 1 − x²/((n + 1)(n + 2)) · (1 − x²/((n + 3)(n + 4)) · (…)): cos x for n = 0, sin x / x for n = 1.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn alternating<T: Scalar>(square: T, n: usize) -> T {
    (0..TERMS).rev().fold(T::one(), |sum, k| {
        let (a, b) = ((n + 2 * k + 1) as f64, (n + 2 * k + 2) as f64);
        (square * sum).scale(T::Real::of(-1.0 / (a * b))) + T::one()
    })
}

/// cos x, sin x / x and (sin x / x − cos x)/x², for x = φ/2.
struct Half<T> {
    cos: T,
    sinc: T,
    rest: T,
}

impl<T: Scalar> Half<T> {
    #[cfg_attr(optimised, inline(always))]
    fn of(vector: Vector3<T>) -> Self {
        let square = dot(vector, vector).scale(T::Real::of(0.25));
        let rest = (0..TERMS).rev().fold(T::one(), |sum, k| {
            let (a, b) = ((2 * k + 2) as f64, (2 * k + 5) as f64);
            (square * sum).scale(T::Real::of(-1.0 / (a * b))) + T::one()
        });
        Self { cos: alternating(square, 0), sinc: alternating(square, 1), rest: rest.scale(T::Real::of(1.0 / 3.0)) }
    }

    /// c = (1 − (φ/2) cot(φ/2)) / φ².
    fn cotangent(&self) -> T {
        (self.rest / self.sinc).scale(T::Real::of(0.25))
    }
}

/// a + b ψ × + c ψ × ψ ×, applied.
#[inline(always)]
fn with_crosses<T: Scalar>(psi: Vector3<T>, once: T, twice: T, v: Vector3<T>) -> Vector3<T> {
    let first = cross(psi, v);
    add_scaled(add_scaled(v, once, first), twice, cross(psi, first))
}

impl<T: Scalar> Rotation<T> {
    /// The rotation by a rotation vector (rad): the exponential map.
    pub fn exp(vector: [T; 3]) -> Self {
        let mut vector = Vector3::from(vector);
        // The series serve up to a turn: larger vectors are halved, and the result squared as often.
        let mut halvings = 0;
        while halvings < 60 && dot(vector, vector).real() > T::Real::of(36.0) {
            vector *= T::literal(0.5);
            halvings += 1;
        }
        let half = Half::of(vector);
        let once = Self { w: half.cos, v: vector * half.sinc.scale(T::Real::of(0.5)) };
        (0..halvings).fold(once, |rotation, _| rotation.after(&rotation))
    }

    /// The rotation vector (rad) of length up to a turn, continuous along a motion of the quaternion: the logarithm. A quaternion with
    /// w < 0 has turned by more than half a turn; [`shortest`](Self::shortest) makes it less.
    pub fn log(&self) -> [T; 3] {
        // tan(φ/4) = sin(φ/2) / (1 + cos(φ/2)), twice halved again.
        let mut tangent = self.v * (T::one() + self.w).recip();
        for _ in 0..2 {
            tangent *= (T::one() + (T::one() + dot(tangent, tangent)).sqrt()).recip();
        }
        let square = dot(tangent, tangent);
        let series = (0..22).rev().fold(T::zero(), |sum, k| T::literal(1.0 / (2 * k + 1) as f64) - square * sum);
        (tangent * series.scale(T::Real::of(16.0))).into()
    }

    /// This attitude by the quaternion with w ≥ 0, of at most half a turn. It decides by the real part, each lane for
    /// itself; for input and output.
    #[must_use]
    pub fn shortest(&self) -> Self {
        let sign = self.w.if_negative(-T::one(), T::one());
        Self { w: self.w * sign, v: self.v * sign }
    }
}

/// The angular velocity (body axes) for the rate of a rotation vector: T(ψ) ψ̇ with T = 1 − (1 − cos φ)/φ² ψ~ + (φ − sin φ)/φ³ ψ~².
pub fn tangent<T: Scalar>(psi: [T; 3], rate: [T; 3]) -> [T; 3] {
    let psi = Vector3::from(psi);
    let half = Half::of(psi);
    let square = half.sinc * half.sinc;
    let once = square.scale(T::Real::of(-0.5));
    let twice = (square - half.cos * half.rest).scale(T::Real::of(0.25));
    with_crosses(psi, once, twice, Vector3::from(rate)).into()
}

/// The rate of a rotation vector for an angular velocity (body axes): T⁻¹(ψ) ω with T⁻¹ = 1 + ½ ψ~ + c ψ~².
pub fn inverse_tangent<T: Scalar>(psi: [T; 3], spin: [T; 3]) -> [T; 3] {
    let psi = Vector3::from(psi);
    with_crosses(psi, T::literal(0.5), Half::of(psi).cotangent(), Vector3::from(spin)).into()
}

/// The gradient of V(φ), φ = log R, for turns of the outboard body in axes of the inboard one, where ∂V/∂φ = `force`:
/// (1 + ½ φ~ + c φ~²) ∂V/∂φ. It is conservative, and objective, which K times angles would not be.
#[inline(always)]
pub(crate) fn spring_couple<T: Scalar>(phi: Vector3<T>, force: Vector3<T>) -> Vector3<T> {
    with_crosses(phi, T::literal(0.5), Half::of(phi).cotangent(), force)
}

/// How that couple changes with turns of the outboard body (axes of the inboard one), symmetrised: the derivative of
/// (1 + ½ φ~ + c φ~²) ∂V/∂φ by φ, times dφ = (1 − ½ φ~ + c φ~²) dψ, for ∂²V/∂φ² = diag(`stiffness`). It serves as the slope of an
/// implicit sweep, which does without the change of c, of third order in φ.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn spring_slope<T: Scalar>(phi: Vector3<T>, stiffness: Vector3<T>, force: Vector3<T>) -> Symmetric3<T> {
    let (half, c) = (T::literal(0.5), Half::of(phi).cotangent());
    let work = dot(phi, force) * c;
    let column = |e: Vector3<T>| {
        let turned = with_crosses(phi, -half, c, e);
        let first = with_crosses(phi, half, c, turned.component_mul(&stiffness));
        let second = add_scaled(cross(turned, force) * half, work, turned);
        let third = phi * (dot(force, turned) * c) - force * (dot(phi, turned) * (c + c));
        first + second + third
    };
    let Columns { x, y, z } = Columns::identity();
    let (x, y, z) = (column(x), column(y), column(z));
    let mean = |a: T, b: T| (a + b) * half;
    Symmetric3 { xx: x.x, xy: mean(x.y, y.x), xz: mean(x.z, z.x), yy: y.y, yz: mean(y.z, z.y), zz: z.z }
}

/// The rotation by an angle (rad) about a unit axis, as columns.
#[cfg_attr(optimised, inline(always))]
pub(super) fn about<T: Scalar>(axis: Vector3<T>, angle: T) -> Columns<T> {
    let (sine, cosine) = angle.sin_cos();
    let (s, v) = (axis * sine, axis * (T::one() - cosine));
    Columns {
        x: Vector3::new(v.x.mul_add(axis.x, cosine), v.y.mul_add(axis.x, s.z), v.z.mul_add(axis.x, -s.y)),
        y: Vector3::new(v.x.mul_add(axis.y, -s.z), v.y.mul_add(axis.y, cosine), v.z.mul_add(axis.y, s.x)),
        z: Vector3::new(v.x.mul_add(axis.z, s.y), v.y.mul_add(axis.z, -s.x), v.z.mul_add(axis.z, cosine)),
    }
}
