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
    let mut places = list.iter_mut();
    let mut put = |value| {
        if let Some(place) = places.next() {
            *place = value;
        }
    };
    each_joint(chain, joints, rest, &mut put);
}

/// Tells the entries of joints, root to tip, and sets them to `rest`.
pub fn each_joint<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    joints: &mut E::Store<PerJoint<X>>,
    rest: X,
    report: &mut impl FnMut(X),
) {
    chain.outward(&mut Joints { report, rest }, (), (joints,));
}

/// Who is told.
struct Joints<'v, X, F> {
    report: &'v mut F,
    rest: X,
}

impl<X: Copy, F: FnMut(X)> Joints<'_, X, F> {
    #[inline(always)]
    fn put(&mut self, entry: &mut X) {
        (self.report)(core::mem::replace(entry, self.rest));
    }
}

impl<S: Space, X: Copy + 'static, F: FnMut(X)> Walk<S> for Joints<'_, X, F> {
    type Carried = ();
    type Stores = (Mut<PerJoint<X>>,);
}

impl<S: Space, X: Copy + 'static, F: FnMut(X)> Outward<S> for Joints<'_, X, F> {
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
