//! How bodies stand where axes of bodies end and inertial ones begin.

use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerAxes, Positions, Rates, Ref, Shape, Walk, alike};
use crate::space::{FrameOf, Space};

/// Tells each joint that asks for it ([`Joint::set_attitude`]) how its body is turned, by a walk with complete kinematics: poses in axes of bodies carry no
/// attitudes. Chains without such a joint have none of it.
#[cfg_attr(optimised, inline(always))]
pub fn faced<S: Space, E: Shape<S>>(
    chain: &E,
    ground: FrameOf<S>,
    position: &E::Store<Positions>,
    rate: &E::Store<Rates>,
    x: &mut E::Store<PerAxes<S::X>>,
) {
    if const { E::FLANGED } {
        chain.outward(&mut Faced, ground, (position, rate, x));
    }
}

/// Tells what it carries.
struct Faced;

impl<S: Space> Walk<S> for Faced {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Mut<PerAxes<S::X>>);
}

impl<S: Space> Outward<S> for Faced {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, frame: FrameOf<S>, _: AtBody<'_, S, Self, B>) -> FrameOf<S> {
        body.motion(frame).1
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, x): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        joint.set_attitude(x, &frame.turn);
        joint.motion(frame, position, rate, &J::still().1).1
    }
}
