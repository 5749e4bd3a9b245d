//! Tuples of elements.

use super::{deeper, sum};
use crate::element::{Condense, Element, Given, Posture, Reading, Space, Sweep};
use crate::shape::{Field, Inward, Kept, Member, Nth, Of, Outward, PerAxes, Shape, Slot};
use crate::tuples::for_each_tuple;

/// Where the items of a tuple are: a macro cannot repeat all items for each item, so they are passed on as one list.
macro_rules! members {
    ($all:tt $($A:ident $i:tt)*) => {
        $(member!($all $A $i);)*
    };
}
macro_rules! member {
    ([$($All:ident)*] $A:ident $i:tt) => {
        impl<S: Space, $($All: Shape<S>),*> Member<S, ($($All,)*)> for Nth<$i> {
            type Item = $A;

            #[inline(always)]
            fn get<Stored: Field<S>>(store: &($($All::Store<Stored>,)*)) -> &$A::Store<Stored> {
                &store.$i
            }
            #[inline(always)]
            fn get_mut<Stored: Field<S>>(store: &mut ($($All::Store<Stored>,)*)) -> &mut $A::Store<Stored> {
                &mut store.$i
            }
        }
    };
}

/// Pairs are the links of arrays and vectors. What they hand on is large in space: by way of a call it would pass through memory. Walks
/// outward through more than three items are inlined, too: a tuple that is met several times would be called, and be handed all of a frame
/// where a law reads a rate. (Links of three items, of trees, are better left to the compiler: 1 % of a sweep.) In the plane little is handed on:
/// long tuples are left to the compiler there, which then takes two thirds of the time.
macro_rules! chain_tuple {
    (X1; $($rest:tt)*) => {
        chain_of!([inline] [inline] X1; $($rest)*);
    };
    (X2; $($rest:tt)*) => {
        chain_of!([inline(always)] [inline(always)] X2; $($rest)*);
    };
    (X3; $($rest:tt)*) => {
        chain_of!([inline] [inline] X3; $($rest)*);
    };
    (X13; $($rest:tt)*) => {
        chain_of!([inline] [long] X13; $($rest)*);
    };
    (X14; $($rest:tt)*) => {
        chain_of!([inline] [long] X14; $($rest)*);
    };
    (X15; $($rest:tt)*) => {
        chain_of!([inline] [long] X15; $($rest)*);
    };
    (X16; $($rest:tt)*) => {
        chain_of!([inline] [long] X16; $($rest)*);
    };
    ($met:ident; $($rest:tt)*) => {
        chain_of!([inline] [inline(always)] $met; $($rest)*);
    };
}

/// A walk outward through the items of a tuple.
macro_rules! outward_tuple {
    ([long] $($i:tt)*) => {
        #[inline(always)]
        fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, mut stores: Of<'_, S, W, Self>) -> W::Carried {
            if const { S::TURNS_ABOUT_LINES } {
                outward_tuple!(self walk carried stores $($i)*)
            } else {
                called(move || outward_tuple!(self walk carried stores $($i)*))
            }
        }
    };
    ([$($inline:tt)*] $($i:tt)*) => {
        #[$($inline)*]
        fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, mut stores: Of<'_, S, W, Self>) -> W::Carried {
            outward_tuple!(self walk carried stores $($i)*)
        }
    };
    ($chain:ident $walk:ident $carried:ident $stores:ident $($i:tt)*) => {{
        $(let $carried = $chain.$i.outward($walk, $carried, W::Stores::member::<Self, _>(&mut $stores, Nth::<$i>));)*
        $carried
    }};
}

/// Goes on in a function of its own, unless the compiler finds it better otherwise.
fn called<X>(go: impl FnOnce() -> X) -> X {
    go()
}

