//! What is read of bodies, joints and stations in motion.

use super::{Budget, FrameOf, Space};
use crate::error::Fault;
use crate::relation::WrenchOf;
use crate::release::Release;

/// What is read of a body and its motion, whatever its space.
pub trait MovingBody<S: Space> {
    /// The mass of the body (kg).
    fn mass(&self) -> S::Scalar;
    /// What may be wrong with the inertia of the body.
    fn doubt(&self) -> Option<Fault>;
    /// Whether the body has no inertia about the line from its inboard to its outboard end, but for rounding. In the plane there is none.
    fn spins_about_its_line(&self) -> bool {
        false
    }
    /// The orientation of the body in angles.
    fn angles(&self) -> S::Angles;
    /// The angle (rad) of the body if it is too large for accurate sines.
    fn angle_out_of_range(&self) -> Option<f64>;
    /// A force and a torque in axes of the body. In the plane no body asks for that.
    #[inline(always)]
    fn in_own_axes(&self, load: WrenchOf<S>) -> WrenchOf<S> {
        load
    }
    /// Mechanical energy, linear momentum and angular momentum about the origin of the body.
    fn budget(&self, gravity: S::Vector) -> Budget<S>;
}

/// What is read of a joint and its motion, whatever its space.
pub trait MovingJoint<S: Space> {
    /// The angle (rad) that the joint has turned by if it is too large for accurate sines.
    fn turn_out_of_range(&self, release: &Release<S>) -> Option<f64>;
    /// Kinetic energy of reflected inertia in the joint, and energy stored there (J).
    fn stored(&self) -> [S::Scalar; 2];
}

/// The balance of forces at a station.
pub trait Balance<S: Space>: Sized {
    /// The inboard end of a body in a field of gravity, with the body's inertia force in its balance.
    fn of_body(body: &S::BodyMotion, gravity: S::Vector) -> Self;
    /// The inboard side of a joint.
    fn of_joint(joint: &S::JointMotion) -> Self;
    /// The inboard side of what closes a loop, which passes this force and torque on.
    fn of_closing(joint: &S::JointMotion, internal: WrenchOf<S>) -> Self;
    /// The end of a chain, with its force and torque.
    fn at_end(frame: FrameOf<S>, internal: WrenchOf<S>) -> Self;
    /// Takes a load from the balance.
    fn relieve(&mut self, load: WrenchOf<S>);
    /// Closes the balance, given the internal force at the outboard neighbour; gives that of this station.
    fn close(&mut self, outer: WrenchOf<S>) -> WrenchOf<S>;
}
