//! Taylor series of tuples, arrays, vectors, arms and what has a name.

use super::{Branch, Named};
use crate::element::{Posture, RealOf, Space};
use crate::relation::{AccelerationOf, Wrench, WrenchOf};
use crate::series::{AtRest, Expand, Expandable, Instant, Order, Origin};
use crate::tuples::for_each_tuple;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// The posture of an item.
macro_rules! part {
    ($posture:ident $($item:tt)*) => {
        Posture {
            x: &$posture.x$($item)*,
            y: &$posture.y$($item)*,
            p: &$posture.p$($item)*,
            q: &$posture.q$($item)*,
        }
    };
}

/// Where the series of an item sets out.
macro_rules! origin {
    ($origin:ident $($item:tt)*) => {
        Origin {
            position: &$origin.position$($item)*,
            rate: &$origin.rate$($item)*,
            acceleration: &$origin.acceleration$($item)*,
        }
    };
}

/// Pairs are the links of arrays and vectors: what they carry need not pass through memory.
macro_rules! expand_tuple {
    (X2; $($rest:tt)*) => {
        expand_of!([inline(always)] X2; $($rest)*);
    };
    ($met:ident; $($rest:tt)*) => {
        expand_of!([inline] $met; $($rest)*);
    };
}

macro_rules! expand_of {
    ([$($inline:tt)*] $met:ident; $($A:ident $i:tt $out:ident $in:ident),*; $($B:ident $j:tt),*) => {
        impl<S: Expandable, $($A: Expand<S, M>,)* const M: usize> Expand<S, M> for ($($A,)*) {
            type Room = ($($A::Room,)*);

            fn room(&self) -> Self::Room {
                ($(self.$i.room(),)*)
            }
            #[$($inline)*]
            fn begin(
                &self,
                posture: Posture<'_, S, Self>,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: S::Turn,
                room: &mut Self::Room,
            ) -> S::Turn {
                $(let turn = self.$i.begin(part!(posture .$i), &position.$i, &rate.$i, turn, &mut room.$i);)*
                turn
            }
            #[$($inline)*]
            fn factor(&self, outer: S::Articulated, room: &mut Self::Room) -> S::Articulated {
                $(let outer = self.$j.factor(outer, &mut room.$j);)*
                outer
            }
            #[$($inline)*]
            fn push(&self, order: &Order<RealOf<S>>, outer: WrenchOf<S>, room: &mut Self::Room) -> WrenchOf<S> {
                $(let outer = self.$j.push(order, outer, &mut room.$j);)*
                outer
            }
            #[$($inline)*]
            fn swing(
                &self,
                order: &Order<RealOf<S>>,
                inboard: AccelerationOf<S>,
                room: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) -> AccelerationOf<S> {
                $(let inboard = self.$i.swing(order, inboard, &mut room.$i, &mut acceleration.$i);)*
                inboard
            }
            #[$($inline)*]
            fn sum(
                room: &Self::Room,
                at: Instant<'_, RealOf<S>>,
                origin: Origin<'_, S, Self>,
                position: &mut Self::Position,
                rate: &mut Self::Rate,
            ) {
                $($A::sum(&room.$i, at, origin!(origin .$i), &mut position.$i, &mut rate.$i);)*
            }
            #[$($inline)*]
            fn show(room: &Self::Room, each: &mut impl FnMut(&[S::Scalar])) {
                $($A::show(&room.$i, each);)*
            }
        }
    };
}
for_each_tuple!(expand_tuple);

/// One implementation for arrays and vectors.
macro_rules! expand_items {
    ([$($K:tt)*] $Of:ty, $Room:ty, $rooms:expr) => {
        impl<S: Expandable, A: Expand<S, M>, const M: usize $($K)*> Expand<S, M> for $Of {
            type Room = $Room;

            fn room(&self) -> Self::Room {
                $rooms(self)
            }
            #[inline]
            fn begin(
                &self,
                posture: Posture<'_, S, Self>,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: S::Turn,
                room: &mut Self::Room,
            ) -> S::Turn {
                let mut turn = turn;
                for i in 0..self.len() {
                    turn = self[i].begin(part!(posture [i]), &position[i], &rate[i], turn, &mut room[i]);
                }
                turn
            }
            #[inline]
            fn factor(&self, outer: S::Articulated, room: &mut Self::Room) -> S::Articulated {
                let items = self.iter().zip(room).rev();
                items.fold(outer, |outer, (item, room)| item.factor(outer, room))
            }
            #[inline]
            fn push(&self, order: &Order<RealOf<S>>, outer: WrenchOf<S>, room: &mut Self::Room) -> WrenchOf<S> {
                let items = self.iter().zip(room).rev();
                items.fold(outer, |outer, (item, room)| item.push(order, outer, room))
            }
            #[inline]
            fn swing(
                &self,
                order: &Order<RealOf<S>>,
                inboard: AccelerationOf<S>,
                room: &mut Self::Room,
                acceleration: &mut Self::Rate,
            ) -> AccelerationOf<S> {
                let items = self.iter().zip(room).zip(acceleration);
                items.fold(inboard, |inboard, ((item, room), rate)| item.swing(order, inboard, room, rate))
            }
            #[inline]
            fn sum(
                room: &Self::Room,
                at: Instant<'_, RealOf<S>>,
                origin: Origin<'_, S, Self>,
                position: &mut Self::Position,
                rate: &mut Self::Rate,
            ) {
                for (i, ((room, position), rate)) in room.iter().zip(position).zip(rate).enumerate() {
                    A::sum(room, at, origin!(origin [i]), position, rate);
                }
            }
            #[inline]
            fn show(room: &Self::Room, each: &mut impl FnMut(&[S::Scalar])) {
                room.iter().for_each(|room| A::show(room, each));
            }
        }
    };
}
expand_items!([, const K: usize] [A; K], [A::Room; K], |items: &Self| items.each_ref().map(A::room));
#[cfg(feature = "alloc")]
expand_items!([] Vec<A>, Vec<A::Room>, |items: &Self| items.iter().map(A::room).collect());

