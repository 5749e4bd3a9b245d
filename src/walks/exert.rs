//! What loads exert on bodies and in joints, where bodies stand as a posture says.

use crate::element::{Coordinates, Posture};
use crate::loading::{Load, Loading};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Mut, Of, Outward, Parallel, PerAxes, PerBody, PerJoint, Positions, Rates,
    Ref, Shape, Slot, Walk, alike,
};
use crate::space::{FrameOf, RealOf, Space};
use crate::visit::Visit;

/// Evaluates loads, body by body and joint by joint: a walk through bodies that are posed, and a visitor of those that are not.
pub struct Exert<'a, S: Space, L: Loading<S>> {
    loads: &'a L,
    seen: L::Seen,
    time: RealOf<S>,
    body: usize,
    joint: usize,
}

impl<'a, S: Space, L: Loading<S>> Exert<'a, S, L> {
    /// Of loads at a time (s), after what had to be seen first.
    #[inline(always)]
    pub fn new(loads: &'a L, time: RealOf<S>, seen: L::Seen) -> Self {
        Self { loads, seen, time, body: 0, joint: 0 }
    }

    /// How many bodies and joints it has met.
    pub fn met(&self) -> usize {
        self.body + self.joint
    }

    /// Stores the loads on all bodies and in all joints. Directions of bodies are read, not found by sines once more.
    #[cfg_attr(optimised, inline(always))]
    pub fn walk<E: Shape<S>>(
        mut self,
        chain: &E,
        ground: FrameOf<S>,
        Posture { x, y, p, q }: Posture<'_, S, E>,
        Coordinates { position, rate, acceleration }: Coordinates<'_, S, E>,
        on_bodies: &mut E::Store<PerBody<L::OnBody>>,
        in_joints: &mut E::Store<PerJoint<L::InJoint>>,
    ) {
        chain.outward(&mut self, ground, (x, y, p, q, position, rate, acceleration, on_bodies, in_joints));
    }
}

impl<S: Space, L: Loading<S>> Visit<S> for Exert<'_, S, L> {
    type OnBody = L::OnBody;
    type InJoint = L::InJoint;

    #[cfg_attr(optimised, inline(always))]
    fn body(&mut self, motion: &S::BodyMotion) -> L::OnBody {
        let load = self.loads.on_body(&self.seen, self.time, self.body, motion);
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

impl<S: Space, L: Loading<S>> Walk<S> for Exert<'_, S, L> {
    type Carried = FrameOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Positions>,
        Ref<Rates>,
        Ref<Rates>,
        Mut<PerBody<L::OnBody>>,
        Mut<PerJoint<L::InJoint>>,
    );
}

impl<S: Space, L: Loading<S>> Outward<S> for Exert<'_, S, L> {
    alike!();

    #[cfg_attr(optimised, inline(always))]
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        frame: FrameOf<S>,
        (x, y, p, q, _, _, _, load, _): AtBody<'_, S, Self, B>,
    ) -> FrameOf<S> {
        let (motion, outboard) = body.posed(frame, (x, y, p, q));
        *load = self.body_with::<B>(&motion);
        outboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (.., position, rate, acceleration, _, effort): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        let (motion, outboard) = joint.motion(frame, position, rate, acceleration);
        *effort = Visit::joint(self, &motion);
        outboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let (main, side, (.., effort)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let main = net.main_arm().outward(self, frame, main);
        let side = net.side_arm().outward(self, frame, side);
        *effort = Visit::joint(self, &net.closing_joint().joint(&side, &main));
        main
    }
}
