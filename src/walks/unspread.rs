//! Entries of joints, copied to a list: the way back of [`spread`](super::spread).

use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerJoint, Shape, Walk, alike};
use crate::space::Space;
use core::marker::PhantomData;

/// Moves the entries of joints, root to tip, to a list, and sets them to `rest`.
pub fn from_joints<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    joints: &mut E::Store<PerJoint<X>>,
    rest: X,
    list: &mut [X],
) {
    let mut places = list.iter_mut();
    let mut put = |entry: &mut X| {
        let value = core::mem::replace(entry, rest);
        if let Some(place) = places.next() {
            *place = value;
        }
    };
    each_joint(chain, joints, &mut put);
}

/// Shows the entries of joints, root to tip, which may be changed.
pub fn each_joint<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    joints: &mut E::Store<PerJoint<X>>,
    show: &mut impl FnMut(&mut X),
) {
    chain.outward(&mut Joints { show, of: PhantomData }, (), (joints,));
}

/// Who is shown.
struct Joints<'v, X, F> {
    show: &'v mut F,
    of: PhantomData<X>,
}

impl<S: Space, X: Copy + 'static, F: FnMut(&mut X)> Walk<S> for Joints<'_, X, F> {
    type Carried = ();
    type Stores = (Mut<PerJoint<X>>,);
}

impl<S: Space, X: Copy + 'static, F: FnMut(&mut X)> Outward<S> for Joints<'_, X, F> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (joint,): AtJoint<'_, S, Self, J>) {
        (self.show)(joint);
    }
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (joint,): AtClosing<'_, S, Self, K>) {
        (self.show)(joint);
    }
}
