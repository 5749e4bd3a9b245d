//! Loops one at a time, by their numbers: what is said of one of them, and of what moves when it alone is closed.
//!
//! A loop is closed without moving the station where it begins: what moves is its arms and all that lies outboard of it. Loops around it,
//! of which it is in an arm, stay open.

use crate::mirror::Rate;
use crate::relation::Closures;
use crate::shape::{
    Arm, AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Of, Outward, OwnOf, Parallel, PerClosure, Rates, Ref,
    Shape, Slot, Walk, Way, alike,
};
use crate::space::Space;
use num_traits::Zero;

/// What is left.
#[derive(Clone, Copy, PartialEq)]
pub enum Left {
    /// What belongs to the loop itself.
    Own,
    /// What belongs to all that moves when it is closed.
    Moving,
}

/// Sets to zero what is said of joints and loops, but for what is left.
pub fn single<S: Space, E: Shape<S>>(
    chain: &E,
    number: usize,
    left: Left,
    rates: &mut E::Store<Rates>,
    closures: &mut E::Store<PerClosure>,
) {
    chain.outward(&mut Single { place: Place::Before(number), left: Some(left) }, (), (rates, closures));
}

/// The number of loops.
pub fn loops<S: Space, E: Shape<S>>(chain: &E) -> usize {
    if const { E::LOOPS == 0 } {
        return 0;
    }
    let (mut rates, mut closures) = (chain.store::<Rates>(()), chain.store::<PerClosure>(()));
    let mut walk = Single { place: Place::Before(usize::MAX), left: None };
    chain.outward(&mut walk, (), (&mut rates, &mut closures));
    if let Place::Before(rest) = walk.place { usize::MAX - rest } else { 0 }
}

/// Where the walk is.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// Where so many other loops begin before the one.
    Before(usize),
    /// On what moves with it.
    Within,
    /// Where nothing does any more.
    After,
}

struct Single {
    place: Place,
    left: Option<Left>,
}

impl<S: Space> Walk<S> for Single {
    type Carried = ();
    type Stores = (Mut<Rates>, Mut<PerClosure>);
}

impl<S: Space> Outward<S> for Single {
    type In<Y: Way> = Self;

    /// Behind an arm in which the loop begins nothing moves.
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self) -> X) -> X {
        let before = self.place;
        let out = go(self);
        if before != Place::Within && self.place == Place::Within {
            self.place = Place::After;
        }
        out
    }
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (rate, ()): AtJoint<'_, S, Self, J>) {
        if self.left.is_some() && !(self.left == Some(Left::Moving) && self.place == Place::Within) {
            rate.replace(&mut |_| Zero::zero());
        }
    }
    fn parallel<N: Parallel<S>>(&mut self, net: &N, (): (), stores: Of<'_, S, Self, N>) {
        let (main, side, (_, closures)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let mut keep = self.left == Some(Left::Moving) && self.place == Place::Within;
        match self.place {
            Place::Before(0) => (self.place, keep) = (Place::Within, true),
            Place::Before(number) => self.place = Place::Before(number - 1),
            _ => {}
        }
        if !keep {
            *closures = OwnOf::<S, N>::each(|_| Zero::zero());
        }
        let before = self.place;
        net.main_arm().outward(self, (), main);
        let at_main = self.place;
        if before != Place::Within && at_main == Place::Within {
            self.place = Place::After;
        }
        Outward::<S>::enter::<Arm, _>(self, |walk| net.side_arm().outward(walk, (), side));
        if at_main == Place::Within {
            self.place = Place::Within;
        }
    }
}

/// Adds up what is said of loops.
pub fn add<S: Space, E: Shape<S>>(chain: &E, more: &E::Store<PerClosure>, sums: &mut E::Store<PerClosure>) {
    chain.outward(&mut Sum, (), (more, sums));
}

struct Sum;

impl<S: Space> Walk<S> for Sum {
    type Carried = ();
    type Stores = (Ref<PerClosure>, Mut<PerClosure>);
}

impl<S: Space> Outward<S> for Sum {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (more, sums): AtClosing<'_, S, Self, K>) {
        *sums = K::Closures::zip(sums, more, |sum, more| sum + more);
    }
}
