//! Whether the closures of loops hold independently of each other.

use super::measure::yields;
use crate::element::Coordinates;
use crate::error::{Error, Fault};
use crate::relation::{Closures, Own, Solvable};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Kept, Main, Of, Outward, OwnOf, Parallel, Positions, Rates, Ref, Shape,
    Side, Slot, Walk, Way,
};
use crate::space::{FrameOf, Space};
use core::marker::PhantomData;

/// Walks outward with complete kinematics; where closures of a loop need not hold independently of each other, tells stations and names
/// of forces that the motion does not decide. What has the `least` share of its measure left depends on others, too.
///
/// # Errors
/// [`Fault::RedundantClosures`] where they have to and do not, as the last sweep saw it.
pub fn independent<S: Space, E: Shape<S>, C: Closures>(
    chain: &E,
    frame: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    kept: &E::Store<Kept<C>>,
    least: f64,
    report: &mut impl FnMut(usize, &'static str),
) -> Result<(), Error> {
    let Coordinates { position, rate, acceleration } = motion;
    let said = Said { met: 0, outcome: Ok(()) };
    let mut walk = Independent::<_, C> { said, least, report: Some(report), closures: PhantomData };
    chain.outward(&mut walk, frame, (position, rate, acceleration, kept));
    walk.said.outcome
}

/// Stations met, and what was found there.
#[derive(Clone, Copy)]
struct Said {
    met: usize,
    outcome: Result<(), Error>,
}

/// Tells of closures where `C` act on the chain.
struct Independent<'t, F, C> {
    said: Said,
    least: f64,
    /// Lent to the walk of an arm while that is under way.
    report: Option<&'t mut F>,
    closures: PhantomData<C>,
}

impl<S: Space, F: FnMut(usize, &'static str), C: Closures> Walk<S> for Independent<'_, F, C> {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>, Ref<Kept<C>>);
}

impl<'t, S: Space, F: FnMut(usize, &'static str), C: Closures> Outward<S> for Independent<'t, F, C> {
    type In<Y: Way> = Independent<'t, F, Y::Forces<C>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        let Self { said, least, .. } = *self;
        let mut arm = Independent { said, least, report: self.report.take(), closures: PhantomData };
        let out = go(&mut arm);
        (self.said, self.report) = (arm.said, arm.report);
        out
    }
    fn body<B: Body<S>>(&mut self, body: &B, frame: FrameOf<S>, _: AtBody<'_, S, Self, B>) -> FrameOf<S> {
        self.said.met += 1;
        body.motion(frame).1
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, acceleration, _): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        self.said.met += 1;
        joint.motion(frame, position, rate, acceleration).1
    }
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let (main, side, (_, _, _, (gain, _))) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let in_main = Coordinates::<S, N::Main> { position: main.0, rate: main.1, acceleration: main.2 };
        let in_side = Coordinates::<S, N::Side> { position: side.0, rate: side.1, acceleration: side.2 };
        let end = Outward::<S>::enter::<Main<OwnOf<S, N>>, _>(self, |walk| net.main_arm().outward(walk, frame, main));
        Outward::<S>::enter::<Side<OwnOf<S, N>>, _>(self, |walk| net.side_arm().outward(walk, frame, side));
        let (station, closing) = (self.said.met, net.closing_joint());
        self.said.met += 1;
        if self.said.outcome.is_err() {
            return end;
        }
        let open = OwnOf::<S, N>::undetermined(gain);
        OwnOf::<S, N>::zip(&open, &closing.names(), |open, name| {
            if let (true, Some(report)) = (open, &mut self.report) {
                report(station, name);
            }
        });
        let measure = yields(net, frame, in_main, in_side);
        if let Some((row, independent)) = OwnOf::<S, N>::dependent(gain.compliance(), &measure, self.least) {
            let (mut closure, mut number) = ("", 0);
            OwnOf::<S, N>::map(&closing.names(), |name| {
                if number == row {
                    closure = name;
                }
                number += 1;
            });
            let of = OwnOf::<S, N>::COUNT;
            let error = Error::new(Fault::RedundantClosures { closure, independent, of });
            self.said.outcome = Err(error.at_station(station));
        }
        end
    }
}
