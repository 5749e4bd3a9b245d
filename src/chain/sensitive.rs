//! Derivatives through the gains of tuples, arrays, vectors and arms.

use super::Branch;
use crate::element::{Element, Posture};
use crate::loading::EffortOf;
use crate::relation::{Join, WrenchOf};
use crate::sensitive::{At, RelationOf, Seeds, Sensitive, Varied};
use crate::shape::{PerBody, PerJoint};
use crate::tuples::for_each_tuple;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// Where an item is.
macro_rules! part {
    ($at:ident $($item:tt)*) => {
        At {
            plain: &$at.plain$($item)*,
            posture: Posture {
                x: &$at.posture.x$($item)*,
                y: &$at.posture.y$($item)*,
                p: &$at.posture.p$($item)*,
                q: &$at.posture.q$($item)*,
            },
            position: &$at.position$($item)*,
            rate: &$at.rate$($item)*,
        }
    };
}

/// Pairs are the links of arrays and vectors: what they carry need not pass through memory.
macro_rules! sensitive_tuple {
    (X2; $($rest:tt)*) => {
        sensitive_of!([inline(always)] X2; $($rest)*);
    };
    ($met:ident; $($rest:tt)*) => {
        sensitive_of!([inline] $met; $($rest)*);
    };
}

macro_rules! sensitive_of {
    ([$($inline:tt)*] $met:ident; $($A:ident $i:tt $out:ident $in:ident),*; $($B:ident $j:tt),*) => {
        impl<S: Varied, $($A: Sensitive<S>),*> Sensitive<S> for ($($A,)*) {
            type Plain = ($($A::Plain,)*);
            type Room = ($($A::Room,)*);

            fn room(&self) -> Self::Room {
                ($(self.$i.room(),)*)
            }
            #[$($inline)*]
            fn read(
                position: &Self::Position,
                rate: &Self::Rate,
                plain_position: &mut <Self::Plain as Element<S::Plain>>::Position,
                plain_rate: &mut <Self::Plain as Element<S::Plain>>::Rate,
            ) {
                $($A::read(&position.$i, &rate.$i, &mut plain_position.$i, &mut plain_rate.$i);)*
            }
            fn load(
                &self,
                on_bodies: &Self::Store<PerBody<WrenchOf<S>>>,
                in_joints: &Self::Store<PerJoint<EffortOf<S>>>,
                store: &mut Self::Room,
            ) {
                $(self.$i.load(&on_bodies.$i, &in_joints.$i, &mut store.$i);)*
            }
            #[$($inline)*]
            fn factor<Known: Seeds>(&self, at: At<'_, S, Self>, outer: RelationOf<S>, store: &mut Self::Room) -> RelationOf<S> {
                $(let outer = self.$j.factor::<Known>(part!(at .$j), outer, &mut store.$j);)*
                outer
            }
            #[$($inline)*]
            fn vary<Known: Seeds>(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Outward,
                store: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                $(self.$i.vary::<Known>(part!(at .$i), carried, &mut store.$i, &mut acceleration.$i);)*
            }
            #[$($inline)*]
            fn gather<Known: Seeds>(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Inward,
                store: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                $(self.$j.gather::<Known>(part!(at .$j), carried, &mut store.$j, &mut acceleration.$j);)*
            }
            #[$($inline)*]
            fn answer(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Response,
                store: &Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                $(self.$i.answer(part!(at .$i), carried, &store.$i, &mut acceleration.$i);)*
            }
        }
    };
}
for_each_tuple!(sensitive_tuple);

