//! How far bodies are turned away from where they are held: n sin θ for an angle θ about n, and n 2 sin(θ/2) from afar.
//!
//! Near zero both are the turn. The first costs no root, but vanishes at half a turn, too, where the second is largest; it takes over at a
//! third of a turn, which no motion reaches that is held.

use super::Rotation;
use crate::relation::spatial::algebra::{Columns, cross, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// 1 − cos θ of a third of a turn.
const AFAR: f64 = 1.5;

/// The turn that takes axes from where they are held to their own, inertial axes.
pub(super) fn turned_away<T: Scalar>(held: &Columns<T>, own: &Columns<T>) -> Vector3<T> {
    // Σ d_k · (R d_k) = 1 + 2 cos θ; of lanes the farthest decides.
    let near = T::literal(3.0) - dot(held.x, own.x) - dot(held.y, own.y) - dot(held.z, own.z);
    if near.real() > T::Real::of(2.0 * AFAR) {
        let turn = Rotation::from_matrix(own).after(&Rotation::from_matrix(held).inverse()).shortest();
        return turn.v + turn.v;
    }
    sine_of_turn(held, own)
}

/// n sin θ of that turn: linear in the axes, and so defined for any three vectors.
pub(super) fn sine_of_turn<T: Scalar>(held: &Columns<T>, own: &Columns<T>) -> Vector3<T> {
    // For a small turn δ, Σ d_k × (d_k + δ × d_k) = 2 δ.
    let twice = cross(held.x, own.x) + cross(held.y, own.y) + cross(held.z, own.z);
    twice.map(|x| x.scale(T::Real::of(0.5)))
}

/// The part of a turn across an axis, along two `normals` of it, that takes it from where it is held to its own direction.
pub(super) fn tilted_away<T: Scalar>(held: Vector3<T>, own: Vector3<T>, normals: [Vector3<T>; 2]) -> [T; 2] {
    let [one, two] = sine_of_tilt(held, own, normals);
    let away = T::one() - dot(held, own);
    if away.real() > T::Real::of(AFAR) {
        // At half a turn any direction will do: the least number gives one.
        let one = one + T::constant(T::Real::EPSILON * T::Real::EPSILON);
        let chord = ((away + away) / (one * one + two * two)).sqrt();
        return [one * chord, two * chord];
    }
    [one, two]
}

/// The sine of that tilt: linear in the direction, and so defined for any vector.
pub(super) fn sine_of_tilt<T: Scalar>(held: Vector3<T>, own: Vector3<T>, normals: [Vector3<T>; 2]) -> [T; 2] {
    // For a small turn δ, n × (n + δ × n) is the part of δ across n.
    let sine = cross(held, own);
    normals.map(|normal| dot(normal, sine))
}
