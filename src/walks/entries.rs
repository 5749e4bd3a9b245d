//! Entries of all bodies and joints, one after the other.

use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Held, Joint, Outward, PerBody, PerJoint, Shape, Walk, alike,
};
use crate::space::Space;
use core::marker::PhantomData;

/// What a store holds for a body, or for a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry<X, Z> {
    /// For a body.
    Body(X),
    /// For a joint.
    Joint(Z),
}

/// Shows the entries of all bodies and joints of a chain, root to tip, in one walk.
pub fn entries<'a, 'b, S: Space, E: Shape<S>, X: Copy + 'static, Z: Copy + 'static>(
    chain: &E,
    bodies: &'a E::Store<PerBody<X>>,
    joints: &'b E::Store<PerJoint<Z>>,
    note: &mut impl FnMut(Entry<&'a X, &'b Z>),
) {
    chain.outward(&mut Entries { note, shown: PhantomData }, (), (bodies, joints));
}

/// Shows what it meets.
struct Entries<'n, N, X> {
    note: &'n mut N,
    shown: PhantomData<X>,
}

impl<'a, 'b, S, N, X, Z> Walk<S> for Entries<'_, N, Entry<&'a X, &'b Z>>
where
    S: Space,
    N: FnMut(Entry<&'a X, &'b Z>),
    X: Copy + 'static,
    Z: Copy + 'static,
{
    type Carried = ();
    type Stores = (Held<'a, PerBody<X>>, Held<'b, PerJoint<Z>>);
}

impl<'a, 'b, S, N, X, Z> Outward<S> for Entries<'_, N, Entry<&'a X, &'b Z>>
where
    S: Space,
    N: FnMut(Entry<&'a X, &'b Z>),
    X: Copy + 'static,
    Z: Copy + 'static,
{
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (body, _): AtBody<'_, S, Self, B>) {
        (self.note)(Entry::Body(body));
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (_, joint): AtJoint<'_, S, Self, J>) {
        (self.note)(Entry::Joint(joint));
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (_, joint): AtClosing<'_, S, Self, K>) {
        (self.note)(Entry::Joint(joint));
    }
}
