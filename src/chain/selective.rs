//! Selective walks through tuples, arrays, vectors, arms, loops and names.

use super::{Branch, Named, Network};
use crate::element::Space;
use crate::shape::{Arm, Around, Closing, Main, Nth, Of, Parallel, Selective, Side, Slot, Takes, take_items};
use crate::tuples::for_each_tuple;

/// Pairs are the links of arrays and vectors: what they carry need not pass through memory.
macro_rules! takes_tuple {
    (X2; $($rest:tt)*) => {
        takes_of!([inline(always)] $($rest)*);
    };
    (X3; $($rest:tt)*) => {
        takes_of!([inline(always)] $($rest)*); // two bodies and the joint between them
    };
    (X4; $($rest:tt)*) => {
        takes_of!([inline(always)] $($rest)*); // an arm of a loop of four bodies
    };
    ($met:ident; $($rest:tt)*) => {
        takes_of!([inline] $($rest)*);
    };
}

macro_rules! takes_of {
    ([$($inline:tt)*] $($A:ident $i:tt $out:ident $in:ident),*; $($B:ident $j:tt),*) => {
        impl<S: Space, Walk: Selective<S>, $($A: Takes<S, Walk>),*> Takes<S, Walk> for ($($A,)*) {
            #[$($inline)*]
            fn take(&self, walk: &mut Walk, carried: Walk::Carried, stores: Of<'_, S, Walk, Self>) -> Walk::Carried {
                let mut stores = stores;
                if Walk::OUTWARD {
                    $(let carried = self.$i.take(walk, carried, Walk::Stores::member::<Self, _>(&mut stores, Nth::<$i>));)*
                    carried
                } else {
                    $(let carried = self.$j.take(walk, carried, Walk::Stores::member::<Self, _>(&mut stores, Nth::<$j>));)*
                    carried
                }
            }
        }
    };
}
for_each_tuple!(takes_tuple);

impl<S: Space, W: Selective<S>, A: Takes<S, W>, const K: usize> Takes<S, W> for [A; K] {
    #[cfg_attr(optimised, inline(always))]
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        take_items::<S, W, Self>(self, walk, carried, stores)
    }
}

#[cfg(feature = "alloc")]
impl<S: Space, W: Selective<S>, A: Takes<S, W>> Takes<S, W> for alloc::vec::Vec<A> {
    #[inline]
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        take_items::<S, W, Self>(self, walk, carried, stores)
    }
}

impl<S: Space, W: Selective<S>, A: Takes<S, W::In<Arm>>> Takes<S, W> for Branch<A> {
    #[inline]
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        let stores = W::Stores::arm::<Self>(stores);
        walk.branch(carried, |walk, carried| self.0.take(walk, carried, stores))
    }
}

impl<S, W, M, A, K> Takes<S, W> for Network<M, A, K>
where
    S: Space,
    K: Closing<S>,
    W: Around<S, K>,
    M: Takes<S, W::In<Main<K::Closures>>>,
    A: Takes<S, W::In<Side<K::Closures>>>,
{
    #[inline]
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        let (main, side, closing) = W::Stores::fork::<Self>(stores);
        walk.around(
            self.closing_joint(),
            carried,
            closing,
            |walk, carried| self.main().take(walk, carried, main),
            |walk, carried| self.side().take(walk, carried, side),
        )
    }
}

impl<S: Space, W: Selective<S>, E: Takes<S, W>> Takes<S, W> for Named<E> {
    #[inline(always)]
    fn take(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        let mut stores = stores;
        self.item.take(walk, carried, W::Stores::member::<Self, _>(&mut stores, Nth::<0>))
    }
}
