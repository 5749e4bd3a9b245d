//! The joint where a sweep failed, and the drive whose law did.

use crate::mirror::Rate;
use crate::relation::Closures;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Kept, Of, Outward, Parallel, Positions, Rates, Ref, Shape, Walk,
    Way, alike, parallel_outward,
};
use crate::space::{FrameOf, Space};
use core::marker::PhantomData;

/// The outermost joint whose pivot does not resist: the number of its station, where a sweep failed.
pub fn broken<S: Space, E: Shape<S>, C: Closures>(chain: &E, kept: &E::Store<Kept<C>>) -> Option<usize> {
    let mut broken = Broken::<C> { met: 0, outermost: None, closures: PhantomData };
    chain.outward(&mut broken, (), (kept,));
    broken.outermost
}

/// Stations met, and the outermost of them that is broken, where `C` act.
struct Broken<C> {
    met: usize,
    outermost: Option<usize>,
    closures: PhantomData<C>,
}

impl<C> Broken<C> {
    fn note(&mut self, broken: bool) {
        if broken {
            self.outermost = Some(self.met);
        }
        self.met += 1;
    }
}

impl<S: Space, C: Closures> Walk<S> for Broken<C> {
    type Carried = ();
    type Stores = (Ref<Kept<C>>,);
}

impl<S: Space, C: Closures> Outward<S> for Broken<C> {
    type In<Y: Way> = Broken<Y::Forces<C>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        let mut arm = Broken { met: self.met, outermost: self.outermost, closures: PhantomData };
        let out = go(&mut arm);
        (self.met, self.outermost) = (arm.met, arm.outermost);
        out
    }
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.note(false);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (kept,): AtJoint<'_, S, Self, J>) {
        self.note(!J::is_finite::<C>(kept));
    }
    /// A loop is not closed where an arm of it fails.
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], ((gain, _),): AtClosing<'_, S, Self, K>) {
        self.note(self.outermost.is_none() && !gain.is_finite());
    }
    fn parallel<N: Parallel<S>>(&mut self, net: &N, (): (), stores: Of<'_, S, Self, N>) {
        let before = self.outermost.take();
        parallel_outward(self, net, (), stores);
        self.outermost = self.outermost.or(before);
    }
}

/// The first joint without a coordinate of its own whose motion is not finite on sound ground: the number of its station.
pub fn unled<S: Space, E: Shape<S>>(
    chain: &E,
    ground: FrameOf<S>,
    position: &E::Store<Positions>,
    rate: &E::Store<Rates>,
) -> Option<usize> {
    let mut unled = Unled::<S> { ground, met: 0, first: None };
    chain.outward(&mut unled, (), (position, rate));
    unled.first
}

/// Stations met, and the first of them that has no motion.
struct Unled<S: Space> {
    ground: FrameOf<S>,
    met: usize,
    first: Option<usize>,
}

impl<S: Space> Walk<S> for Unled<S> {
    type Carried = ();
    type Stores = (Ref<Positions>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Unled<S> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.met += 1;
    }
    fn joint<J: Joint<S>>(&mut self, joint: &J, (): (), (position, rate): AtJoint<'_, S, Self, J>) {
        if self.first.is_none() && J::Rate::LENGTH == 0 {
            let finite = joint.motion(self.ground, position, rate, &J::still().1).1.is_finite();
            self.first = (!finite).then_some(self.met);
        }
        self.met += 1;
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], _: AtClosing<'_, S, Self, K>) {
        self.met += 1;
    }
}