/// One implementation for arrays and vectors.
macro_rules! sensitive_items {
    ([$($K:tt)*] $Of:ty, $Plain:ty, $Room:ty, $store:expr) => {
        impl<S: Varied, A: Sensitive<S> $($K)*> Sensitive<S> for $Of {
            type Plain = $Plain;
            type Room = $Room;

            fn room(&self) -> Self::Room {
                $store(self)
            }
            #[inline]
            fn read(
                position: &Self::Position,
                rate: &Self::Rate,
                plain_position: &mut <Self::Plain as Element<S::Plain>>::Position,
                plain_rate: &mut <Self::Plain as Element<S::Plain>>::Rate,
            ) {
                let plain = plain_position.iter_mut().zip(plain_rate);
                position.iter().zip(rate).zip(plain).for_each(|((q, v), (p, r))| A::read(q, v, p, r));
            }
            fn load(
                &self,
                on_bodies: &Self::Store<PerBody<WrenchOf<S>>>,
                in_joints: &Self::Store<PerJoint<EffortOf<S>>>,
                store: &mut Self::Room,
            ) {
                let loads = on_bodies.iter().zip(in_joints);
                self.iter().zip(loads).zip(store).for_each(|((item, (b, j)), store)| item.load(b, j, store));
            }
            #[inline]
            fn factor<N: Seeds>(&self, at: At<'_, S, Self>, outer: RelationOf<S>, store: &mut Self::Room) -> RelationOf<S> {
                let mut outer = outer;
                for i in (0..self.len()).rev() {
                    outer = self[i].factor::<N>(part!(at [i]), outer, &mut store[i]);
                }
                outer
            }
            #[inline]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Outward,
                store: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                for i in 0..self.len() {
                    self[i].vary::<N>(part!(at [i]), carried, &mut store[i], &mut acceleration[i]);
                }
            }
            #[inline]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Inward,
                store: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                for i in (0..self.len()).rev() {
                    self[i].gather::<N>(part!(at [i]), carried, &mut store[i], &mut acceleration[i]);
                }
            }
            #[inline]
            fn answer(
                &self,
                at: At<'_, S, Self>,
                carried: &mut S::Response,
                store: &Self::Room,
                acceleration: &mut Self::Rate,
            ) {
                for i in 0..self.len() {
                    self[i].answer(part!(at [i]), carried, &store[i], &mut acceleration[i]);
                }
            }
        }
    };
}
sensitive_items!([, const K: usize] [A; K], [A::Plain; K], [A::Room; K], |items: &Self| items.each_ref().map(A::room));
#[cfg(feature = "alloc")]
sensitive_items!([] Vec<A>, Vec<A::Plain>, Vec<A::Room>, |items: &Self| items.iter().map(A::room).collect());

impl<S: Varied, A: Sensitive<S>> Sensitive<S> for Branch<A> {
    type Plain = Branch<A::Plain>;
    type Room = A::Room;

    fn room(&self) -> A::Room {
        self.0.room()
    }
    #[inline]
    fn read(
        position: &Self::Position,
        rate: &Self::Rate,
        plain_position: &mut <Self::Plain as Element<S::Plain>>::Position,
        plain_rate: &mut <Self::Plain as Element<S::Plain>>::Rate,
    ) {
        A::read(position, rate, plain_position, plain_rate);
    }
    fn load(
        &self,
        on_bodies: &Self::Store<PerBody<WrenchOf<S>>>,
        in_joints: &Self::Store<PerJoint<EffortOf<S>>>,
        store: &mut Self::Room,
    ) {
        self.0.load(on_bodies, in_joints, store);
    }
    #[inline]
    fn factor<N: Seeds>(&self, at: At<'_, S, Self>, outer: RelationOf<S>, store: &mut Self::Room) -> RelationOf<S> {
        outer.join(self.0.factor::<N>(arm(&at), RelationOf::<S>::massless(), store))
    }
    #[inline]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Outward,
        store: &mut Self::Room,
        acceleration: &mut Self::Rate,
    ) {
        self.0.vary::<N>(arm(&at), &mut { *carried }, store, acceleration);
    }
    #[inline]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Inward,
        store: &mut Self::Room,
        acceleration: &mut Self::Rate,
    ) {
        let mut pull = S::no_pull();
        self.0.gather::<N>(arm(&at), &mut pull, store, acceleration);
        S::pull(carried, &pull);
    }
    #[inline]
    fn answer(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Response,
        store: &Self::Room,
        acceleration: &mut Self::Rate,
    ) {
        self.0.answer(arm(&at), &mut { *carried }, store, acceleration);
    }
}

/// Where the arm of a branch is.
#[inline(always)]
fn arm<'a, S: Varied, A: Sensitive<S>>(at: &At<'a, S, Branch<A>>) -> At<'a, S, A> {
    let Posture { x, y, p, q } = at.posture;
    At { plain: &at.plain.0, posture: Posture { x, y, p, q }, position: at.position, rate: at.rate }
}
