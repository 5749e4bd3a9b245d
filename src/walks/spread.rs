//! Values from a list, copied to the entries of bodies or of joints.

use crate::mirror::Rate;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerBody, PerJoint, Shape, Slices, Walk, alike,
    items_outward,
};
use crate::space::Space;

/// Copies values, one for each body, root to tip, to the entries of bodies.
#[inline(always)]
pub fn to_bodies<S: Space, E: Shape<S>, X: Copy + 'static>(chain: &E, values: &[X], bodies: &mut E::Store<PerBody<X>>) {
    chain.outward(&mut Bodies(exactly(values, E::BODIES)), (), (bodies,));
}

/// Copies values, one for each joint, root to tip, to the entries of joints.
#[cfg_attr(optimised, inline(always))]
pub fn to_joints<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    values: &[X],
    joints: &mut E::Store<PerJoint<X>>,
) {
    chain.outward(&mut Joints(exactly(values, E::JOINTS)), (), (joints,));
}

/// Copies values, one for each joint of one coordinate, root to tip, to the entries of those.
#[cfg_attr(optimised, inline(always))]
pub fn to_coordinates<S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    values: &[X],
    joints: &mut E::Store<PerJoint<X>>,
) {
    chain.outward(&mut Coordinates(values), (), (joints,));
}

/// A list with as many values as the type of a chain says: where it does, a compiler need not ask again.
#[inline(always)]
fn exactly<X>(values: &[X], count: Option<usize>) -> &[X] {
    count.map_or(values, |count| values.get(..count).unwrap_or(&[]))
}

/// Copies the first value, and goes on with the others.
#[cfg_attr(optimised, inline(always))]
fn take_first<X: Copy>(values: &mut &[X], entry: &mut X) {
    if let Some((first, others)) = values.split_first() {
        (*entry, *values) = (*first, others);
    }
}

/// Values that are left for bodies.
struct Bodies<'v, X>(&'v [X]);

/// Values that are left for joints.
struct Joints<'v, X>(&'v [X]);

/// Values that are left for joints of one coordinate.
struct Coordinates<'v, X>(&'v [X]);

/// Items in equal shares, whose loop vectorises, where each of them has as many.
macro_rules! in_shares {
    ($Walk:ident, $COUNT:ident) => {
        #[cfg_attr(optimised, inline(always))]
        fn items<A: Shape<S>>(&mut self, items: &[A], (): (), (entries,): Slices<'_, S, Self, A>) {
            match const { A::$COUNT } {
                Some(0) => (),
                Some(each) => {
                    let (own, others) = self.0.split_at_checked(each * items.len()).unwrap_or((self.0, &[]));
                    let items = items.iter().zip(entries);
                    items
                        .zip(own.chunks_exact(each))
                        .for_each(|((item, entry), share)| item.outward(&mut $Walk(share), (), (entry,)));
                    self.0 = others;
                }
                None => items_outward(self, items, (), (entries,)),
            }
        }
    };
}

impl<S: Space, X: Copy + 'static> Walk<S> for Bodies<'_, X> {
    type Carried = ();
    type Stores = (Mut<PerBody<X>>,);
}

impl<S: Space, X: Copy + 'static> Outward<S> for Bodies<'_, X> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), (body,): AtBody<'_, S, Self, B>) {
        take_first(&mut self.0, body);
    }
    #[inline(always)]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    in_shares!(Bodies, BODIES);
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
        take_first(&mut self.0, joint);
    }
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (joint,): AtClosing<'_, S, Self, K>) {
        take_first(&mut self.0, joint);
    }
    in_shares!(Joints, JOINTS);
}

impl<S: Space, X: Copy + 'static> Walk<S> for Coordinates<'_, X> {
    type Carried = ();
    type Stores = (Mut<PerJoint<X>>,);
}

impl<S: Space, X: Copy + 'static> Outward<S> for Coordinates<'_, X> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (joint,): AtJoint<'_, S, Self, J>) {
        if const { <J::Rate as Rate<S::Scalar>>::LENGTH == 1 } {
            take_first(&mut self.0, joint);
        }
    }
}
