//! What walks over a scene do at its bodies, at its joints and where arms leave.

use crate::element::{Coordinates, Element};
use crate::space::Space;

/// A visitor of [`Element::travel`](crate::element::Element::travel).
pub trait Visit<S: Space> {
    /// Entry written for each body.
    type OnBody: Copy;
    /// Entry written for each joint.
    type InJoint: Copy;

    /// Meets a body.
    fn body(&mut self, body: &S::BodyMotion) -> Self::OnBody;
    /// Meets a joint.
    fn joint(&mut self, joint: &S::JointMotion) -> Self::InJoint;

    /// Meets what closes a loop, the force and torque that it passes on: a joint too.
    fn closing(&mut self, joint: &S::JointMotion, internal: S::Internal) -> Self::InJoint {
        let _ = internal;
        self.joint(joint)
    }

    /// Leaves the chain for an arm of it.
    fn enter_arm(&mut self) {}
    /// Comes back to where that arm began.
    fn leave_arm(&mut self) {}
}

/// A gatherer of [`Element::inward`](crate::element::Element::inward): internal forces that add up from the tips to the root, for example.
pub trait Gather {
    /// What it reads or writes of each body and joint.
    type Entry: Copy;
    /// What it carries inward.
    type Carried: Copy;

    /// Meets a body or a joint, with what comes from its outboard side; gives what goes on inward.
    fn meet(&mut self, entry: &mut Self::Entry, outer: Self::Carried) -> Self::Carried;
    /// What comes from beyond the tip of an arm.
    fn beyond_arm(&mut self) -> Self::Carried;
    /// What comes from the other side of what closes a loop.
    fn opposite(&mut self, closing: Self::Carried) -> Self::Carried;
    /// What goes on inward where an arm joins the chain.
    fn join(&mut self, chain: Self::Carried, arm: Self::Carried) -> Self::Carried;
}

/// What is to be corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Positions.
    Place,
    /// Rates.
    Velocity,
}

/// The frame at the end of a walk outward.
pub fn look<S: Space, E: Element<S>>(element: &E, frame: S::Frame, motion: Coordinates<'_, S, E>) -> S::Frame {
    element.travel(frame, motion, &mut Look, &mut element.per_body(()), &mut element.per_joint(()))
}

/// Looks at nothing.
struct Look;

impl<S: Space> Visit<S> for Look {
    type OnBody = ();
    type InJoint = ();
    fn body(&mut self, _: &S::BodyMotion) {}
    fn joint(&mut self, _: &S::JointMotion) {}
}