impl<S: Expandable, A: Expand<S, N>, const N: usize> Expand<S, N> for Branch<A> {
    type Room = A::Room;

    fn room(&self) -> A::Room {
        self.0.room()
    }
    #[inline(always)]
    fn begin(
        &self,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        room: &mut Self::Room,
    ) -> S::Turn {
        self.0.begin(Posture { x, y, p, q }, position, rate, turn, room);
        turn
    }
    #[inline(always)]
    fn factor(&self, outer: S::Articulated, room: &mut Self::Room) -> S::Articulated {
        S::join(outer, self.0.factor(S::nothing(), room))
    }
    #[inline(always)]
    fn push(&self, order: &Order<RealOf<S>>, outer: WrenchOf<S>, room: &mut Self::Room) -> WrenchOf<S> {
        outer + self.0.push(order, Wrench::none(), room)
    }
    #[inline(always)]
    fn swing(
        &self,
        order: &Order<RealOf<S>>,
        inboard: AccelerationOf<S>,
        room: &mut Self::Room,
        acceleration: &mut Self::Rate,
    ) -> AccelerationOf<S> {
        self.0.swing(order, inboard, room, acceleration);
        inboard
    }
    #[inline(always)]
    fn sum(
        room: &Self::Room,
        at: Instant<'_, RealOf<S>>,
        Origin { position: from, rate: v, acceleration }: Origin<'_, S, Self>,
        position: &mut Self::Position,
        rate: &mut Self::Rate,
    ) {
        A::sum(room, at, Origin { position: from, rate: v, acceleration }, position, rate);
    }
    #[inline(always)]
    fn show(room: &Self::Room, each: &mut impl FnMut(&[S::Scalar])) {
        A::show(room, each);
    }
}

impl<S: Space, R: AtRest<S>> AtRest<S> for Named<R> {}

impl<S: Expandable, E: Expand<S, N>, const N: usize> Expand<S, N> for Named<E> {
    type Room = E::Room;

    fn room(&self) -> E::Room {
        self.item.room()
    }
    #[inline(always)]
    fn begin(
        &self,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        room: &mut Self::Room,
    ) -> S::Turn {
        self.item.begin(Posture { x, y, p, q }, position, rate, turn, room)
    }
    #[inline(always)]
    fn factor(&self, outer: S::Articulated, room: &mut Self::Room) -> S::Articulated {
        self.item.factor(outer, room)
    }
    #[inline(always)]
    fn push(&self, order: &Order<RealOf<S>>, outer: WrenchOf<S>, room: &mut Self::Room) -> WrenchOf<S> {
        self.item.push(order, outer, room)
    }
    #[inline(always)]
    fn swing(
        &self,
        order: &Order<RealOf<S>>,
        inboard: AccelerationOf<S>,
        room: &mut Self::Room,
        acceleration: &mut Self::Rate,
    ) -> AccelerationOf<S> {
        self.item.swing(order, inboard, room, acceleration)
    }
    #[inline(always)]
    fn sum(
        room: &Self::Room,
        at: Instant<'_, RealOf<S>>,
        Origin { position: from, rate: v, acceleration }: Origin<'_, S, Self>,
        position: &mut Self::Position,
        rate: &mut Self::Rate,
    ) {
        E::sum(room, at, Origin { position: from, rate: v, acceleration }, position, rate);
    }
    #[inline(always)]
    fn show(room: &Self::Room, each: &mut impl FnMut(&[S::Scalar])) {
        E::show(room, each);
    }
}
