//! The paper's angles θ₁, θ₂, θ₃ (1-2-3), for input and output.
//!
//! A = R_z(θ₃) R_y(θ₂) R_x(θ₁). At θ₂ = ±π/2 only θ₁ ∓ θ₃ is determined: dynamics never uses these angles, and readers of them get
//! the values nearest to those before.

use super::Rotation;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

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
        let [a, b, c] = [y.z - z.y, z.x - x.z, x.y - y.x];
        let [xy, xz, yz] = [x.y + y.x, x.z + z.x, y.z + z.y];
        let rows = [[one, a, b, c], [a, one, xy, xz], [b, xy, one, yz], [c, xz, yz, one]];
        let own = |k: usize| core::array::from_fn(|j| if j == k { -one } else { one });
        let (mut square, mut row, mut owns): (_, _, [T; 4]) = (squares[0], rows[0], own(0));
        for k in 1..4 {
            let less = square - squares[k];
            let choose = |other: [T; 4], best: [T; 4]| core::array::from_fn(|j| less.if_negative(other[j], best[j]));
            square = less.if_negative(squares[k], square);
            (row, owns) = (choose(rows[k], row), choose(own(k), owns));
        }
        let double = square.sqrt();
        let (own, quarter) = (double.scale(half), double.recip().scale(half));
        let [w, x, y, z] = core::array::from_fn(|j| owns[j].if_negative(own, row[j] * quarter));
        Self { w, v: Vector3::new(x, y, z) }
    }
}

/// Below zero where the attitude is singular; cos θ₂ squared; the angles that hold there, for a choice of θ₃.
fn singular<T: Scalar>(a: &Columns<T>, third: T) -> (T, T, [T; 3]) {
    let square = a.x.x * a.x.x + a.x.y * a.x.y;
    let least = T::Real::of(SINGULAR).max(T::Real::EPSILON * T::Real::of(16.0));
    // Written without the cosine, which has no derivative here.
    let right = T::literal(core::f64::consts::FRAC_PI_2);
    let down = [a.y.x.atan2(a.y.y) + third, right, third]; // θ₁ − θ₃
    let up = [(-a.y.x).atan2(a.y.y) - third, -right, third]; // θ₁ + θ₃
    (square - T::constant(least * least), square, either(a.x.z, down, up))
}

/// One set of angles where a number is below zero, else the other.
fn either<T: Scalar>(negative: T, then: [T; 3], otherwise: [T; 3]) -> [T; 3] {
    core::array::from_fn(|k| negative.if_negative(then[k], otherwise[k]))
}

/// The angles of orthonormal columns with θ₂ between −π/2 and π/2.
pub(super) fn angles<T: Scalar>(a: &Columns<T>) -> [T; 3] {
    let (decides, square, singular) = singular(a, T::zero());
    either(decides, singular, [a.y.z.atan2(a.z.z), (-a.x.z).atan2(square.sqrt()), a.x.y.atan2(a.x.x)])
}

/// The angles of orthonormal columns that are nearest to `previous`.
fn angles_near<T: Scalar>(a: &Columns<T>, previous: [T; 3]) -> [T; 3] {
    let near = |set: [T; 3]| core::array::from_fn(|k| unwrapped(set[k], previous[k]));
    let distance = |set: &[T; 3]| set.iter().zip(previous).fold(T::zero(), |sum, (a, b)| sum + (*a - b).abs());
    let (decides, _, [first, second, third]) = singular(a, previous[2]);
    let held = [unwrapped(first, previous[0]), unwrapped(second, previous[1]), third];
    let angles = angles(a);
    let pi = T::literal(core::f64::consts::PI);
    let (one, other): ([T; 3], [T; 3]) = (near(angles), near([angles[0] + pi, pi - angles[1], angles[2] + pi]));
    either(decides, held, either(distance(&other) - distance(&one), other, one))
}

/// An angle changed by whole turns to come nearest to another one.
fn unwrapped<T: Scalar>(angle: T, near: T) -> T {
    let turn = core::f64::consts::TAU;
    if !T::LANES {
        let turns = (near - angle).real().as_f64() / turn;
        // Rounded half away from zero by hand: without `std` there is no `round`.
        let turns = (turns + if turns < 0.0 { -0.5 } else { 0.5 }) as i64 as f64;
        return angle + T::literal(turns * turn);
    }
    // Digit by digit: lanes turn by numbers of their own.
    let apart = (near - angle).scale(T::Real::of(1.0 / turn));
    let (mut left, mut turns) = (apart.abs() + T::literal(0.5), T::zero());
    for digit in (0..63).rev().map(|k| T::literal((1_u64 << k) as f64)) {
        let rest = left - digit;
        (left, turns) = (rest.if_negative(left, rest), rest.if_negative(turns, turns + digit));
    }
    angle + (turns * apart.sign()).scale(T::Real::of(turn))
}
