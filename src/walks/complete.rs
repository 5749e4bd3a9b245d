//! Costates of base parameters as they are, from sums over stages.

use crate::adjoint::Reversed;
use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerBody, Shape, Walk, alike};

/// Puts in what depends on the sizes of bodies alone, once for a run.
pub fn complete<S: Reversed, E: Shape<S>>(chain: &E, bodies: &mut E::Store<PerBody<S::OfBody>>) {
    chain.outward(&mut Complete, (), (bodies,));
}

struct Complete;

impl<S: Reversed> Walk<S> for Complete {
    type Carried = ();
    type Stores = (Mut<PerBody<S::OfBody>>,);
}

impl<S: Reversed> Outward<S> for Complete {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, (): (), (sums,): AtBody<'_, S, Self, B>) {
        S::complete(&body.size(), sums);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
}
