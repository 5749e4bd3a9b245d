//! Arrays and vectors of elements.

use super::poses::{march, orient_items, pose_items, pose_items_in_order, resolve_items, turned_by_items};
#[cfg(feature = "alloc")]
use super::poses::{pose_slices, pose_slices_in_order};
use super::product;
use crate::element::{Condense, Element, Given, Posture, Reading, Space, Sweep};
use crate::relation::Meet;
use crate::scalar::Scalar;
use crate::shape::{Field, Inward, Items, Kept, Of, Outward, PerAxes, Shape, Slot};

/// An array, spelled like a vector.
type Array<X, const K: usize> = [X; K];

/// The items of an array, mapped.
fn map_array<A, B, const K: usize>(items: &[A; K], mut make: impl FnMut(&A) -> B) -> [B; K] {
    core::array::from_fn(|k| make(&items[k]))
}

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// The items of a vector, mapped.
#[cfg(feature = "alloc")]
fn map_vec<A, B>(items: &[A], make: impl FnMut(&A) -> B) -> Vec<B> {
    items.iter().map(make).collect()
}

/// Condenses links from last to first, each after `$pose`. The last link meets what lies outboard of the array, every other one what its
/// neighbour hands on: the first round of the loop is peeled for it. (A closure would not always be inlined.)
macro_rules! links {
    ($A:ident $R:ident $Q:ident, $items:ident $outer:ident $given:ident $kept:ident, $x:ident $y:ident $p:ident $q:ident;
     [$($read:ident)*] [$($written:ident)*]; |$i:ident, $position:ident, $rate:ident| $pose:expr) => {{
        let Given { on_bodies, in_joints, position: $position, rate: $rate, reading, springs } = $given;
        march!(n: $items $($read)* on_bodies in_joints $position $rate; mut $($written)* $kept; else $Q::of_none($outer));
        let Some(last) = n.checked_sub(1) else {
            return $Q::of_none($outer);
        };
        macro_rules! link {
            ($at:expr, $met:ty, $outer_of:expr) => {{
                let $i = $at;
                $pose;
                let posture = Posture { x: &$x[$i], y: &$y[$i], p: &$p[$i], q: &$q[$i] };
                let given = Given {
                    on_bodies: &on_bodies[$i],
                    in_joints: &in_joints[$i],
                    position: &$position[$i],
                    rate: &$rate[$i],
                    // As many as the others, which a compiler does not know. Where nothing reads it, nothing is left of it.
                    reading: Reading {
                        position: reading.position.get($i).unwrap_or(&$position[$i]),
                        rate: reading.rate.get($i).unwrap_or(&$rate[$i]),
                        acceleration: reading.acceleration.get($i).unwrap_or(&$rate[$i]),
                    },
                    springs,
                };
                <$A as Condense<S, $met, W>>::condense(&$items[$i], $outer_of, posture, given, &mut $kept[$i])
            }};
        }
        let mut relation = link!(last, $R, $outer);
        for i in 1..n {
            relation = link!(last - i, $Q, relation);
        }
        $Q::of_links(relation)
    }};
}

