//! Slots: the stores of a walk, as the walk sees them at a composite, at its items, at a body, at a joint.
//!
//! A walk lists what it reads and writes, `type Stores = (Ref<Positions>, Mut<Kept<C>>)`. At an element `E` this is then
//! `(&E::Store<Positions>, &mut E::Store<Kept<C>>)`, and each composite hands on the parts of its items. Nothing here knows any physics.

use super::Shape;
use super::closing::Closing;
use super::field::{Arm, Field, Main, Side, Way};
use super::leaf::{AsBody, AsJoint, Body, Joint};
use super::part::{Aside, Items, Member, Parallel};
use crate::space::Space;
use core::marker::PhantomData;

/// A store that is read.
pub struct Ref<F>(PhantomData<F>);

/// A store that is written.
pub struct Mut<F>(PhantomData<F>);

/// A store that is read, and whose entries a walk may keep for `'s`.
pub struct Held<'s, F>(PhantomData<&'s F>);

/// The closure forces of a loop.
type Own<S, N> = <<N as Parallel<S>>::Closing as Closing<S>>::Closures;
/// A slot in the main arm of a loop.
type InMain<'a, S, X, N> = <<X as Slot<S>>::In<Main<Own<S, N>>> as Slot<S>>::Of<'a, <N as Parallel<S>>::Main>;
/// A slot in the side arm.
type InSide<'a, S, X, N> = <<X as Slot<S>>::In<Side<Own<S, N>>> as Slot<S>>::Of<'a, <N as Parallel<S>>::Side>;
/// The entry of the joint that closes the loop.
type AtClosing<'a, S, X, N> = <X as Slot<S>>::InClosing<'a, <N as Parallel<S>>::Closing>;

/// A store as a walk sees it, or a tuple of such stores.
pub trait Slot<S: Space> {
    /// The store at an element.
    type Of<'a, E: Shape<S>>;
    /// The stores of the items of an array or vector.
    type Slices<'a, A: Shape<S>>;
    /// The entry of a body.
    type InBody<'a, B: Body<S>>;
    /// The entry of a joint.
    type InJoint<'a, J: Joint<S>>;
    /// The entry of a joint that closes a loop.
    type InClosing<'a, K: Closing<S>>;
    /// The slot in an arm.
    type In<Y: Way>: Slot<S>;

    /// The entry of an element that is a body.
    fn body<'a, B: AsBody<S>>(store: Self::Of<'a, B>) -> Self::InBody<'a, B>;
    /// The entry of an element that is a joint.
    fn joint<'a, J: AsJoint<S>>(store: Self::Of<'a, J>) -> Self::InJoint<'a, J>;
    /// The store of a member of a composite.
    fn member<'a, E: Shape<S>, P: Member<S, E> + Copy>(
        store: &'a mut Self::Of<'_, E>,
        member: P,
    ) -> Self::Of<'a, P::Item>;
    /// The stores of the items of an array or vector.
    fn all<'a, E: Items<S>>(store: Self::Of<'a, E>) -> Self::Slices<'a, E::Item>;
    /// Whether there are `n` stores of items.
    fn fit<A: Shape<S>>(slices: &Self::Slices<'_, A>, n: usize) -> bool;
    /// The store of item `i`.
    fn at<'a, A: Shape<S>>(slices: &'a mut Self::Slices<'_, A>, i: usize) -> Self::Of<'a, A>;
    /// The store of the arm of a branch.
    fn arm<'a, E: Aside<S>>(store: Self::Of<'a, E>) -> <Self::In<Arm> as Slot<S>>::Of<'a, E::Arm>;
    /// The stores of the main arm and the side arm of a loop, and the entry of the joint that closes it.
    #[allow(clippy::type_complexity)] // three of them
    fn fork<'a, N: Parallel<S>>(
        store: Self::Of<'a, N>,
    ) -> (InMain<'a, S, Self, N>, InSide<'a, S, Self, N>, AtClosing<'a, S, Self, N>)
    where
        Self: Sized;
}

