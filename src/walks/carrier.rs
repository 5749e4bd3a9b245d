//! The joint that turns a body.

use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Outward, Positions, Rates, Ref, Shape, Walk, alike,
};
use crate::space::Space;
use crate::turning::{Axes, Turning, outboard};

/// A body and the joint that turns it: the last on the way from the root that turns at all.
#[derive(Clone, Copy, Debug)]
pub struct Carrier<S: Space> {
    /// The number of the joint among joints.
    pub joint: usize,
    /// The body inboard of that joint.
    pub inboard: S::Turn,
    /// The body outboard of that joint, to which the body sought is fixed.
    pub outboard: S::Turn,
    /// The body sought.
    pub body: S::Turn,
}

/// The joint that turns body `k` of a chain, if there is one.
pub fn carrier<S: Turning, E: Shape<S>>(
    chain: &E,
    ground: S::Turn,
    position: &E::Store<Positions>,
    rate: &E::Store<Rates>,
    k: usize,
) -> Option<Carrier<S>> {
    let mut search = Search { left: Some(k), joints: 0, found: None };
    chain.outward(&mut search, (ground, None), (position, rate));
    search.found
}

/// Bodies before the one sought, none once it is found.
struct Search<S: Space> {
    left: Option<usize>,
    joints: usize,
    found: Option<Carrier<S>>,
}

impl<S: Turning> Walk<S> for Search<S> {
    /// Orientation, and the last joint that turns: its number, and the bodies inboard and outboard of it.
    type Carried = (S::Turn, Option<(usize, S::Turn, S::Turn)>);
    type Stores = (Ref<Positions>, Ref<Rates>);
}

impl<S: Turning> Outward<S> for Search<S> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, carried: Self::Carried, _: AtBody<'_, S, Self, B>) -> Self::Carried {
        if self.left == Some(0) {
            let (body, last) = carried;
            self.found = last.map(|(joint, inboard, outboard)| Carrier { joint, inboard, outboard, body });
        }
        self.left = self.left.and_then(|left| left.checked_sub(1));
        carried
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        (inboard, last): Self::Carried,
        (position, rate): AtJoint<'_, S, Self, J>,
    ) -> Self::Carried {
        let turned = outboard(joint, inboard, position, rate);
        let number = self.joints;
        self.joints += 1;
        let turns = Axes::of::<S, J>(joint, inboard, position).count() > 0;
        (turned, if turns { Some((number, inboard, turned)) } else { last })
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [Self::Carried; 2], _: AtClosing<'_, S, Self, K>) {
        self.joints += 1;
    }
}
