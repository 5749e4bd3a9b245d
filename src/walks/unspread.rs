//! Entries of joints, copied to a list: the way back of [`spread`](super::spread).

use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerJoint, Shape, Walk, alike};
use crate::space::Space;

/// Moves the entries of joints, root to tip, to a list, and sets them to `rest`.
pub fn from_joints<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    joints: &mut E::Store<PerJoint<X>>,
    rest: X,
    list: &mut [X],
) {
    chain.outward(&mut Joints { list, rest }, (), (joints,));
}

/// Places that are left.
struct Joints<'v, X> {
    list: &'v mut [X],
    rest: X,
}

impl<X: Copy> Joints<'_, X> {
    #[inline(always)]
    fn put(&mut self, entry: &mut X) {
        let value = core::mem::replace(entry, self.rest);
        if let Some((first, others)) = core::mem::take(&mut self.list).split_first_mut() {
            *first = value;
            self.list = others;
        }
    }
}

impl<S: Space, X: Copy + 'static> Walk<S> for Joints<'_, X> {
    type Carried = ();
    type Stores = (Mut<PerJoint<X>>,);
}

impl<S: Space, X: Copy + 'static> Outward<S> for Joints<'_, X> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (joint,): AtJoint<'_, S, Self, J>) {
        self.put(joint);
    }
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (joint,): AtClosing<'_, S, Self, K>) {
        self.put(joint);
    }
}
