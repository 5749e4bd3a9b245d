//! Kinematics from the root to the tips, where bodies stand as a posture says, shown to a visitor.

use crate::element::{Coordinates, Posture};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Mut, Of, Outward, Parallel, PerAxes, PerBody, PerJoint, Positions, Rates,
    Ref, Shape, Slot, Walk, alike,
};
use crate::space::{FrameOf, Space};
use crate::visit::Visit;

/// Walks outward and lets a visitor write an entry for each body and joint; gives the frame of the tip. Directions of bodies are read, not found
/// by sines once more. The visitor is not told of arms; what closes a loop is a joint to it.
#[cfg_attr(optimised, inline(always))]
pub fn travel_posed<S: Space, E: Shape<S>, V: Visit<S>>(
    chain: &E,
    ground: FrameOf<S>,
    Posture { x, y, p, q }: Posture<'_, S, E>,
    Coordinates { position, rate, acceleration }: Coordinates<'_, S, E>,
    visit: V,
    on_bodies: &mut E::Store<PerBody<V::OnBody>>,
    in_joints: &mut E::Store<PerJoint<V::InJoint>>,
) -> FrameOf<S> {
    chain.outward(&mut Posed(visit), ground, (x, y, p, q, position, rate, acceleration, on_bodies, in_joints))
}

/// Shows bodies as they are posed.
struct Posed<V>(V);

impl<S: Space, V: Visit<S>> Walk<S> for Posed<V> {
    type Carried = FrameOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Positions>,
        Ref<Rates>,
        Ref<Rates>,
        Mut<PerBody<V::OnBody>>,
        Mut<PerJoint<V::InJoint>>,
    );
}

impl<S: Space, V: Visit<S>> Outward<S> for Posed<V> {
    alike!();

    #[cfg_attr(optimised, inline(always))]
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        frame: FrameOf<S>,
        (x, y, p, q, _, _, _, entry, _): AtBody<'_, S, Self, B>,
    ) -> FrameOf<S> {
        let (motion, outboard) = body.posed(frame, (x, y, p, q));
        *entry = self.0.body_with::<B>(&motion);
        outboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (.., position, rate, acceleration, _, entry): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        let (motion, outboard) = joint.motion(frame, position, rate, acceleration);
        *entry = self.0.joint(&motion);
        outboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let (main, side, (.., entry)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let main = net.main_arm().outward(self, frame, main);
        let side = net.side_arm().outward(self, frame, side);
        *entry = self.0.joint(&net.closing_joint().joint(&side, &main));
        main
    }
}
