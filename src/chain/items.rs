//! Arrays and vectors of elements.

use super::poses::{march, orient_items, pose_items, pose_items_in_order, resolve_items, turned_by_items};
#[cfg(feature = "alloc")]
use super::poses::{pose_slices, pose_slices_in_order};
use super::{product, sum};
use crate::element::{
    Condense, Coordinates, Element, Entry, Gather, Given, Level, Posture, Reading, Space, Springs, Sweep, Visit,
};
use crate::error::Error;
use crate::relation::{Closures, Meet};

/// An array, spelled like a vector.
type Array<X, const K: usize> = [X; K];

/// The items of an array, mapped.
fn map_array<A, B, const K: usize>(items: &[A; K], make: impl FnMut(&A) -> B) -> [B; K] {
    items.each_ref().map(make)
}

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// The items of a vector, mapped.
#[cfg(feature = "alloc")]
fn map_vec<A, B>(items: &[A], make: impl FnMut(&A) -> B) -> Vec<B> {
    items.iter().map(make).collect()
}

/// The item in which the k-th of something lies, and its number there: by division where each item has as many, by counting
/// elsewhere.
fn locate<A>(items: &[A], each: Option<usize>, count: impl Fn(&A) -> usize, k: usize) -> Option<(usize, usize)> {
    if let Some(each) = each {
        return Some((k.checked_div(each)?, k % each));
    }
    let mut k = k;
    for (i, item) in items.iter().enumerate() {
        let n = count(item);
        if k < n {
            return Some((i, k));
        }
        k -= n;
    }
    None
}

/// The coordinates of an item.
macro_rules! item_motion {
    ($motion:ident, $i:ident) => {
        Coordinates {
            position: &$motion.position[$i],
            rate: &$motion.rate[$i],
            acceleration: &$motion.acceleration[$i],
        }
    };
}

/// Spreads values over items: in equal shares, whose loop vectorises, where each item has as many.
macro_rules! spread {
    ($items:ident, $each:expr, $spread:ident: $values:ident, $entries:ident) => {{
        let items = $items.iter().zip(&mut $entries[..]);
        match const { $each } {
            Some(0) => $values,
            Some(each) => {
                let (own, others) = $values.split_at_checked(each * $items.len()).unwrap_or(($values, &[]));
                items.zip(own.chunks_exact(each)).for_each(|((item, entry), share)| _ = item.$spread(share, entry));
                others
            }
            None => items.fold($values, |values, (item, entry)| item.$spread(values, entry)),
        }
    }};
}

