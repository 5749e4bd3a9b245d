//! By how much loops are open, relative to their size, where their forces are shared out.

use crate::element::Coordinates;
use crate::relation::{Closures, Own, VectorSpace};
use crate::scalar::{Elementary, Real, Scalar};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Kept, Main, Mut, Of, Outward, OwnOf, Parallel, Positions, Rates, Ref, Shape,
    Side, Slot, Walk, Way, alike,
};
use crate::space::{FrameOf, RealOf, Space};
use core::marker::PhantomData;
use num_traits::{One, Zero};

/// Tells loops whose forces are shared out by what share of their size they are open, those inside of them included: off the places where
/// closures follow from others they follow no more, by the square of that.
pub fn apart<S: Space, E: Shape<S>, C: Closures>(
    chain: &E,
    frame: FrameOf<S>,
    position: &E::Store<Positions>,
    rate: &E::Store<Rates>,
    kept: &mut E::Store<Kept<C>>,
) {
    let mut walk = Apart::<S, C> { open: Zero::zero(), closures: PhantomData };
    chain.outward(&mut walk, (frame, Zero::zero()), (position, rate, kept));
}

/// What is left open in loops whose forces are shared out, if anything: the largest share of a loop's size, the residual in its place (m, rad), and the
/// station of the joint that should close it. Entry 0 is the root's joint.
pub fn torn<S: Space, E: Shape<S>>(chain: &E, frame: FrameOf<S>, motion: Coordinates<'_, S, E>) -> Torn<RealOf<S>> {
    let mut walk = Tear::<S> { met: 0, worst: Torn { share: Zero::zero(), residual: Zero::zero(), entry: 0 } };
    chain.outward(&mut walk, (frame, Zero::zero()), (motion.position, motion.rate));
    walk.worst
}

/// A loop that is open.
#[derive(Clone, Copy, Debug)]
pub struct Torn<R> {
    /// The largest residual, of places as a share of the way around the loop, of turns in rad.
    pub share: R,
    /// The largest residual (m, rad).
    pub residual: R,
    /// Bodies and joints met before its closing joint.
    pub entry: usize,
}

/// A place, and how long the way is that leads there from where the innermost loop begins (m).
type Reached<S> = (FrameOf<S>, RealOf<S>);

/// How far a step outward leads (m).
fn led<S: Space>((from, way): Reached<S>, to: FrameOf<S>) -> Reached<S> {
    let step = to.place - from.place;
    (to, way + VectorSpace::dot(step, step).real().sqrt())
}

/// The largest residual of a loop with these ends, and the same with places as shares of the way around.
fn missed<S: Space, N: Parallel<S>>(net: &N, main: &Reached<S>, side: &Reached<S>) -> [RealOf<S>; 2] {
    let around = main.1 + side.1;
    let unit = if around > Zero::zero() { around } else { One::one() };
    let (mut most, mut number) = ([RealOf::<S>::zero(); 2], 0);
    let [place, _] = net.closing_joint().residual(&side.0, &main.0);
    OwnOf::<S, N>::map(&place, |x| {
        let x = x.real().abs();
        let share = if number < S::PLACES { x / unit } else { x };
        most = [x.max(most[0]), share.max(most[1])];
        number += 1;
    });
    most
}

/// Looks at the ends of loops where `C` act on the chain.
struct Apart<S: Space, C> {
    /// The largest share of all loops met.
    open: RealOf<S>,
    closures: PhantomData<C>,
}

impl<S: Space, C: Closures> Walk<S> for Apart<S, C> {
    type Carried = Reached<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Mut<Kept<C>>);
}

impl<S: Space, C: Closures> Outward<S> for Apart<S, C> {
    type In<Y: Way> = Apart<S, Y::Forces<C>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        let mut arm = Apart { open: self.open, closures: PhantomData };
        let out = go(&mut arm);
        self.open = arm.open;
        out
    }
    fn body<B: Body<S>>(&mut self, body: &B, reached: Reached<S>, _: AtBody<'_, S, Self, B>) -> Reached<S> {
        led::<S>(reached, body.motion(reached.0).1)
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        reached: Reached<S>,
        (position, rate, _): AtJoint<'_, S, Self, J>,
    ) -> Reached<S> {
        led::<S>(reached, joint.motion(reached.0, position, rate, rate).1)
    }
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        (frame, way): Reached<S>,
        stores: Of<'_, S, Self, N>,
    ) -> Reached<S> {
        let (main, side, (_, _, (gain, _))) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let outside = core::mem::replace(&mut self.open, Zero::zero());
        let begin = (frame, Zero::zero());
        let main = Outward::<S>::enter::<Main<OwnOf<S, N>>, _>(self, |walk| net.main_arm().outward(walk, begin, main));
        let side = Outward::<S>::enter::<Side<OwnOf<S, N>>, _>(self, |walk| net.side_arm().outward(walk, begin, side));
        let [_, share] = missed::<S, N>(net, &main, &side);
        self.open = self.open.max(share);
        gain.open(self.open);
        self.open = self.open.max(outside);
        (main.0, way + main.1)
    }
}

/// Looks for the loop that is open most, of those whose forces are shared out.
struct Tear<S: Space> {
    met: usize,
    worst: Torn<RealOf<S>>,
}

impl<S: Space> Walk<S> for Tear<S> {
    type Carried = Reached<S>;
    type Stores = (Ref<Positions>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Tear<S> {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, reached: Reached<S>, _: AtBody<'_, S, Self, B>) -> Reached<S> {
        self.met += 1;
        led::<S>(reached, body.motion(reached.0).1)
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        reached: Reached<S>,
        (position, rate): AtJoint<'_, S, Self, J>,
    ) -> Reached<S> {
        self.met += 1;
        led::<S>(reached, joint.motion(reached.0, position, rate, rate).1)
    }
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        (frame, way): Reached<S>,
        stores: Of<'_, S, Self, N>,
    ) -> Reached<S> {
        let (main, side, _) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let begin = (frame, Zero::zero());
        let main = net.main_arm().outward(self, begin, main);
        let side = net.side_arm().outward(self, begin, side);
        if const { <OwnOf<S, N> as Own>::SHARES } {
            let [residual, share] = missed::<S, N>(net, &main, &side);
            // What is no number is told as such by others.
            if share > self.worst.share {
                self.worst = Torn { share, residual, entry: self.met };
            }
        }
        self.met += 1;
        (main.0, way + main.1)
    }
}
