//! Stations: what moves there, and what force and torque pass through.

use super::angles::angles;
use super::{BodyMotion, Frame, Internal, JointMotion, Spatial};
use crate::relation::spatial::algebra::{cross, cross_onto, zero};
use crate::scalar::Scalar;
use crate::space::Balance;
use crate::state::StateVector;
use nalgebra::Vector3;

/// Indices of the spatial state vector `[r, θ, m, q, 1]`: first entries of its vectors, eq. (4).
pub mod index {
    /// Position (or acceleration), three entries.
    pub const R: usize = 0;
    /// Angles (or angular acceleration), three entries.
    pub const THETA: usize = 3;
    /// Internal torque, three entries.
    pub const M: usize = 6;
    /// Internal force, three entries.
    pub const Q: usize = 9;
    /// The constant one.
    pub const ONE: usize = 12;
}

/// A station at an instant: the inboard end of an element, or the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station<T> {
    /// Motion of the station, with the body on its inboard side if it is the end of a joint.
    pub frame: Frame<T>,
    /// From here to the next station outboard (m).
    arm: Vector3<T>,
    /// Inertia force less loads of the element outboard (N).
    inertia_force: Vector3<T>,
    /// Inertia torque less loads of the element outboard, about this station (N·m).
    inertia_torque: Vector3<T>,
    /// Internal force and torque.
    pub internal: Internal<T>,
}

impl<T: Scalar> Station<T> {
    /// Where an element without mass or extent begins.
    pub(super) fn massless(frame: Frame<T>) -> Self {
        let internal = Internal { force: zero(), torque: zero() };
        Self { frame, arm: zero(), inertia_force: zero(), inertia_torque: zero(), internal }
    }

    /// Torque ON what lies outboard of the station (N·m), −m: at the station of a joint, what the joint exerts on its outboard body.
    pub fn torque_outboard(&self) -> Vector3<T> {
        -self.internal.torque
    }

    /// The state vector of positions: `[r, θ, m, q, 1]` with the angles 1-2-3.
    pub fn state(&self) -> StateVector<T, 13> {
        self.vector(self.frame.place, Vector3::from(angles(&self.frame.turn.attitude)))
    }

    /// The state vector of accelerations, `[r̈, ω̇, m, q, 1]`, which exact transfer matrices act on.
    pub fn acceleration_state(&self) -> StateVector<T, 13> {
        self.vector(self.frame.acceleration.linear, self.frame.acceleration.angular)
    }

    fn vector(&self, r: Vector3<T>, theta: Vector3<T>) -> StateVector<T, 13> {
        let (m, q) = (self.internal.torque, self.internal.force);
        StateVector::new([r.x, r.y, r.z, theta.x, theta.y, theta.z, m.x, m.y, m.z, q.x, q.y, q.z, T::one()])
    }
}

impl<T: Scalar> Balance<Spatial<T>> for Station<T> {
    fn of_body(body: &BodyMotion<T>, gravity: Vector3<T>) -> Self {
        let turn = body.inboard.turn;
        let force = (body.centre().acceleration.linear - gravity) * body.inertia.mass;
        let angular = turn.attitude.transposed(body.inboard.acceleration.angular);
        let own = turn.attitude.apply(body.inertia.matrix().apply(angular));
        let torque = cross_onto(turn.spin, body.spin_momentum(), own) + cross(body.to_centre, force);
        Self { arm: body.arm, inertia_force: force, inertia_torque: torque, ..Self::massless(body.inboard) }
    }
    /// The inboard side of a joint, whose points may have slid apart.
    fn of_joint(joint: &JointMotion<T>) -> Self {
        Self { arm: joint.outboard.place - joint.inboard.place, ..Self::massless(joint.inboard) }
    }
    fn of_closing(joint: &JointMotion<T>, internal: Internal<T>) -> Self {
        let station = Self::massless(joint.inboard);
        Self { inertia_force: internal.force, inertia_torque: -internal.torque, ..station }
    }
    fn at_end(frame: Frame<T>, internal: Internal<T>) -> Self {
        Self { internal, ..Self::massless(frame) }
    }
    fn relieve(&mut self, load: Internal<T>) {
        self.inertia_force -= load.force;
        self.inertia_torque -= load.torque;
    }
    /// (19) and (20): q_I = q_O + inertia, m_I = m_O − d_O × q_O − inertia about I.
    fn close(&mut self, outer: Internal<T>) -> Internal<T> {
        self.internal = Internal {
            force: outer.force + self.inertia_force,
            torque: outer.torque - cross(self.arm, outer.force) - self.inertia_torque,
        };
        self.internal
    }
}
