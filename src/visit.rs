//! What walks over a scene do at its bodies, at its joints and where arms leave.

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
    /// What goes on inward where an arm joins the chain.
    fn join(&mut self, chain: Self::Carried, arm: Self::Carried) -> Self::Carried;
}