/// One implementation for arrays and vectors, `$Of<item $extra>`.
macro_rules! chain_items {
    ($Of:ident, $map:ident, $pose:ident $pose_in_order:ident, [$($K:tt)*], [$($extra:tt)*], |$A:ident| $length:expr) => {
        impl<S: Space, A: Element<S> $($K)*> Element<S> for $Of<A $($extra)*> {
            type Position = $Of<A::Position $($extra)*>;
            type Rate = $Of<A::Rate $($extra)*>;
            type Kept<C: Closures> = $Of<A::Kept<C> $($extra)*>;
            type PerBody<X: Copy> = $Of<A::PerBody<X> $($extra)*>;
            type PerJoint<X: Copy> = $Of<A::PerJoint<X> $($extra)*>;
            type PerAxes<X: Copy> = $Of<A::PerAxes<X> $($extra)*>;

            const BODIES: Option<usize> = {
                let $A = A::BODIES;
                $length
            };
            const ABSOLUTE: bool = A::ABSOLUTE;
            const JOINTS: Option<usize> = {
                let $A = A::JOINTS;
                $length
            };

            fn bodies(&self) -> usize {
                A::BODIES.map_or_else(|| self.iter().map(Element::bodies).sum(), |each| each * self.len())
            }
            fn joints(&self) -> usize {
                A::JOINTS.map_or_else(|| self.iter().map(Element::joints).sum(), |each| each * self.len())
            }
            fn check(&self, station: usize) -> Result<(), Error> {
                let mut station = station;
                for item in self {
                    item.check(station)?;
                    station += item.bodies() + item.joints();
                }
                Ok(())
            }
            fn fits(&self, position: &Self::Position, rate: &Self::Rate) -> bool {
                self.len() == position.len()
                    && self.len() == rate.len()
                    && self.iter().zip(position).zip(rate).all(|((item, position), rate)| item.fits(position, rate))
            }
            fn position(&self) -> Self::Position {
                $map(self, Element::position)
            }
            fn rate(&self) -> Self::Rate {
                $map(self, Element::rate)
            }
            fn kept<C: Closures>(&self) -> Self::Kept<C> {
                $map(self, Element::kept)
            }
            fn per_body<X: Copy>(&self, fill: X) -> Self::PerBody<X> {
                $map(self, |item| item.per_body(fill))
            }
            fn per_joint<X: Copy>(&self, fill: X) -> Self::PerJoint<X> {
                $map(self, |item| item.per_joint(fill))
            }
            fn per_axes<X: Copy>(&self, fill: X) -> Self::PerAxes<X> {
                $map(self, |item| item.per_axes(fill))
            }
            fn body_entry<'a, X: Copy>(&self, bodies: &'a Self::PerBody<X>, k: usize) -> Option<&'a X> {
                let (i, k) = locate(self, A::BODIES, Element::bodies, k)?;
                self.get(i)?.body_entry(bodies.get(i)?, k)
            }
            fn entry<'a, X: Copy>(
                &self,
                bodies: &'a Self::PerBody<X>,
                joints: &'a Self::PerJoint<X>,
                k: usize,
            ) -> Option<&'a X> {
                let (i, k) = locate(self, sum(A::BODIES, A::JOINTS), |item| item.bodies() + item.joints(), k)?;
                self.get(i)?.entry(bodies.get(i)?, joints.get(i)?, k)
            }
            fn each_entry<'a, 'b, X: Copy + 'a, Y: Copy + 'b>(
                bodies: &'a Self::PerBody<X>,
                joints: &'b Self::PerJoint<Y>,
                note: &mut impl FnMut(Entry<&'a X, &'b Y>),
            ) {
                bodies.iter().zip(joints).for_each(|(bodies, joints)| A::each_entry(bodies, joints, note));
            }
            fn aim(
                &self,
                position: &mut Self::Position,
                turn: S::Turn,
                next: &mut impl FnMut(S::Turn) -> S::Scalar,
            ) -> S::Turn {
                self.iter().zip(position).fold(turn, |turn, (item, position)| item.aim(position, turn, next))
            }
            fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
                self.iter_mut().rev().fold(mass, |mass, item| item.lump(mass))
            }
            #[inline]
            fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
                turned_by_items(self, position, rate, turn)
            }
            #[inline]
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
                orient_items(self, position, rate, turn, x, y, p, q)
            }
            fn size(&self, sizes: &mut Self::PerAxes<S::Size>) {
                self.iter().zip(sizes).for_each(|(item, size)| item.size(size));
            }
            #[inline]
            fn resolve(
                sizes: &Self::PerAxes<S::Size>,
                x: &mut Self::PerAxes<S::X>,
                y: &mut Self::PerAxes<S::Y>,
                p: &mut Self::PerAxes<S::P>,
                q: &mut Self::PerAxes<S::Q>,
            ) {
                resolve_items::<S, A>(sizes, x, y, p, q);
            }
            #[inline]
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
                if A::ABSOLUTE {
                    $pose(self, position, rate, turn, sizes, x, y, p, q);
                    turned_by_items(self, position, rate, turn)
                } else {
                    $pose_in_order(self, position, rate, turn, sizes, x, y, p, q)
                }
            }
            #[inline]
            fn recover<C: Closures, By: Springs<S::Scalar>>(
                &self,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &mut Self::Kept<C>,
                multipliers: &C::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> S::Acceleration {
                let Posture { x, y, p, q } = posture;
                let items = &self[..];
                march!(n: items x y p q; mut kept rate; else acceleration);
                let mut acceleration = acceleration;
                for i in 0..n {
                    let posture = Posture { x: &x[i], y: &y[i], p: &p[i], q: &q[i] };
                    acceleration =
                        items[i].recover::<C, By>(acceleration, posture, &mut kept[i], multipliers, &mut rate[i]);
                }
                acceleration
            }
            #[inline]
            fn respond<C: Closures>(
                &self,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &Self::Kept<C>,
                multipliers: &C::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> S::Acceleration {
                let Posture { x, y, p, q } = posture;
                let items = &self[..];
                march!(n: items x y p q kept; mut rate; else acceleration);
                let mut acceleration = acceleration;
                for i in 0..n {
                    let posture = Posture { x: &x[i], y: &y[i], p: &p[i], q: &q[i] };
                    acceleration = items[i].respond(acceleration, posture, &kept[i], multipliers, &mut rate[i]);
                }
                acceleration
            }
            const LOOPS: usize = A::LOOPS;
            const LINEAR: bool = A::LINEAR;
            fn restore<C: Closures>(
                &self,
                frame: S::Frame,
                motion: Coordinates<'_, S, Self>,
                level: Level,
                acceleration: S::Acceleration,
                posture: Posture<'_, S, Self>,
                kept: &Self::Kept<C>,
                multipliers: &C::Each<S::Scalar>,
                rate: &mut Self::Rate,
            ) -> (S::Frame, S::Acceleration) {
                let Posture { x, y, p, q } = posture;
                let (mut frame, mut acceleration) = (frame, acceleration);
                for (i, item) in self.iter().enumerate() {
                    let motion = item_motion!(motion, i);
                    let posture = Posture { x: &x[i], y: &y[i], p: &p[i], q: &q[i] };
                    (frame, acceleration) =
                        item.restore(frame, motion, level, acceleration, posture, &kept[i], multipliers, &mut rate[i]);
                }
                (frame, acceleration)
            }
            fn independent<C: Closures>(
                &self,
                frame: S::Frame,
                motion: Coordinates<'_, S, Self>,
                kept: &Self::Kept<C>,
                station: usize,
        tell: &mut impl FnMut(usize, &'static str),
            ) -> Result<S::Frame, Error> {
                let (mut frame, mut station) = (frame, station);
                for (i, item) in self.iter().enumerate() {
                    frame = item.independent(frame, item_motion!(motion, i), &kept[i], station, tell)?;
                    station += item.bodies() + item.joints();
                }
                Ok(frame)
            }
            #[inline(always)]
            fn spread_bodies<'v, X: Copy>(&self, values: &'v [X], bodies: &mut Self::PerBody<X>) -> &'v [X] {
                spread!(self, A::BODIES, spread_bodies: values, bodies)
            }
            #[inline(always)]
            fn spread_joints<'v, X: Copy>(&self, values: &'v [X], joints: &mut Self::PerJoint<X>) -> &'v [X] {
                spread!(self, A::JOINTS, spread_joints: values, joints)
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
                let Coordinates { position, rate, acceleration } = motion;
                let items = &self[..];
                march!(n: items position rate acceleration; mut on_bodies in_joints; else frame);
                let mut frame = frame;
                for i in 0..n {
                    let motion =
                        Coordinates { position: &position[i], rate: &rate[i], acceleration: &acceleration[i] };
                    frame = items[i].travel(frame, motion, visit, &mut on_bodies[i], &mut in_joints[i]);
                }
                frame
            }
            fn inward<G: Gather>(
                &self,
                bodies: &mut Self::PerBody<G::Entry>,
                joints: &mut Self::PerJoint<G::Entry>,
                outer: G::Carried,
                gather: &mut G,
            ) -> G::Carried {
                let items = self.iter().zip(bodies).zip(joints).rev();
                items.fold(outer, |outer, ((item, bodies), joints)| item.inward(bodies, joints, outer, gather))
            }
            fn broken<C: Closures>(&self, kept: &Self::Kept<C>, station: usize) -> Option<usize> {
                let mut station = station;
                let mut outermost = None;
                for (item, kept) in self.iter().zip(kept) {
                    outermost = item.broken(kept, station).or(outermost);
                    station += item.bodies() + item.joints();
                }
                outermost
            }
        }

        impl<S: Space, W: Sweep<S>, R, Q, A $($K)*> Condense<S, R, W> for $Of<A $($extra)*>
        where
            A: Condense<S, R, W, Out = Q> + Condense<S, Q, W, Out = Q>,
            Q: Meet<R> + Copy,
        {
            type Out = Q::Both;

            #[inline]
            fn condense(
                &self,
                outer: R,
                posture: Posture<'_, S, Self>,
                given: Given<'_, S, Self, W>,
                kept: &mut Self::Kept<W::Closures>,
            ) -> Q::Both {
                let Posture { x, y, p, q } = posture;
                let Given { on_bodies, in_joints, position, rate, reading, springs } = given;
                let items = &self[..];
                march!(
                    n: items x y p q on_bodies in_joints position rate;
                    mut kept;
                    else Q::of_none(outer)
                );
                let Some(last) = n.checked_sub(1) else {
                    return Q::of_none(outer);
                };
                // The last link meets what lies outboard of the array, every other one what its neighbour hands on. The first
                // round of the loop is peeled for it. (A closure would not always be inlined.)
                macro_rules! link {
                    ($i:expr, $met:ty, $outer:expr) => {{
                        let i = $i;
                        let posture = Posture { x: &x[i], y: &y[i], p: &p[i], q: &q[i] };
                        let given = Given {
                            on_bodies: &on_bodies[i],
                            in_joints: &in_joints[i],
                            position: &position[i],
                            rate: &rate[i],
                            // As many as the others, which a compiler does not know. Where nothing reads it, nothing is left of it.
                            reading: Reading {
                                position: reading.position.get(i).unwrap_or(&position[i]),
                                rate: reading.rate.get(i).unwrap_or(&rate[i]),
                                acceleration: reading.acceleration.get(i).unwrap_or(&rate[i]),
                            },
                            springs,
                        };
                        <A as Condense<S, $met, W>>::condense(&items[i], $outer, posture, given, &mut kept[i])
                    }};
                }
                let mut relation = link!(last, R, outer);
                for i in 1..n {
                    relation = link!(last - i, Q, relation);
                }
                Q::of_links(relation)
            }
        }
    };
}

chain_items!(Array, map_array, pose_items pose_items_in_order, [, const K: usize], [, K], |each| product(each, K));
#[cfg(feature = "alloc")]
chain_items!(Vec, map_vec, pose_slices pose_slices_in_order, [], [], |_each| None);
