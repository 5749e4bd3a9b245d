//! What loads exert on bodies and in joints.

use crate::loading::{Load, Loading};
use crate::shape::Body;
use crate::space::{RealOf, Space};
use crate::visit::Visit;

/// Evaluates loads, body by body and joint by joint.
pub struct Exert<'a, S: Space, L: Loading<S>> {
    loads: &'a L,
    seen: &'a L::Seen,
    time: RealOf<S>,
    body: usize,
    joint: usize,
}

impl<'a, S: Space, L: Loading<S>> Exert<'a, S, L> {
    /// Of loads at a time (s), after what had to be seen first.
    #[inline(always)]
    pub fn new(loads: &'a L, time: RealOf<S>, seen: &'a L::Seen) -> Self {
        Self { loads, seen, time, body: 0, joint: 0 }
    }

    /// How many bodies and joints it has met.
    pub fn met(&self) -> usize {
        self.body + self.joint
    }
}

impl<S: Space, L: Loading<S>> Visit<S> for Exert<'_, S, L> {
    type OnBody = L::OnBody;
    type InJoint = L::InJoint;

    #[cfg_attr(optimised, inline(always))]
    fn body(&mut self, motion: &S::BodyMotion) -> L::OnBody {
        let load = self.loads.on_body(self.seen, self.time, self.body, motion);
        self.body += 1;
        load
    }
    #[inline(always)]
    fn body_with<B: Body<S>>(&mut self, motion: &S::BodyMotion) -> L::OnBody {
        let load = Visit::body(self, motion);
        if const { B::OWN_AXES } { load.in_own_axes(motion) } else { load }
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint(&mut self, motion: &S::JointMotion) -> L::InJoint {
        let torque = self.loads.in_joint(self.time, self.joint, motion);
        self.joint += 1;
        torque
    }
}
