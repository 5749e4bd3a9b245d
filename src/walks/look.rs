//! Where the tip of a chain is.

use crate::element::Coordinates;
use crate::shape::{
    AtBody, AtJoint, Body, Joint, Of, Outward, Parallel, Positions, Rates, Ref, Shape, Slot, Walk, alike,
};
use crate::space::{FrameOf, Space};

/// The frame at the end of a walk outward with complete kinematics: place, orientation, velocity and acceleration of the tip.
#[inline]
pub fn look<S: Space, E: Shape<S>>(chain: &E, frame: FrameOf<S>, motion: Coordinates<'_, S, E>) -> FrameOf<S> {
    let Coordinates { position, rate, acceleration } = motion;
    chain.outward(&mut Look, frame, (position, rate, acceleration))
}

/// Looks at nothing on the way.
struct Look;

impl<S: Space> Walk<S> for Look {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Look {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, body: &B, frame: FrameOf<S>, _: AtBody<'_, S, Self, B>) -> FrameOf<S> {
        body.motion(frame).1
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, acceleration): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        joint.motion(frame, position, rate, acceleration).1
    }
    /// The tip is that of the main arm.
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let (main, ..) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        net.main_arm().outward(self, frame, main)
    }
}
