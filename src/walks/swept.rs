//! Virtual velocities of bodies and joints, as walks want accelerations of stations.

use crate::adjoint::{Holds, Reversed};
use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerBody, PerJoint, Ref, Shape, Walk, alike};
use core::marker::PhantomData;

/// What a walk of virtual velocities has kept, on bodies and in joints.
type Kept<'k, S, E> = (
    &'k <E as Shape<S>>::Store<PerBody<<S as Reversed>::OnBody>>,
    &'k <E as Shape<S>>::Store<PerJoint<<S as Reversed>::InJoint>>,
);

/// Copies what [`Stir`](super::stir::Stir) has kept to where [`PullBack`](super::pull_back::PullBack) reads accelerations.
pub fn swept<S: Reversed, P: Holds<S>, E: Shape<S>>(
    chain: &E,
    (on_bodies, in_joints): Kept<'_, S, E>,
    at_bodies: &mut E::Store<PerBody<S::Vector>>,
    at_joints: &mut E::Store<PerJoint<S::Vector>>,
) {
    chain.outward(&mut Swept::<P>(PhantomData), (), (on_bodies, in_joints, at_bodies, at_joints));
}

struct Swept<P>(PhantomData<P>);

impl<S: Reversed, P> Walk<S> for Swept<P> {
    type Carried = ();
    type Stores =
        (Ref<PerBody<S::OnBody>>, Ref<PerJoint<S::InJoint>>, Mut<PerBody<S::Vector>>, Mut<PerJoint<S::Vector>>);
}

impl<S: Reversed, P: Holds<S>> Outward<S> for Swept<P> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (kept, (), reached, ()): AtBody<'_, S, Self, B>) {
        *reached = P::of_body(kept);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), ((), kept, (), reached): AtJoint<'_, S, Self, J>) {
        *reached = P::of_joint(kept);
    }
}
