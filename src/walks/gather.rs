//! Entries of bodies and joints, gathered from the tips to the root.

use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Inward, Joint, Mut, PerBody, PerJoint, Shape, Walk, alike,
};
use crate::space::Space;
use crate::visit::Gather;

/// Walks the entries of bodies and joints from tip to root, with what comes from the outboard side.
#[cfg_attr(optimised, inline(always))]
pub fn gather<S: Space, E: Shape<S>, G: Gather>(
    chain: &E,
    bodies: &mut E::Store<PerBody<G::Entry>>,
    joints: &mut E::Store<PerJoint<G::Entry>>,
    outer: G::Carried,
    gatherer: &mut G,
) -> G::Carried {
    chain.inward(&mut Gathering(gatherer), outer, (bodies, joints))
}

/// Shows each entry to a gatherer.
struct Gathering<'g, G>(&'g mut G);

impl<S: Space, G: Gather> Walk<S> for Gathering<'_, G> {
    type Carried = G::Carried;
    type Stores = (Mut<PerBody<G::Entry>>, Mut<PerJoint<G::Entry>>);
}

impl<S: Space, G: Gather> Inward<S> for Gathering<'_, G> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, outer: G::Carried, (body, _): AtBody<'_, S, Self, B>) -> G::Carried {
        self.0.meet(body, outer)
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, outer: G::Carried, (_, joint): AtJoint<'_, S, Self, J>) -> G::Carried {
        self.0.meet(joint, outer)
    }
    fn beyond(&mut self) -> G::Carried {
        self.0.beyond_arm()
    }
    fn join(&mut self, chain: G::Carried, arm: G::Carried) -> G::Carried {
        self.0.join(chain, arm)
    }
    fn closing<K: Closing<S>>(
        &mut self,
        _: &K,
        beyond: G::Carried,
        (_, joint): AtClosing<'_, S, Self, K>,
    ) -> [G::Carried; 2] {
        let closing = self.0.meet(joint, beyond);
        [closing, self.0.opposite(closing)]
    }
}
