//! Walks: what is done at each body and at each joint of a chain, from its root to its tips or from them to the root.
//!
//! A walk is a value with two methods, one for bodies and one for joints. It carries something from element to element and reads or
//! writes stores ([`Slot`]). In which order elements are met is said once by each composite ([`Shape::outward`], [`Shape::inward`]);
//! where a walk does better than element after element, or where arms meet again, it overrides [`Outward::items`] or
//! [`Outward::parallel`].

use super::Shape;
use super::closing::Closing;
use super::field::{Arm, Main, Side, Way};
use super::leaf::{Body, Joint};
use super::part::{Aside, OwnOf, Parallel};
use super::slot::Slot;
use crate::space::Space;

/// The stores of a walk at an element.
pub type Of<'a, S, W, E> = <<W as Walk<S>>::Stores as Slot<S>>::Of<'a, E>;
/// The stores of a walk at the items of an array or vector.
pub type Slices<'a, S, W, A> = <<W as Walk<S>>::Stores as Slot<S>>::Slices<'a, A>;
/// The stores of a walk at a body.
pub type AtBody<'a, S, W, B> = <<W as Walk<S>>::Stores as Slot<S>>::InBody<'a, B>;
/// The stores of a walk at a joint.
pub type AtJoint<'a, S, W, J> = <<W as Walk<S>>::Stores as Slot<S>>::InJoint<'a, J>;
/// The stores of a walk at a joint that closes a loop.
pub type AtClosing<'a, S, W, K> = <<W as Walk<S>>::Stores as Slot<S>>::InClosing<'a, K>;

/// What a walk carries, and what it reads and writes.
pub trait Walk<S: Space>: Sized {
    /// What the walk carries from element to element. What it carries into an arm does not come back from there: totals belong into
    /// the walk.
    type Carried: Copy;
    /// The stores that the walk reads and writes.
    type Stores: Slot<S>;
}

/// A walk from the root to the tips.
pub trait Outward<S: Space>: Walk<S> {
    /// The walk in an arm.
    type In<Y: Way>: Outward<S, Carried = Self::Carried, Stores = <Self::Stores as Slot<S>>::In<Y>>;

    /// Goes on in an arm, and comes back. An arm of a loop in which closure forces act that only the loop knows is no business of this
    /// method: a walk that needs these overrides [`parallel`](Self::parallel).
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X;

    /// Meets a body.
    fn body<B: Body<S>>(&mut self, body: &B, carried: Self::Carried, at: AtBody<'_, S, Self, B>) -> Self::Carried;

    /// Meets a joint.
    fn joint<J: Joint<S>>(&mut self, joint: &J, carried: Self::Carried, at: AtJoint<'_, S, Self, J>) -> Self::Carried;

    /// Meets the joint that closes a loop, with what it has carried to the ends of the side arm and of the main arm.
    #[inline(always)]
    fn closing<K: Closing<S>>(&mut self, closing: &K, ends: [Self::Carried; 2], at: AtClosing<'_, S, Self, K>) {
        let _ = (closing, ends, at);
    }

    /// Meets what has a name, and comes back; by default names do not matter.
    #[inline(always)]
    fn named<X>(&mut self, name: &'static str, go: impl FnOnce(&mut Self) -> X) -> X {
        let _ = name;
        go(self)
    }

    /// Meets the items of an array or vector.
    #[cfg_attr(optimised, inline(always))]
    fn items<A: Shape<S>>(
        &mut self,
        items: &[A],
        carried: Self::Carried,
        slices: Slices<'_, S, Self, A>,
    ) -> Self::Carried {
        items_outward(self, items, carried, slices)
    }

    /// Meets arms in parallel.
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        carried: Self::Carried,
        stores: Of<'_, S, Self, N>,
    ) -> Self::Carried {
        parallel_outward(self, net, carried, stores)
    }
}

/// Items one after the other. There are as many in each store, which one comparison makes known to the loop.
#[cfg_attr(optimised, inline(always))]
pub fn items_outward<S: Space, W: Outward<S>, A: Shape<S>>(
    walk: &mut W,
    items: &[A],
    carried: W::Carried,
    slices: Slices<'_, S, W, A>,
) -> W::Carried {
    let (n, mut slices, mut carried) = (items.len(), slices, carried);
    if !W::Stores::fit::<A>(&slices, n) {
        return carried;
    }
    #[allow(clippy::needless_range_loop)] // one counter for items and stores
    for i in 0..n {
        carried = items[i].outward(walk, carried, W::Stores::at::<A>(&mut slices, i));
    }
    carried
}

/// The main arm, the side arm, the joint that closes their loop.
#[cfg_attr(optimised, inline(always))]
pub fn parallel_outward<S: Space, W: Outward<S>, N: Parallel<S>>(
    walk: &mut W,
    net: &N,
    carried: W::Carried,
    stores: Of<'_, S, W, N>,
) -> W::Carried {
    let (main, side, closing) = W::Stores::fork::<N>(stores);
    let main = walk.enter::<Main<OwnOf<S, N>>, _>(|walk| net.main_arm().outward(walk, carried, main));
    let side = walk.enter::<Side<OwnOf<S, N>>, _>(|walk| net.side_arm().outward(walk, carried, side));
    walk.closing(net.closing_joint(), [side, main], closing);
    main
}

/// An arm that leaves the chain, which goes on from where the arm began.
#[cfg_attr(optimised, inline(always))]
pub fn arm_outward<S: Space, W: Outward<S>, E: Aside<S>>(
    walk: &mut W,
    arm: &E::Arm,
    carried: W::Carried,
    stores: Of<'_, S, W, E>,
) -> W::Carried {
    let stores = W::Stores::arm::<E>(stores);
    walk.enter::<Arm, _>(
        #[cfg_attr(optimised, inline(always))]
        |walk| arm.outward(walk, carried, stores),
    );
    carried
}

/// A walk from the tips to the root.
pub trait Inward<S: Space>: Walk<S> {
    /// The walk in an arm.
    type In<Y: Way>: Inward<S, Carried = Self::Carried, Stores = <Self::Stores as Slot<S>>::In<Y>>;

