//! Whether coordinates have the shape of a chain.

use crate::shape::{
    AtBody, AtJoint, Body, Joint, Outward, Positions, Rates, Ref, Shape, Slices, Slot, Walk, alike, items_outward,
};
use crate::space::Space;

/// Whether coordinates and rates have the shape of a chain: only vectors can differ, in length.
#[inline]
pub fn fits<S: Space, E: Shape<S>>(chain: &E, position: &E::Store<Positions>, rate: &E::Store<Rates>) -> bool {
    // A constant, so that a compiler does not even look at what follows where there is no vector.
    if const { E::BODIES.is_some() && E::JOINTS.is_some() } {
        return true;
    }
    let mut fits = Fits(true);
    chain.outward(&mut fits, (), (position, rate));
    fits.0
}

/// Whether all coordinates and rates met so far have the shape of the chain.
struct Fits(bool);

impl<S: Space> Walk<S> for Fits {
    type Carried = ();
    type Stores = (Ref<Positions>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Fits {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    #[inline]
    fn items<A: Shape<S>>(&mut self, items: &[A], (): (), slices: Slices<'_, S, Self, A>) {
        self.0 &= <Self as Walk<S>>::Stores::fit::<A>(&slices, items.len());
        items_outward(self, items, (), slices);
    }
}
