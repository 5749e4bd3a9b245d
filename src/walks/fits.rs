//! Whether coordinates, and what joints keep, have the shape of a chain.

use crate::relation::Closures;
use crate::shape::{
    AtBody, AtJoint, Body, Joint, Kept, Outward, Positions, Rates, Ref, Shape, Slices, Slot, Walk, Way, items_outward,
};
use crate::space::Space;
use core::marker::PhantomData;

/// Whether coordinates and rates have the shape of a chain: only vectors can differ, in length.
#[inline]
pub fn fits<S: Space, E: Shape<S>>(chain: &E, position: &E::Store<Positions>, rate: &E::Store<Rates>) -> bool {
    // A constant, so that a compiler does not even look at what follows where there is no vector.
    if const { E::BODIES.is_some() && E::JOINTS.is_some() } {
        return true;
    }
    let mut fits = Fits::<(Ref<Positions>, Ref<Rates>)>(true, PhantomData);
    chain.outward(&mut fits, (), (position, rate));
    fits.0
}

/// Whether gains have the shape of a chain, as [`fits`].
pub fn gains_fit<S: Space, E: Shape<S>, C: Closures>(chain: &E, gains: &E::Store<Kept<C>>) -> bool {
    if const { E::BODIES.is_some() && E::JOINTS.is_some() } {
        return true;
    }
    let mut fits = Fits::<Ref<Kept<C>>>(true, PhantomData);
    chain.outward(&mut fits, (), gains);
    fits.0
}

/// Whether all stores met so far have the shape of the chain.
struct Fits<Q>(bool, PhantomData<Q>);

impl<S: Space, Q: Slot<S>> Walk<S> for Fits<Q> {
    type Carried = ();
    type Stores = Q;
}

impl<S: Space, Q: Slot<S>> Outward<S> for Fits<Q> {
    type In<Y: Way> = Fits<Q::In<Y>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        let mut arm = Fits(self.0, PhantomData);
        let out = go(&mut arm);
        self.0 = arm.0;
        out
    }

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    #[inline]
    fn items<A: Shape<S>>(&mut self, items: &[A], (): (), slices: Slices<'_, S, Self, A>) {
        self.0 &= Q::fit::<A>(&slices, items.len());
        items_outward(self, items, (), slices);
    }
}
