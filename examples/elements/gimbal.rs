//! A joint of two coordinates: a crosspiece that one geared motor turns, and on which another one sits.

use super::geared::Geared;
use catena::Scalar;
use catena::spatial::{Revolute, RigidBody};

type Motor<T> = Geared<T, Revolute<T>>;
/// Between the motors stands a crosspiece without mass, whose ends coincide.
type Parts<T> = (Motor<T>, RigidBody<T>, Motor<T>);

/// A universal joint with a motor about each axis; its coordinates are their angles (rad), each with a friction and reflected inertia.
#[derive(Clone, Copy, Debug)]
pub struct Gimbal<T> {
    parts: Parts<T>,
}

catena::compound!([T: Scalar] Gimbal<T> { parts: Parts<T> });
catena::lift!(Gimbal<T> { parts });

impl<T: Scalar> Gimbal<T> {
    /// About an axis of the inboard body, and one of the outboard body.
    pub fn of(first: Motor<T>, second: Motor<T>) -> Self {
        Self { parts: (first, RigidBody::massless([T::zero(); 3]), second) }
    }
}
