//! What resolving a posture reads of the shapes of bodies, written down once for a scene.

use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerAxes, Shape, Walk, alike};
use crate::space::Space;

/// What `Element::resolve` reads of the shapes of the bodies in a chain.
pub fn sizes<S: Space, E: Shape<S>>(chain: &E) -> E::Store<PerAxes<S::Size>> {
    let mut sizes = chain.store::<PerAxes<S::Size>>(S::no_size());
    chain.outward(&mut Sizes, (), (&mut sizes,));
    sizes
}

/// Writes down the size of each body.
struct Sizes;

impl<S: Space> Walk<S> for Sizes {
    type Carried = ();
    type Stores = (Mut<PerAxes<S::Size>>,);
}

impl<S: Space> Outward<S> for Sizes {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, (): (), (size,): AtBody<'_, S, Self, B>) {
        *size = body.size();
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
}
