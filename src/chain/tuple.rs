//! Tuples of elements.

use super::{deeper, sum};
use crate::element::{
    Condense, Coordinates, Element, Gather, Given, Level, Posture, Reading, Space, Springs, Sweep, Visit,
};
use crate::error::Error;
use crate::relation::Closures;
use crate::tuples::for_each_tuple;

/// The first of a list.
macro_rules! first {
    ($first:expr, $($rest:expr,)*) => {
        $first
    };
}

/// Pairs are the links of arrays and vectors. What they hand on is large in space: by way of a call it would pass through memory.
macro_rules! chain_tuple {
    (X2; $($rest:tt)*) => {
        chain_of!([inline(always)] X2; $($rest)*);
    };
    ($met:ident; $($rest:tt)*) => {
        chain_of!([inline] $met; $($rest)*);
    };
}

macro_rules! chain_of {
    ([$($inline:tt)*] $met:ident; $($A:ident $i:tt $out:ident $in:ident),*; $($B:ident $j:tt),*) => {
        impl<S: Space, $($A: Element<S>),*> Element<S> for ($($A,)*) {
            type Position = ($($A::Position,)*);
            type Rate = ($($A::Rate,)*);
            type Kept<Cuts: Closures> = ($($A::Kept<Cuts>,)*);
            type PerBody<X: Copy> = ($($A::PerBody<X>,)*);
            type PerJoint<X: Copy> = ($($A::PerJoint<X>,)*);
            type PerAxes<X: Copy> = ($($A::PerAxes<X>,)*);

            const BODIES: Option<usize> = {
                let n = Some(0);
                $(let n = sum(n, $A::BODIES);)*
                n
            };
            const ABSOLUTE: bool = first!($($A::ABSOLUTE,)*);
            const JOINTS: Option<usize> = {
                let n = Some(0);
                $(let n = sum(n, $A::JOINTS);)*
                n
            };

            fn bodies(&self) -> usize {
                0 $(+ self.$i.bodies())*
            }
            fn joints(&self) -> usize {
                0 $(+ self.$i.joints())*
            }
            fn check(&self, station: usize) -> Result<(), Error> {
                $(
                    self.$i.check(station)?;
                    let station = station + self.$i.bodies() + self.$i.joints();
                )*
                let _ = station;
                Ok(())
            }
            fn fits(&self, position: &Self::Position, rate: &Self::Rate) -> bool {
                true $(&& self.$i.fits(&position.$i, &rate.$i))*
            }
            fn position(&self) -> Self::Position {
                ($(self.$i.position(),)*)
            }
            fn rate(&self) -> Self::Rate {
                ($(self.$i.rate(),)*)
            }
            fn kept<Cuts: Closures>(&self) -> Self::Kept<Cuts> {
                ($(self.$i.kept(),)*)
            }
            fn per_body<X: Copy>(&self, fill: X) -> Self::PerBody<X> {
                ($(self.$i.per_body(fill),)*)
            }
            fn per_joint<X: Copy>(&self, fill: X) -> Self::PerJoint<X> {
                ($(self.$i.per_joint(fill),)*)
            }
            fn per_axes<X: Copy>(&self, fill: X) -> Self::PerAxes<X> {
                ($(self.$i.per_axes(fill),)*)
            }
            fn body_entry<'a, X: Copy>(&self, bodies: &'a Self::PerBody<X>, k: usize) -> Option<&'a X> {
                $(
                    let n = self.$i.bodies();
                    if k < n {
                        return self.$i.body_entry(&bodies.$i, k);
                    }
                    let k = k - n;
                )*
                let _ = k;
                None
            }
            fn entry<'a, X: Copy>(
                &self,
                bodies: &'a Self::PerBody<X>,
                joints: &'a Self::PerJoint<X>,
                k: usize,
            ) -> Option<&'a X> {
                $(
                    let n = self.$i.bodies() + self.$i.joints();
                    if k < n {
                        return self.$i.entry(&bodies.$i, &joints.$i, k);
                    }
                    let k = k - n;
                )*
                let _ = k;
                None
            }
            fn aim(
                &self,
                position: &mut Self::Position,
                turn: S::Turn,
                next: &mut impl FnMut(S::Turn) -> S::Scalar,
            ) -> S::Turn {
                $(let turn = self.$i.aim(&mut position.$i, turn, next);)*
                turn
            }
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
                x: &mut Self::PerAxes<S::X>,
                y: &mut Self::PerAxes<S::Y>,
                p: &mut Self::PerAxes<S::P>,
                q: &mut Self::PerAxes<S::Q>,
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
            fn size(&self, sizes: &mut Self::PerAxes<S::Size>) {
                $(self.$i.size(&mut sizes.$i);)*
            }
            #[inline]
            fn resolve(
                sizes: &Self::PerAxes<S::Size>,
                x: &mut Self::PerAxes<S::X>,
                y: &mut Self::PerAxes<S::Y>,
                p: &mut Self::PerAxes<S::P>,
                q: &mut Self::PerAxes<S::Q>,
            ) {
                $($A::resolve(&sizes.$i, &mut x.$i, &mut y.$i, &mut p.$i, &mut q.$i);)*
            }
            #[$($inline)*]
            fn pose(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                turn: S::Turn,
                sizes: &Self::PerAxes<S::Size>,
                x: &mut Self::PerAxes<S::X>,
                y: &mut Self::PerAxes<S::Y>,
                p: &mut Self::PerAxes<S::P>,
                q: &mut Self::PerAxes<S::Q>,
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
            #[$($inline)*]
            fn recover<Cuts: Closures, By: Springs<S::Scalar>>(
                &self,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &mut Self::Kept<Cuts>,
                multipliers: &Cuts::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> S::Acceleration {
                $(let acceleration = self.$i.recover::<Cuts, By>(
                    acceleration,
                    Posture { x: &posture.x.$i, y: &posture.y.$i, p: &posture.p.$i, q: &posture.q.$i },
                    &mut kept.$i,
                    multipliers,
                    &mut rate.$i,
                );)*
                acceleration
            }
            #[inline]
            fn respond<Cuts: Closures>(
                &self,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &Self::Kept<Cuts>,
                multipliers: &Cuts::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> S::Acceleration {
                $(let acceleration = self.$i.respond(
                    acceleration,
                    Posture { x: &posture.x.$i, y: &posture.y.$i, p: &posture.p.$i, q: &posture.q.$i },
                    &kept.$i,
                    multipliers,
                    &mut rate.$i,
                );)*
                acceleration
            }
            const LOOPS: usize = {
                let deepest = 0;
                $(let deepest = deeper(deepest, $A::LOOPS);)*
                deepest
            };
            fn restore<Cuts: Closures>(
                &self,
                frame: S::Frame,
                motion: Coordinates<'_, S, Self>,
                level: Level,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &Self::Kept<Cuts>,
                multipliers: &Cuts::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> (S::Frame, S::Acceleration) {
                $(let (frame, acceleration) = self.$i.restore(
                    frame,
                    Coordinates {
                        position: &motion.position.$i,
                        rate: &motion.rate.$i,
                        acceleration: &motion.acceleration.$i,
                    },
                    level,
                    acceleration,
                    Posture { x: &posture.x.$i, y: &posture.y.$i, p: &posture.p.$i, q: &posture.q.$i },
                    &kept.$i,
                    multipliers,
                    &mut rate.$i,
                );)*
                (frame, acceleration)
            }
            fn independent<Cuts: Closures>(
                &self,
                frame: S::Frame,
                motion: Coordinates<'_, S, Self>,
                kept: &Self::Kept<Cuts>,
                station: usize,
        tell: &mut impl FnMut(usize, &'static str),
            ) -> Result<S::Frame, Error> {
                $(
                    let frame = self.$i.independent(
                        frame,
                        Coordinates {
                            position: &motion.position.$i,
                            rate: &motion.rate.$i,
                            acceleration: &motion.acceleration.$i,
                        },
                        &kept.$i,
                        station,
                        tell,
                    )?;
                    let station = station + self.$i.bodies() + self.$i.joints();
                )*
                let _ = station;
                Ok(frame)
            }
            #[inline]
            fn travel<V: Visit<S>>(
                &self,
                frame: S::Frame,
                motion: Coordinates<'_, S, Self>,
                visit: &mut V,
                on_bodies: &mut Self::PerBody<V::OnBody>,
                in_joints: &mut Self::PerJoint<V::InJoint>,
            ) -> S::Frame {
                $(let frame = self.$i.travel(
                    frame,
                    Coordinates {
                        position: &motion.position.$i,
                        rate: &motion.rate.$i,
                        acceleration: &motion.acceleration.$i,
                    },
                    visit,
                    &mut on_bodies.$i,
                    &mut in_joints.$i,
                );)*
                frame
            }
            fn inward<Found: Gather>(
                &self,
                bodies: &mut Self::PerBody<Found::Entry>,
                joints: &mut Self::PerJoint<Found::Entry>,
                outer: Found::Carried,
                gather: &mut Found,
            ) -> Found::Carried {
                $(let outer = self.$j.inward(&mut bodies.$j, &mut joints.$j, outer, gather);)*
                outer
            }
            fn broken<Cuts: Closures>(&self, kept: &Self::Kept<Cuts>, station: usize) -> Option<usize> {
                let outermost = None;
                $(
                    let outermost = self.$i.broken(&kept.$i, station).or(outermost);
                    let station = station + self.$i.bodies() + self.$i.joints();
                )*
                let _ = station;
                outermost
            }
        }

        condense_tuple!([$($inline)*] ($($A,)*) ($($B $j),*) (R) []; $($B)*);
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
    ([$($inline:tt)*] ($($A:ident,)*) ($($B:ident $j:tt),*) ($out:ty) [$($bounds:tt)*];) => {
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
                kept: &mut Self::Kept<W::Closures>,
            ) -> Self::Out {
                $(let outer = self.$j.condense(
                    outer,
                    Posture { x: &posture.x.$j, y: &posture.y.$j, p: &posture.p.$j, q: &posture.q.$j },
                    Given {
                        on_bodies: &given.on_bodies.$j,
                        in_joints: &given.in_joints.$j,
                        position: &given.position.$j,
                        rate: &given.rate.$j,
                        reading: Reading {
                            position: &given.reading.position.$j,
                            rate: &given.reading.rate.$j,
                            acceleration: &given.reading.acceleration.$j,
                        },
                        springs: given.springs,
                    },
                    &mut kept.$j,
                );)*
                outer
            }
        }
    };
}
for_each_tuple!(chain_tuple);