/// One implementation for arrays and vectors, `$Of<item $extra>`.
macro_rules! chain_items {
    ($Of:ident, $map:ident, $pose:ident $pose_in_order:ident, [$($K:tt)*], [$($extra:tt)*], |$A:ident| $length:expr) => {
        impl<S: Space, A: Shape<S> $($K)*> Shape<S> for $Of<A $($extra)*> {
            type Store<F: Field<S>> = $Of<A::Store<F> $($extra)*>;

            const BODIES: Option<usize> = {
                let $A = A::BODIES;
                $length
            };
            const JOINTS: Option<usize> = {
                let $A = A::JOINTS;
                $length
            };
            const LOOPS: usize = A::LOOPS;
            const SHARES: bool = A::SHARES;
            const LINEAR: bool = A::LINEAR;
            const ROTARY: bool = A::ROTARY;
            const OWN_AXES: bool = A::OWN_AXES;
            const FLANGED: bool = A::FLANGED;
            const SINES: usize = {
                let $A = Some(A::SINES);
                match $length {
                    Some(count) => count,
                    None if A::SINES == 0 => 0,
                    None => usize::MAX,
                }
            };

            fn store<F: Field<S>>(&self, fill: F::Fill) -> Self::Store<F> {
                $map(self, |item| item.store::<F>(fill))
            }
            #[inline]
            fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
                walk.items(&self[..], carried, W::Stores::all::<Self>(stores))
            }
            #[inline]
            fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
                walk.items(&self[..], carried, W::Stores::all::<Self>(stores))
            }
        }

        impl<S: Space, A: Shape<S> $($K)*> Items<S> for $Of<A $($extra)*> {
            type Item = A;

            #[inline(always)]
            fn slice<F: Field<S>>(store: &Self::Store<F>) -> &[A::Store<F>] {
                store
            }
            #[inline(always)]
            fn slice_mut<F: Field<S>>(store: &mut Self::Store<F>) -> &mut [A::Store<F>] {
                store
            }
        }

        impl<S: Space, A: Element<S> $($K)*> Element<S> for $Of<A $($extra)*> {
            type Position = $Of<A::Position $($extra)*>;
            type Rate = $Of<A::Rate $($extra)*>;

            const ABSOLUTE: bool = A::ABSOLUTE;
            const POSED_LATE: bool = A::ABSOLUTE && <S::Scalar as Scalar>::LANES;
            const TURNS_ANEW: bool = {
                let $A = Some(1);
                let length: Option<usize> = $length;
                A::TURNS_ANEW && matches!(length, Some(1..)) // none, as a vector may have, turn nothing
            };

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
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
            ) -> S::Turn {
                orient_items(self, position, rate, turn, x, y, p, q)
            }
            #[inline]
            fn resolve(
                sizes: &Self::Store<PerAxes<S::Size>>,
                x: &mut Self::Store<PerAxes<S::X>>,
                y: &mut Self::Store<PerAxes<S::Y>>,
                p: &mut Self::Store<PerAxes<S::P>>,
                q: &mut Self::Store<PerAxes<S::Q>>,
            ) {
                resolve_items::<S, A>(sizes, x, y, p, q);
            }
            #[inline]
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
                if A::ABSOLUTE {
                    $pose(self, position, rate, turn, sizes, x, y, p, q);
                    turned_by_items(self, position, rate, turn)
                } else {
                    $pose_in_order(self, position, rate, turn, sizes, x, y, p, q)
                }
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
                kept: &mut Self::Store<Kept<W::Closures>>,
            ) -> Q::Both {
                let Posture { x, y, p, q } = posture;
                let items = &self[..];
                links!(A R Q, items outer given kept, x y p q; [x y p q] []; |_i, _position, _rate| ())
            }
            #[inline]
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
            ) -> Q::Both {
                if const { !<Self as Element<S>>::POSED_LATE } {
                    self.pose(given.position, given.rate, turn, sizes, x, y, p, q);
                    return self.condense(outer, Posture { x, y, p, q }, given, kept);
                }
                let items = &self[..];
                links!(A R Q, items outer given kept, x y p q; [sizes] [x y p q]; |i, position, rate| {
                    // Orientations inside do not depend on what lies inboard, so that any turn will do.
                    let (x, y, p, q) = (&mut x[i], &mut y[i], &mut p[i], &mut q[i]);
                    items[i].pose(&position[i], &rate[i], turn, &sizes[i], x, y, p, q)
                })
            }
        }
    };
}

chain_items!(Array, map_array, pose_items pose_items_in_order, [, const K: usize], [, K], |each| product(each, K));
#[cfg(feature = "alloc")]
chain_items!(Vec, map_vec, pose_slices pose_slices_in_order, [], [], |_each| None);
