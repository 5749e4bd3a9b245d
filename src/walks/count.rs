//! Bodies and joints, counted.

use crate::mirror::Rate;
use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Joint, Outward, Shape, Walk, alike, items_outward};
use crate::space::Space;

/// Number of bodies in a chain.
pub fn bodies<S: Space, E: Shape<S>>(chain: &E) -> usize {
    count(chain).bodies
}

/// Number of joints in a chain.
pub fn joints<S: Space, E: Shape<S>>(chain: &E) -> usize {
    count(chain).joints
}

fn count<S: Space, E: Shape<S>>(chain: &E) -> Count {
    let mut count = Count { bodies: 0, joints: 0 };
    chain.outward(&mut count, (), ());
    count
}

/// Number of joints of one coordinate.
pub fn coordinates<S: Space, E: Shape<S>>(chain: &E) -> usize {
    let mut single = Single(0);
    chain.outward(&mut single, (), ());
    single.0
}

/// Counts joints of one coordinate.
struct Single(usize);

impl<S: Space> Walk<S> for Single {
    type Carried = ();
    type Stores = ();
}

impl<S: Space> Outward<S> for Single {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {
        self.0 += usize::from(<J::Rate as Rate<S::Scalar>>::LENGTH == 1);
    }
}

/// The station of a joint of one coordinate, by its number among these: how many bodies and joints come before it.
pub fn station_of_coordinate<S: Space, E: Shape<S>>(chain: &E, number: usize) -> usize {
    let mut walk = Station { before: number, elements: 0, found: false };
    chain.outward(&mut walk, (), ());
    walk.elements
}

/// Counts elements up to a joint of one coordinate.
struct Station {
    before: usize,
    elements: usize,
    found: bool,
}

impl<S: Space> Walk<S> for Station {
    type Carried = ();
    type Stores = ();
}

impl<S: Space> Outward<S> for Station {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.elements += usize::from(!self.found);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {
        let single = <J::Rate as Rate<S::Scalar>>::LENGTH == 1;
        self.found |= single && self.before == 0;
        self.before = self.before.saturating_sub(usize::from(single));
        self.elements += usize::from(!self.found);
    }
}

/// Counts what it meets.
struct Count {
    bodies: usize,
    joints: usize,
}

impl<S: Space> Walk<S> for Count {
    type Carried = ();
    type Stores = ();
}

impl<S: Space> Outward<S> for Count {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.bodies += 1;
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {
        self.joints += 1;
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], _: AtClosing<'_, S, Self, K>) {
        self.joints += 1;
    }
    /// Where each item has as many, at once.
    fn items<A: Shape<S>>(&mut self, items: &[A], (): (), (): ()) {
        match (A::BODIES, A::JOINTS) {
            (Some(bodies), Some(joints)) => {
                self.bodies += items.len() * bodies;
                self.joints += items.len() * joints;
            }
            _ => items_outward(self, items, (), ()),
        }
    }
}
