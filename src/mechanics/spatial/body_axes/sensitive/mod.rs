//! Derivatives through kept gains in body axes.
//!
//! All that is carried is in axes of the body on the inboard side: columns of ω, of the acceleration of the origin and of α outward, of a
//! force and torque about it inward. How bodies are turned is nobody's concern, for gravity is an acceleration of the ground: a coordinate
//! acts where it is. So there are no columns of attitudes, and zeros of places, turns and tensors drop columns, too. What walks do at an
//! element is a function of its own: inlined, arms of seven joints took minutes to compile, and a call is nothing beside eight columns.

mod joints;
mod links;
mod mounts;
mod products;

use crate::scalar::{Jet, Scalar};
use nalgebra::Vector3;

/// A vector and its columns, as numbers with derivatives.
fn jets<T: Scalar, const K: usize>(v: Vector3<T>, columns: &[[T; K]; 3]) -> [Jet<T, K>; 3] {
    let [x, y, z] = *columns;
    [Jet { re: v.x, eps: x }, Jet { re: v.y, eps: y }, Jet { re: v.z, eps: z }]
}
