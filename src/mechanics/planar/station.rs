//! Stations: what moves there, and what force and torque pass through.

use super::{BodyMotion, Frame, Internal, JointMotion, Planar};
use crate::relation::planar::algebra::{cross, dot, normal};
use crate::scalar::Scalar;
use crate::space::Balance;
use crate::state::StateVector;
use nalgebra::Vector2;

/// Indices of the planar state vector `[x, y, θ, m, q_x, q_y, 1]`, eq. (14).
pub mod index {
    /// Position (or acceleration) along x.
    pub const X: usize = 0;
    /// Position (or acceleration) along y.
    pub const Y: usize = 1;
    /// Angle (or angular acceleration).
    pub const THETA: usize = 2;
    /// Internal torque.
    pub const M: usize = 3;
    /// Internal force along x.
    pub const QX: usize = 4;
    /// Internal force along y.
    pub const QY: usize = 5;
    /// The constant one.
    pub const ONE: usize = 6;
}

/// A station at an instant: the inboard end of an element, or the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station<T> {
    /// Motion of the station, with the body on its inboard side if it is the end of a joint.
    pub frame: Frame<T>,
    /// From here to the next station outboard (m).
    arm: Vector2<T>,
    /// Inertia force less loads of the element outboard (N).
    inertia_force: Vector2<T>,
    /// Inertia torque less loads of the element outboard, about this station (N·m).
    inertia_torque: T,
    /// Internal force and torque.
    pub internal: Internal<T>,
}

impl<T: Scalar> Station<T> {
    /// Where an element without mass or extent begins.
    pub(super) fn massless(frame: Frame<T>) -> Self {
        let zero = Vector2::new(T::zero(), T::zero());
        let internal = Internal { force: zero, torque: T::zero() };
        Self { frame, arm: zero, inertia_force: zero, inertia_torque: T::zero(), internal }
    }

    /// Torque ON what lies outboard of the station (N·m), −m: at the station of a joint, what the joint exerts on its outboard body.
    pub fn torque_outboard(&self) -> T {
        -self.internal.torque
    }

    /// The state vector (14) of positions: `[x, y, θ, m, q_x, q_y, 1]`.
    pub fn state(&self) -> StateVector<T, 7> {
        let (place, internal) = (self.frame.place, self.internal);
        StateVector::new([
            place.x,
            place.y,
            self.frame.turn.angle,
            internal.torque,
            internal.force.x,
            internal.force.y,
            T::one(),
        ])
    }

    /// The state vector of accelerations, `[ẍ, ÿ, θ̈, m, q_x, q_y, 1]`, which exact transfer matrices act on.
    pub fn acceleration_state(&self) -> StateVector<T, 7> {
        let (acceleration, internal) = (self.frame.acceleration, self.internal);
        StateVector::new([
            acceleration.linear.x,
            acceleration.linear.y,
            acceleration.angular,
            internal.torque,
            internal.force.x,
            internal.force.y,
            T::one(),
        ])
    }
}

impl<T: Scalar> Balance<Planar<T>> for Station<T> {
    fn of_body(body: &BodyMotion<T>, gravity: Vector2<T>) -> Self {
        let force = (body.centre().acceleration.linear - gravity) * body.inertia.mass;
        let torque = body.inertia.about_centre * body.inboard.acceleration.angular + cross(body.to_centre, force);
        Self { arm: body.arm, inertia_force: force, inertia_torque: torque, ..Self::massless(body.inboard) }
    }
    fn of_joint(joint: &JointMotion<T>) -> Self {
        Self { arm: joint.arm, ..Self::massless(joint.inboard) }
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
            torque: outer.torque - dot(normal(self.arm), outer.force) - self.inertia_torque,
        };
        self.internal
    }
}
