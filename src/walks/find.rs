//! Entries of bodies and joints, by number.

use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Held, Joint, Outward, PerBody, PerJoint, Shape, Slices, Slot, Walk,
    alike, items_outward,
};
use crate::space::Space;

/// The entry of body `k` of a chain.
pub fn body<'s, S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    bodies: &'s E::Store<PerBody<X>>,
    k: usize,
) -> Option<&'s X> {
    let mut search = Bodies(Search { left: Some(k), found: None });
    chain.outward(&mut search, (), (bodies,));
    search.0.found
}

/// The entry of body or joint `k` of a chain, counted together from the root.
pub fn entry<'s, S: Space, E: Shape<S>, X: Copy + 'static>(
    chain: &E,
    bodies: &'s E::Store<PerBody<X>>,
    joints: &'s E::Store<PerJoint<X>>,
    k: usize,
) -> Option<&'s X> {
    let mut search = Entries(Search { left: Some(k), found: None });
    chain.outward(&mut search, (), (bodies, joints));
    search.0.found
}

/// What is sought.
struct Search<'s, X> {
    /// How many entries there are before it; none once it is found.
    left: Option<usize>,
    found: Option<&'s X>,
}

/// Where the entry sought is among equal items.
enum Where {
    Elsewhere,
    In(usize),
    Unknown,
}

impl<'s, X> Search<'s, X> {
    fn meet(&mut self, entry: &'s X) {
        match self.left {
            Some(0) => (self.left, self.found) = (None, Some(entry)),
            Some(left) => self.left = Some(left - 1),
            None => (),
        }
    }

    /// By division where each of `n` items has as many entries.
    fn skip(&mut self, n: usize, each: Option<usize>) -> Where {
        let (Some(left), Some(each)) = (self.left, each) else {
            return if self.left.is_none() { Where::Elsewhere } else { Where::Unknown };
        };
        if left < n * each {
            self.left = Some(left % each);
            Where::In(left / each)
        } else {
            self.left = Some(left - n * each);
            Where::Elsewhere
        }
    }
}

/// Looks among bodies.
struct Bodies<'s, X>(Search<'s, X>);

/// Looks among bodies and joints.
struct Entries<'s, X>(Search<'s, X>);

/// Looks into one item, if it is known which.
macro_rules! among_items {
    ($each:expr) => {
        fn items<A: Shape<S>>(&mut self, items: &[A], (): (), slices: Slices<'_, S, Self, A>) {
            let mut slices = slices;
            match self.0.skip(items.len(), $each) {
                Where::Elsewhere => (),
                Where::In(i) => items[i].outward(self, (), <Self as Walk<S>>::Stores::at::<A>(&mut slices, i)),
                Where::Unknown => items_outward(self, items, (), slices),
            }
        }
    };
}

impl<'s, S: Space, X: Copy + 'static> Walk<S> for Bodies<'s, X> {
    type Carried = ();
    type Stores = (Held<'s, PerBody<X>>,);
}

impl<'s, S: Space, X: Copy + 'static> Outward<S> for Bodies<'s, X> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (body,): AtBody<'_, S, Self, B>) {
        self.0.meet(body);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    among_items!(A::BODIES);
}

impl<'s, S: Space, X: Copy + 'static> Walk<S> for Entries<'s, X> {
    type Carried = ();
    type Stores = (Held<'s, PerBody<X>>, Held<'s, PerJoint<X>>);
}

impl<'s, S: Space, X: Copy + 'static> Outward<S> for Entries<'s, X> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (body, _): AtBody<'_, S, Self, B>) {
        self.0.meet(body);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (_, joint): AtJoint<'_, S, Self, J>) {
        self.0.meet(joint);
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (_, joint): AtClosing<'_, S, Self, K>) {
        self.0.meet(joint);
    }
    among_items!(match (A::BODIES, A::JOINTS) {
        (Some(bodies), Some(joints)) => Some(bodies + joints),
        _ => None,
    });
}
