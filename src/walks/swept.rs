//! Virtual velocities of bodies and joints, as walks want accelerations of stations.

use crate::adjoint::{Reversed, VirtualMotion};
use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerBody, PerJoint, Ref, Shape, Walk, alike};

/// What a walk of virtual velocities has kept, on bodies and in joints.
type Kept<'k, S, E> = (
    &'k <E as Shape<S>>::Store<PerBody<<S as VirtualMotion>::OnBody>>,
    &'k <E as Shape<S>>::Store<PerJoint<<S as VirtualMotion>::InJoint>>,
);

/// Copies what [`Stir`](super::stir::Stir) has kept to where [`PullBack`](super::pull_back::PullBack) reads accelerations.
pub fn swept<S: Reversed, E: Shape<S>>(
    chain: &E,
    (on_bodies, in_joints): Kept<'_, S, E>,
    at_bodies: &mut E::Store<PerBody<S::Vector>>,
    at_joints: &mut E::Store<PerJoint<S::Vector>>,
) {
    chain.outward(&mut Swept, (), (on_bodies, in_joints, at_bodies, at_joints));
}

struct Swept;

impl<S: Reversed> Walk<S> for Swept {
    type Carried = ();
    type Stores =
        (Ref<PerBody<S::OnBody>>, Ref<PerJoint<S::InJoint>>, Mut<PerBody<S::Vector>>, Mut<PerJoint<S::Vector>>);
}

impl<S: Reversed> Outward<S> for Swept {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (kept, (), reached, ()): AtBody<'_, S, Self, B>) {
        *reached = S::of_body(kept);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), ((), kept, (), reached): AtJoint<'_, S, Self, J>) {
        *reached = S::of_joint(kept);
    }
}
