//! Bodies that may spin about their own line as they like: between two joints that turn about all axes, or beyond the last one.
//!
//! What lies outboard of such a joint has no inertia about that line, and the pivot of the elimination is zero. In inertial axes
//! it is the rounding of zero unless bodies stand along the axes, and gains are finite: so a sweep does not see it.

use crate::element::Coordinates;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Of, Outward, Parallel, Positions, Rates, Ref, Shape, Walk, Way,
    parallel_outward,
};
use crate::space::{FrameOf, MovingBody, Space};

/// The number of the joint inboard of the first body of a chain with a free tip, or a held one, that nothing keeps from spinning.
pub fn loose<S: Space, E: Shape<S>>(
    chain: &E,
    ground: FrameOf<S>,
    Coordinates { position, rate, acceleration }: Coordinates<'_, S, E>,
    free: bool,
) -> Option<usize> {
    let mut walk = Loose { met: 0, ball: None, spins: None, found: None, closed: false };
    chain.outward(&mut walk, ground, (position, rate, acceleration));
    walk.found.or(walk.spins.filter(|_| free))
}

/// Stations met.
struct Loose {
    met: usize,
    /// The joint just met, if it turns about all axes.
    ball: Option<usize>,
    /// Such a joint, if the body just met has no inertia about its line.
    spins: Option<usize>,
    found: Option<usize>,
    /// Whether the arm to come is that of a loop, which its other end holds.
    closed: bool,
}

impl<S: Space> Walk<S> for Loose {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>);
}

impl<S: Space> Outward<S> for Loose {
    type In<Y: Way> = Self;

    /// What leaves a body there may hold it: that is not looked at.
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self) -> X) -> X {
        let closed = core::mem::replace(&mut self.closed, false);
        (self.ball, self.spins) = (None, None);
        let out = go(self);
        self.found = self.found.or(self.spins.take().filter(|_| !closed));
        (self.ball, self.spins, self.closed) = (None, None, closed);
        out
    }
    fn body<B: Body<S>>(&mut self, body: &B, frame: FrameOf<S>, _: AtBody<'_, S, Self, B>) -> FrameOf<S> {
        let (motion, outboard) = body.motion(frame);
        self.spins = self.ball.take().filter(|_| motion.spins_about_its_line());
        self.met += 1;
        outboard
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, acceleration): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        let (motion, outboard) = joint.motion(frame, position, rate, acceleration);
        let turns = !joint.release(&motion, position, rate).carries;
        self.found = self.found.or(self.spins.take().filter(|_| turns));
        self.ball = turns.then_some(self.met);
        self.met += 1;
        outboard
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [FrameOf<S>; 2], _: AtClosing<'_, S, Self, K>) {
        self.met += 1;
    }
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let outer = core::mem::replace(&mut self.closed, true);
        let end = parallel_outward(self, net, frame, stores);
        (self.ball, self.spins, self.closed) = (None, None, outer);
        end
    }
}