/// A slot that is a reference: `$a` its lifetime, `$get` how it is taken apart.
macro_rules! slot {
    ([$($life:lifetime)?] $Slot:ident, [$($mutable:tt)?], $a:lifetime, $entry:ident $get:ident $slice:ident $arm:ident $fork:ident) => {
        impl<$($life,)? S: Space, F: Field<S>> Slot<S> for $Slot<$($life,)? F> {
            type Of<'a, E: Shape<S>> = &$a $($mutable)? E::Store<F>;
            type Slices<'a, A: Shape<S>> = &$a $($mutable)? [A::Store<F>];
            type InBody<'a, B: Body<S>> = &$a $($mutable)? F::InBody<B>;
            type InJoint<'a, J: Joint<S>> = &$a $($mutable)? F::InJoint<J>;
            type InClosing<'a, K: Closing<S>> = &$a $($mutable)? F::InClosing<K>;
            type In<Y: Way> = $Slot<$($life,)? F::In<Y>>;

            #[inline(always)]
            fn body<'a, B: AsBody<S>>(store: Self::Of<'a, B>) -> Self::InBody<'a, B> {
                B::$entry::<F>(store)
            }
            #[inline(always)]
            fn joint<'a, J: AsJoint<S>>(store: Self::Of<'a, J>) -> Self::InJoint<'a, J> {
                J::$entry::<F>(store)
            }
            #[cfg_attr(optimised, inline(always))]
            fn member<'a, E: Shape<S>, P: Member<S, E> + Copy>(
                store: &'a mut Self::Of<'_, E>,
                _: P,
            ) -> Self::Of<'a, P::Item> {
                P::$get::<F>(*store)
            }
            #[inline(always)]
            fn all<'a, E: Items<S>>(store: Self::Of<'a, E>) -> Self::Slices<'a, E::Item> {
                E::$slice::<F>(store)
            }
            #[inline(always)]
            fn fit<A: Shape<S>>(slices: &Self::Slices<'_, A>, n: usize) -> bool {
                slices.len() == n
            }
            #[inline(always)]
            fn at<'a, A: Shape<S>>(slices: &'a mut Self::Slices<'_, A>, i: usize) -> Self::Of<'a, A> {
                &$($mutable)? (*slices)[i]
            }
            #[inline(always)]
            fn arm<'a, E: Aside<S>>(store: Self::Of<'a, E>) -> <Self::In<Arm> as Slot<S>>::Of<'a, E::Arm> {
                E::$arm::<F>(store)
            }
            #[cfg_attr(optimised, inline(always))]
            fn fork<'a, N: Parallel<S>>(
                store: Self::Of<'a, N>,
            ) -> (InMain<'a, S, Self, N>, InSide<'a, S, Self, N>, AtClosing<'a, S, Self, N>) {
                N::$fork::<F>(store)
            }
        }
    };
}
slot!([] Ref, [], 'a, entry get slice arm fork);
slot!([] Mut, [mut], 'a, entry_mut get_mut slice_mut arm_mut fork_mut);
slot!(['s] Held, [], 's, entry get slice arm fork);

/// Slots together.
macro_rules! slots {
    ($($X:ident $i:tt),*) => {
        #[allow(non_snake_case, clippy::unused_unit)] // a variable named as its type; the tuple of none
        impl<S: Space, $($X: Slot<S>),*> Slot<S> for ($($X,)*) {
            type Of<'a, E: Shape<S>> = ($($X::Of<'a, E>,)*);
            type Slices<'a, A: Shape<S>> = ($($X::Slices<'a, A>,)*);
            type InBody<'a, B: Body<S>> = ($($X::InBody<'a, B>,)*);
            type InJoint<'a, J: Joint<S>> = ($($X::InJoint<'a, J>,)*);
            type InClosing<'a, K: Closing<S>> = ($($X::InClosing<'a, K>,)*);
            type In<Y: Way> = ($($X::In<Y>,)*);

            #[inline(always)]
            fn body<'a, B: AsBody<S>>(_stores: Self::Of<'a, B>) -> Self::InBody<'a, B> {
                ($($X::body::<B>(_stores.$i),)*)
            }
            #[inline(always)]
            fn joint<'a, J: AsJoint<S>>(_stores: Self::Of<'a, J>) -> Self::InJoint<'a, J> {
                ($($X::joint::<J>(_stores.$i),)*)
            }
            #[cfg_attr(optimised, inline(always))]
            fn member<'a, E: Shape<S>, P: Member<S, E> + Copy>(
                _stores: &'a mut Self::Of<'_, E>,
                _member: P,
            ) -> Self::Of<'a, P::Item> {
                ($($X::member::<E, P>(&mut _stores.$i, _member),)*)
            }
            #[inline(always)]
            fn all<'a, E: Items<S>>(_stores: Self::Of<'a, E>) -> Self::Slices<'a, E::Item> {
                ($($X::all::<E>(_stores.$i),)*)
            }
            #[inline(always)]
            fn fit<A: Shape<S>>(_slices: &Self::Slices<'_, A>, _n: usize) -> bool {
                true $(&& $X::fit::<A>(&_slices.$i, _n))*
            }
            #[inline(always)]
            fn at<'a, A: Shape<S>>(_slices: &'a mut Self::Slices<'_, A>, _i: usize) -> Self::Of<'a, A> {
                ($($X::at::<A>(&mut _slices.$i, _i),)*)
            }
            #[inline(always)]
            fn arm<'a, E: Aside<S>>(_stores: Self::Of<'a, E>) -> <Self::In<Arm> as Slot<S>>::Of<'a, E::Arm> {
                ($($X::arm::<E>(_stores.$i),)*)
            }
            #[cfg_attr(optimised, inline(always))]
            fn fork<'a, N: Parallel<S>>(
                _stores: Self::Of<'a, N>,
            ) -> (InMain<'a, S, Self, N>, InSide<'a, S, Self, N>, AtClosing<'a, S, Self, N>) {
                $(let $X = $X::fork::<N>(_stores.$i);)*
                (($($X.0,)*), ($($X.1,)*), ($($X.2,)*))
            }
        }
    };
}
slots!();
slots!(X0 0);
slots!(X0 0, X1 1);
slots!(X0 0, X1 1, X2 2);
slots!(X0 0, X1 1, X2 2, X3 3);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4, X5 5);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4, X5 5, X6 6);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4, X5 5, X6 6, X7 7);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4, X5 5, X6 6, X7 7, X8 8);
slots!(X0 0, X1 1, X2 2, X3 3, X4 4, X5 5, X6 6, X7 7, X8 8, X9 9);
