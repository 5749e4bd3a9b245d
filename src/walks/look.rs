//! Where the tip of a chain is.

use crate::element::Coordinates;
use crate::shape::{
    AtBody, AtJoint, Body, Joint, Of, Outward, Parallel, Positions, Rates, Ref, Shape, Slot, Walk, alike,
};
use crate::space::Space;

/// The frame at the end of a walk outward with complete kinematics: place, orientation, velocity and acceleration of the tip.
#[inline]
pub fn look<S: Space, E: Shape<S>>(chain: &E, frame: S::Frame, motion: Coordinates<'_, S, E>) -> S::Frame {
    let Coordinates { position, rate, acceleration } = motion;
    chain.outward(&mut Look, frame, (position, rate, acceleration))
}

/// Looks at nothing on the way.
struct Look;

impl<S: Space> Walk<S> for Look {
    type Carried = S::Frame;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Look {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, body: &B, frame: S::Frame, _: AtBody<'_, S, Self, B>) -> S::Frame {
        body.motion(frame).1
    }
    #[inline(always)]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: S::Frame,
        (position, rate, acceleration): AtJoint<'_, S, Self, J>,
    ) -> S::Frame {
        joint.motion(frame, position, rate, acceleration).1
    }
    /// The tip is that of the main arm.
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: S::Frame, stores: Of<'_, S, Self, N>) -> S::Frame {
        let (main, ..) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        net.main_arm().outward(self, frame, main)
    }
}
