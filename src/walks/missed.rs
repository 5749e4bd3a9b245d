//! By what the ends of loops miss each other.

use crate::element::{Coordinates, Level};
use crate::relation::Closures;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerClosure, PerLoop, Positions, Rates, Ref, Shape,
    Walk, alike,
};
use crate::space::{FrameOf, Space};

/// How the ends of the side arm and of the main arm of a loop are turned.
pub type Turns<S> = PerLoop<[<S as Space>::Turn; 2]>;

/// Walks outward with complete kinematics and keeps by what the ends of each loop miss each other, with the opposite sign, and how they are
/// turned.
pub fn missed<S: Space, E: Shape<S>>(
    chain: &E,
    frame: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    level: Level,
    gaps: &mut E::Store<PerClosure>,
    turns: &mut E::Store<Turns<S>>,
) {
    let Coordinates { position, rate, acceleration } = motion;
    chain.outward(&mut Missed(level), frame, (position, rate, acceleration, gaps, turns));
}

/// Looks at the ends of loops.
struct Missed(Level);

impl<S: Space> Walk<S> for Missed {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>, Mut<PerClosure>, Mut<Turns<S>>);
}

impl<S: Space> Outward<S> for Missed {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, frame: FrameOf<S>, _: AtBody<'_, S, Self, B>) -> FrameOf<S> {
        body.motion(frame).1
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, acceleration, (), ()): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        joint.motion(frame, position, rate, acceleration).1
    }
    fn closing<K: Closing<S>>(
        &mut self,
        closing: &K,
        [side, main]: [FrameOf<S>; 2],
        (.., gaps, turns): AtClosing<'_, S, Self, K>,
    ) {
        let [place, velocity] = closing.residual(&side, &main);
        let residual = if let Level::Place = self.0 { place } else { velocity };
        *gaps = K::Closures::map(&residual, |x| -x);
        *turns = [side.turn, main.turn];
    }
}
