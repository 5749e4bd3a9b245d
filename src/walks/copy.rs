//! The copy of a store: of gains, or of what acts in joints.

use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Field, Joint, Mut, Outward, Ref, Shape, Walk, Way};
use crate::space::Space;
use core::marker::PhantomData;

/// Copies a store of one shape, entry by entry: unlike a clone, or `clone_from` of nested vectors, it allocates nothing.
pub fn copy<S: Space, E: Shape<S>, Q: Field<S>>(chain: &E, from: &E::Store<Q>, to: &mut E::Store<Q>) {
    chain.outward(&mut Copied::<Q>(PhantomData), (), (from, to));
}

/// Copies what a store holds.
struct Copied<Q>(PhantomData<Q>);

impl<S: Space, Q: Field<S>> Walk<S> for Copied<Q> {
    type Carried = ();
    type Stores = (Ref<Q>, Mut<Q>);
}

impl<S: Space, Q: Field<S>> Outward<S> for Copied<Q> {
    type In<Y: Way> = Copied<Q::In<Y>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        go(&mut Copied(PhantomData))
    }
    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), (from, to): AtBody<'_, S, Self, B>) {
        to.clone_from(from);
    }
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (from, to): AtJoint<'_, S, Self, J>) {
        to.clone_from(from);
    }
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (from, to): AtClosing<'_, S, Self, K>) {
        to.clone_from(from);
    }
}