    /// Goes on in an arm, and comes back.
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X;

    /// Meets a body.
    fn body<B: Body<S>>(&mut self, body: &B, carried: Self::Carried, at: AtBody<'_, S, Self, B>) -> Self::Carried;

    /// Meets a joint.
    fn joint<J: Joint<S>>(&mut self, joint: &J, carried: Self::Carried, at: AtJoint<'_, S, Self, J>) -> Self::Carried;

    /// What comes from beyond the tip of an arm.
    fn beyond(&mut self) -> Self::Carried;

    /// What goes on inward where an arm joins the chain.
    fn join(&mut self, chain: Self::Carried, arm: Self::Carried) -> Self::Carried;

    /// Meets the joint that closes a loop, with what comes from beyond a tip: what goes on into the side arm, and what joins the chain
    /// at the end of the main arm.
    fn closing<K: Closing<S>>(
        &mut self,
        closing: &K,
        beyond: Self::Carried,
        at: AtClosing<'_, S, Self, K>,
    ) -> [Self::Carried; 2];

    /// Meets the items of an array or vector.
    #[cfg_attr(optimised, inline(always))]
    fn items<A: Shape<S>>(
        &mut self,
        items: &[A],
        carried: Self::Carried,
        slices: Slices<'_, S, Self, A>,
    ) -> Self::Carried {
        let (n, mut slices, mut carried) = (items.len(), slices, carried);
        if !Self::Stores::fit::<A>(&slices, n) {
            return carried;
        }
        for i in (0..n).rev() {
            carried = items[i].inward(self, carried, Self::Stores::at::<A>(&mut slices, i));
        }
        carried
    }

    /// Meets arms in parallel: the joint that closes their loop, the side arm, the main arm.
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        carried: Self::Carried,
        stores: Of<'_, S, Self, N>,
    ) -> Self::Carried {
        let (main, side, closing) = Self::Stores::fork::<N>(stores);
        let beyond = self.beyond();
        let [into_side, onto_main] = self.closing(net.closing_joint(), beyond, closing);
        let side = self.enter::<Side<OwnOf<S, N>>, _>(|walk| net.side_arm().inward(walk, into_side, side));
        let outer = self.join(carried, onto_main);
        let main = self.enter::<Main<OwnOf<S, N>>, _>(|walk| net.main_arm().inward(walk, outer, main));
        self.join(main, side)
    }
}

/// An arm that leaves the chain, with what comes from its tip and from the chain.
#[cfg_attr(optimised, inline(always))]
pub fn arm_inward<S: Space, W: Inward<S>, E: Aside<S>>(
    walk: &mut W,
    arm: &E::Arm,
    carried: W::Carried,
    stores: Of<'_, S, W, E>,
) -> W::Carried {
    let stores = W::Stores::arm::<E>(stores);
    let beyond = walk.beyond();
    let arm = walk.enter::<Arm, _>(|walk| arm.inward(walk, beyond, stores));
    walk.join(carried, arm)
}

/// A walk that is the same in arms.
macro_rules! alike {
    () => {
        type In<Y: $crate::shape::Way> = Self;

        #[inline(always)]
        fn enter<Y: $crate::shape::Way, Answer>(&mut self, go: impl FnOnce(&mut Self) -> Answer) -> Answer {
            go(self)
        }
    };
}
pub(crate) use alike;
