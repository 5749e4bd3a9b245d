//! Values from a list, as entries of bodies or of joints.

use crate::loading::Loading;
use crate::mirror::Rate;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerBody, PerJoint, Shape, Slices, Walk, alike,
    items_outward,
};
use crate::space::Space;

/// Whether loads are lists that no motion has to be shown to: bodies that take them in their own axes are told their attitudes.
pub const fn is_listed<S: Space, E: Shape<S>, L: Loading<S>>() -> bool {
    !(L::READS || E::OWN_AXES && size_of::<L::OnBody>() > 0)
}

/// Writes what is made of the lists of loads to the entries of bodies and of joints.
#[inline(always)]
pub fn loads<S: Space, E: Shape<S>, L: Loading<S>, X: Copy + 'static, Z: Copy + 'static>(
    chain: &E,
    loads: &L,
    (on_body, in_joint): (impl Fn(L::OnBody) -> X, impl Fn(L::InJoint) -> Z),
    on_bodies: &mut E::Store<PerBody<X>>,
    in_joints: &mut E::Store<PerJoint<Z>>,
) {
    let (forces, torques) = loads.listed();
    to_bodies(chain, forces, on_body, on_bodies);
    if const { L::BY_COORDINATE } {
        to_coordinates(chain, torques, in_joint, in_joints);
    } else {
        to_joints(chain, torques, in_joint, in_joints);
    }
}

/// Writes what `of` makes of values, one for each body, root to tip, to the entries of bodies.
#[inline(always)]
fn to_bodies<S: Space, E: Shape<S>, X: Copy, Z: Copy + 'static>(
    chain: &E,
    values: &[X],
    of: impl Fn(X) -> Z,
    bodies: &mut E::Store<PerBody<Z>>,
) {
    chain.outward(&mut Bodies { values: exactly(values, E::BODIES), of: &of }, (), (bodies,));
}

/// Writes what `of` makes of values, one for each joint, root to tip, to the entries of joints.
#[cfg_attr(optimised, inline(always))]
pub fn to_joints<S: Space, E: Shape<S>, X: Copy, Z: Copy + 'static>(
    chain: &E,
    values: &[X],
    of: impl Fn(X) -> Z,
    joints: &mut E::Store<PerJoint<Z>>,
) {
    chain.outward(&mut Joints { values: exactly(values, E::JOINTS), of: &of }, (), (joints,));
}

/// Writes what `of` makes of values, one for each joint of one coordinate, root to tip, to the entries of those.
#[cfg_attr(optimised, inline(always))]
pub fn to_coordinates<S: Space, E: Shape<S>, X: Copy, Z: Copy + 'static>(
    chain: &E,
    values: &[X],
    of: impl Fn(X) -> Z,
    joints: &mut E::Store<PerJoint<Z>>,
) {
    chain.outward(&mut Coordinates { values, of: &of }, (), (joints,));
}

/// A list with as many values as the type of a chain says: where it does, a compiler need not ask again.
#[inline(always)]
fn exactly<X>(values: &[X], count: Option<usize>) -> &[X] {
    count.map_or(values, |count| values.get(..count).unwrap_or(&[]))
}

/// Writes what is made of the first value, and goes on with the others.
#[cfg_attr(optimised, inline(always))]
fn take_first<X: Copy, Z>(values: &mut &[X], of: impl Fn(X) -> Z, entry: &mut Z) {
    if let Some((first, others)) = values.split_first() {
        (*entry, *values) = (of(*first), others);
    }
}

/// Values that are left for bodies, and what is made of each.
struct Bodies<'v, X, F> {
    values: &'v [X],
    of: &'v F,
}

/// Values that are left for joints, and what is made of each.
struct Joints<'v, X, F> {
    values: &'v [X],
    of: &'v F,
}

/// Values that are left for joints of one coordinate, and what is made of each.
struct Coordinates<'v, X, F> {
    values: &'v [X],
    of: &'v F,
}

/// Items in equal shares, whose loop vectorises, where each of them has as many.
macro_rules! in_shares {
    ($Walk:ident, $COUNT:ident) => {
        #[cfg_attr(optimised, inline(always))]
        fn items<A: Shape<S>>(&mut self, items: &[A], (): (), (entries,): Slices<'_, S, Self, A>) {
            match const { A::$COUNT } {
                Some(0) => (),
                Some(each) => {
                    let (values, of) = (self.values, self.of);
                    let (own, others) = values.split_at_checked(each * items.len()).unwrap_or((values, &[]));
                    let items = items.iter().zip(entries);
                    items.zip(own.chunks_exact(each)).for_each(|((item, entry), share)| {
                        item.outward(&mut $Walk { values: share, of }, (), (entry,))
                    });
                    self.values = others;
                }
                None => items_outward(self, items, (), (entries,)),
            }
        }
    };
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Walk<S> for Bodies<'_, X, F> {
    type Carried = ();
    type Stores = (Mut<PerBody<Z>>,);
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Outward<S> for Bodies<'_, X, F> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), (body,): AtBody<'_, S, Self, B>) {
        take_first(&mut self.values, self.of, body);
    }
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    in_shares!(Bodies, BODIES);
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Walk<S> for Joints<'_, X, F> {
    type Carried = ();
    type Stores = (Mut<PerJoint<Z>>,);
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Outward<S> for Joints<'_, X, F> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (joint,): AtJoint<'_, S, Self, J>) {
        take_first(&mut self.values, self.of, joint);
    }
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (joint,): AtClosing<'_, S, Self, K>) {
        take_first(&mut self.values, self.of, joint);
    }
    in_shares!(Joints, JOINTS);
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Walk<S> for Coordinates<'_, X, F> {
    type Carried = ();
    type Stores = (Mut<PerJoint<Z>>,);
}

impl<S: Space, X: Copy, Z: Copy + 'static, F: Fn(X) -> Z> Outward<S> for Coordinates<'_, X, F> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (joint,): AtJoint<'_, S, Self, J>) {
        if const { <J::Rate as Rate<S::Scalar>>::LENGTH == 1 } {
            take_first(&mut self.values, self.of, joint);
        }
    }
}