macro_rules! chain_of {
    ([$($inline:tt)*] [$($outward:tt)*] $met:ident; $($A:ident $i:tt $out:ident $in:ident),*; $($B:ident $j:tt),*) => {
        impl<S: Space, $($A: Shape<S>),*> Shape<S> for ($($A,)*) {
            type Store<Stored: Field<S>> = ($($A::Store<Stored>,)*);

            const BODIES: Option<usize> = {
                let n = Some(0);
                $(let n = sum(n, $A::BODIES);)*
                n
            };
            const JOINTS: Option<usize> = {
                let n = Some(0);
                $(let n = sum(n, $A::JOINTS);)*
                n
            };
            const LOOPS: usize = {
                let deepest = 0;
                $(let deepest = deeper(deepest, $A::LOOPS);)*
                deepest
            };
            const SHARES: bool = false $(|| $A::SHARES)*;
            const LINEAR: bool = true $(&& $A::LINEAR)*;
            const ROTARY: bool = false $(|| $A::ROTARY)*;
            const OWN_AXES: bool = false $(|| $A::OWN_AXES)*;
            const SINES: usize = 0_usize $(.saturating_add($A::SINES))*;
            const FLANGED: bool = false $(|| $A::FLANGED)*;

            fn store<Stored: Field<S>>(&self, fill: Stored::Fill) -> Self::Store<Stored> {
                ($(self.$i.store::<Stored>(fill),)*)
            }
            outward_tuple!([$($outward)*] $($i)*);
            #[$($inline)*]
            fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
                let mut stores = stores;
                $(let carried = self.$j.inward(walk, carried, W::Stores::member::<Self, _>(&mut stores, Nth::<$j>));)*
                carried
            }
        }
        members!([$($A)*] $($A $i)*);

        impl<S: Space, $($A: Element<S>),*> Element<S> for ($($A,)*) {
            type Position = ($($A::Position,)*);
            type Rate = ($($A::Rate,)*);

            // Of what follows an item that turns anew, nothing depends on what lies inboard of the tuple; axes of bodies are passed in order.
            const ABSOLUTE: bool = {
                let (absolute, anew) = (true, false);
                $(let (absolute, anew) = (absolute && (anew || $A::ABSOLUTE), anew || $A::TURNS_ANEW);)*
                let _ = anew;
                absolute && !<Self as Shape<S>>::FLANGED
            };
            const TURNS_ANEW: bool = false $(|| $A::TURNS_ANEW)*;
            const POSED_LATE: bool = false $(|| $A::POSED_LATE)*;

            fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
                $(let mass = self.$j.lump(mass);)*
                mass
            }
            #[inline]
            fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
                $(let turn = self.$i.turned(&position.$i, &rate.$i, turn);)*
                turn
            }
            #[$($inline)*]
            fn orient(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: S::Turn,
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
            ) -> S::Turn {
                $(let turn = self.$i.orient(
                    &position.$i,
                    &rate.$i,
                    turn,
                    &mut x.$i,
                    &mut y.$i,
                    &mut p.$i,
                    &mut q.$i,
                );)*
                turn
            }
            #[inline]
            fn resolve(
                sizes: &Self::Store<PerAxes<S::Size>>,
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
            ) {
                $($A::resolve(&sizes.$i, &mut x.$i, &mut y.$i, &mut p.$i, &mut q.$i);)*
            }
            #[$($inline)*]
            fn pose(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: S::Turn,
                sizes: &Self::Store<PerAxes<S::Size>>,
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
            ) -> S::Turn {
                $(let turn = self.$i.pose(
                    &position.$i,
                    &rate.$i,
                    turn,
                    &sizes.$i,
                    &mut x.$i,
                    &mut y.$i,
                    &mut p.$i,
                    &mut q.$i,
                );)*
                turn
            }
        }

        condense_tuple!([$($inline)*] ($($A $i,)*) ($($B $j),*) (R) []; $($B)*);
    };
}

/// What acts in an item.
macro_rules! given_of {
    ($given:ident, $j:tt) => {
        Given {
            on_bodies: &$given.on_bodies.$j,
            in_joints: &$given.in_joints.$j,
            position: &$given.position.$j,
            rate: &$given.rate.$j,
            reading: Reading {
                position: &$given.reading.position.$j,
                rate: &$given.reading.rate.$j,
                acceleration: &$given.reading.acceleration.$j,
            },
            springs: $given.springs,
        }
    };
}

/// The condensation of a tuple, item by item from last to first: `$met` is what the next one meets, spelt out by what comes before.
/// (As type parameters of the impl these relations would be unknowns of whoever asks for it. Compilers remember no answers about unknowns, so
/// each tuple would be asked twice by the one around it: a ladder of twelve loops would take minutes.)
macro_rules! condense_tuple {
    ($inline:tt $all:tt $back:tt ($met:ty) [$($bounds:tt)*]; $B:ident $($rest:ident)*) => {
        condense_tuple!(
            $inline $all $back (<$B as Condense<S, $met, W>>::Out) [$($bounds)* $B: Condense<S, $met, W>,]; $($rest)*
        );
    };
    ([$($inline:tt)*] ($($A:ident $i:tt,)*) ($($B:ident $j:tt),*) ($out:ty) [$($bounds:tt)*];) => {
        impl<S: Space, R, W: Sweep<S>, $($A),*> Condense<S, R, W> for ($($A,)*)
        where
            $($bounds)*
        {
            type Out = $out;

            #[$($inline)*]
            fn condense(
                &self,
                outer: R,
                posture: Posture<'_, S, Self>,
                given: Given<'_, S, Self, W>,
                kept: &mut Self::Store<Kept<W::Closures>>,
            ) -> Self::Out {
                $(let outer = self.$j.condense(
                    outer,
                    Posture { x: &posture.x.$j, y: &posture.y.$j, p: &posture.p.$j, q: &posture.q.$j },
                    given_of!(given, $j),
                    &mut kept.$j,
                );)*
                outer
            }
            #[$($inline)*]
            fn pose_and_condense(
                &self,
                outer: R,
                turn: S::Turn,
                sizes: &Self::Store<PerAxes<S::Size>>,
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
                given: Given<'_, S, Self, W>,
                kept: &mut Self::Store<Kept<W::Closures>>,
            ) -> Self::Out {
                // What turns inboard of each item, outward, and then the items inward.
                let mut turns = [turn; [$($i),*].len()];
                $(
                    turns[$i] = turn;
                    let turn = self.$i.turned(&given.position.$i, &given.rate.$i, turn);
                )*
                let _ = turn;
                $(let outer = self.$j.pose_and_condense(
                    outer,
                    turns[$j],
                    &sizes.$j,
                    &mut x.$j,
                    &mut y.$j,
                    &mut p.$j,
                    &mut q.$j,
                    given_of!(given, $j),
                    &mut kept.$j,
                );)*
                outer
            }
        }
    };
}

for_each_tuple!(chain_tuple);
