//! Twists and wrenches about one origin, the place of the base, in inertial axes.
//!
//! About one origin what bodies have adds up, and nothing is carried from joint to joint.

use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot, dot_onto};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Velocity of what passes through the origin and angular velocity, or the same of acceleration; or force and torque.
pub type Pair<T> = [Vector3<T>; 2];

/// Power of a wrench along a twist.
#[inline(always)]
pub fn along<T: Scalar>([linear, angular]: Pair<T>, [force, torque]: Pair<T>) -> T {
    dot_onto(linear, force, dot(angular, torque))
}

/// v × m: how a twist changes that is carried by another.
#[inline(always)]
pub fn swept<T: Scalar>([v, spin]: Pair<T>, [linear, angular]: Pair<T>) -> Pair<T> {
    [cross_onto(spin, linear, cross(v, angular)), cross(spin, angular)]
}

/// v ×* f: how a wrench changes that is carried by a twist.
#[inline(always)]
pub fn swept_wrench<T: Scalar>([v, spin]: Pair<T>, [force, torque]: Pair<T>) -> Pair<T> {
    [cross(spin, force), cross_onto(spin, torque, cross(v, force))]
}

/// a + factor · b.
#[inline(always)]
pub fn more<T: Scalar>(a: Pair<T>, factor: T, b: Pair<T>) -> Pair<T> {
    [add_scaled(a[0], factor, b[0]), add_scaled(a[1], factor, b[1])]
}

/// a + b.
#[inline(always)]
pub fn sum<T: Scalar>(a: Pair<T>, b: Pair<T>) -> Pair<T> {
    [a[0] + b[0], a[1] + b[1]]
}
