//! The paper's angles θ₁, θ₂, θ₃ (1-2-3), for input and output.
//!
//! A = R_z(θ₃) R_y(θ₂) R_x(θ₁). At θ₂ = ±π/2 only θ₁ ∓ θ₃ is determined: dynamics never uses these angles, and readers of them get
//! the values nearest to those before.

use super::Rotation;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;
use num_traits::Zero;

/// cos θ₂ below which an attitude counts as singular, or 16 roundings of its numbers.
const SINGULAR: f64 = 1e-8;

impl<T: Scalar> Rotation<T> {
    /// The attitude with angles θ₁, θ₂, θ₃ (rad).
    pub fn from_angles(angles: [T; 3]) -> Self {
        let [one, two, three] = angles.map(|angle| angle.scale(T::Real::of(0.5)).sin_cos());
        let o = T::zero();
        let turn = |(sine, cosine): (T, T), axis: Vector3<T>| Self { w: cosine, v: axis * sine };
        let x = turn(one, Vector3::new(T::one(), o, o));
        let y = turn(two, Vector3::new(o, T::one(), o));
        let z = turn(three, Vector3::new(o, o, T::one()));
        z.after(&y).after(&x)
    }

    /// The angles θ₁, θ₂, θ₃ (rad), with θ₂ between −π/2 and π/2; θ₃ = 0 where the attitude is singular.
    pub fn angles(&self) -> [T; 3] {
        angles(&self.matrix())
    }

    /// The angles nearest to `previous`, unwrapped: follow a motion with these.
    pub fn angles_near(&self, previous: [T; 3]) -> [T; 3] {
        angles_near(&self.matrix(), previous)
    }

    /// The rotation of orthonormal columns.
    pub fn from_matrix(matrix: &Columns<T>) -> Self {
        let Columns { x, y, z } = matrix;
        let (one, half) = (T::one(), T::Real::of(0.5));
        // The largest of 4w², 4x², 4y², 4z² is at least 1 and loses no digits.
        let squares = [one + x.x + y.y + z.z, one + x.x - y.y - z.z, one - x.x + y.y - z.z, one - x.x - y.y + z.z];
        let largest = (1..4).fold(0, |best, k| if squares[k].real() > squares[best].real() { k } else { best });
        let double = squares[largest].sqrt();
        let quarter = double.recip().scale(half);
        let [a, b, c] = [y.z - z.y, z.x - x.z, x.y - y.x].map(|entry| entry * quarter);
        let [xy, xz, yz] = [x.y + y.x, x.z + z.x, y.z + z.y].map(|entry| entry * quarter);
        let own = double.scale(half);
        let [w, x, y, z] = [[own, a, b, c], [a, own, xy, xz], [b, xy, own, yz], [c, xz, yz, own]][largest];
        Self { w, v: Vector3::new(x, y, z) }
    }
}

/// cos θ₂, and the angles where it vanishes, for a choice of θ₃.
fn singular<T: Scalar>(a: &Columns<T>, third: T) -> (T, Option<[T; 3]>) {
    let square = a.x.x * a.x.x + a.x.y * a.x.y;
    let least = T::Real::of(SINGULAR).max(T::Real::EPSILON * T::Real::of(16.0));
    if square.real() >= least * least {
        return (square.sqrt(), None);
    }
    // Written without the cosine, which has no derivative here.
    let right = T::literal(core::f64::consts::FRAC_PI_2);
    let angles = if a.x.z.real().as_f64() < 0.0 {
        [a.y.x.atan2(a.y.y) + third, right, third] // θ₁ − θ₃
    } else {
        [(-a.y.x).atan2(a.y.y) - third, -right, third] // θ₁ + θ₃
    };
    (T::zero(), Some(angles))
}

/// The angles of orthonormal columns with θ₂ between −π/2 and π/2.
pub(super) fn angles<T: Scalar>(a: &Columns<T>) -> [T; 3] {
    let (cosine, singular) = singular(a, T::zero());
    singular.unwrap_or_else(|| [a.y.z.atan2(a.z.z), (-a.x.z).atan2(cosine), a.x.y.atan2(a.x.x)])
}

/// The angles of orthonormal columns that are nearest to `previous`.
fn angles_near<T: Scalar>(a: &Columns<T>, previous: [T; 3]) -> [T; 3] {
    if let (_, Some([first, second, third])) = singular(a, previous[2]) {
        return [unwrapped(first, previous[0]), unwrapped(second, previous[1]), third];
    }
    let angles = angles(a);
    let pi = T::literal(core::f64::consts::PI);
    let other = [angles[0] + pi, pi - angles[1], angles[2] + pi];
    let near = |set: [T; 3]| core::array::from_fn(|k| unwrapped(set[k], previous[k]));
    let distance =
        |set: &[T; 3]| set.iter().zip(previous).fold(T::Real::zero(), |sum, (a, b)| sum + (*a - b).real().abs());
    let (first, second): ([T; 3], [T; 3]) = (near(angles), near(other));
    if distance(&second) < distance(&first) { second } else { first }
}

/// An angle changed by whole turns to come nearest to another one.
fn unwrapped<T: Scalar>(angle: T, near: T) -> T {
    let turn = core::f64::consts::TAU;
    let turns = (near - angle).real().as_f64() / turn;
    // Rounded half away from zero by hand: without `std` there is no `round`.
    let turns = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i64 as f64;
    angle + T::literal(turns * turn)
}
