//! Corrections of joint coordinates that close loops.

use crate::element::{Coordinates, Posture};
use crate::relation::{AccelerationOf, Closures, Looped, Own};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Kept, Mut, Of, Outward, OwnOf, Parallel, PerAxes, Positions, Rates, Ref,
    Shape, Slot, Walk, Way,
};
use crate::space::{FrameOf, Space};
use crate::visit::{Level, look};
use num_traits::Zero;

/// [`respond`](super::respond::respond) where loops are to be closed: each finds the forces that move its ends together by their
/// residual at this motion, for which it looks ahead by a walk of its own. Walks outward with complete kinematics too.
#[allow(clippy::too_many_arguments)] // two walks at once
pub fn restore<S: Space, E: Shape<S>, C: Closures>(
    chain: &E,
    frame: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    level: Level,
    acceleration: AccelerationOf<S>,
    posture: Posture<'_, S, E>,
    kept: &E::Store<Kept<C>>,
    multipliers: C::Each<S::Scalar>,
    correction: &mut E::Store<Rates>,
) {
    let Coordinates { position, rate, acceleration: second } = motion;
    let Posture { x, y, p, q } = posture;
    let mut walk = Restore::<S, C> { level, multipliers };
    chain.outward(&mut walk, (frame, acceleration), (position, rate, second, x, y, p, q, kept, correction));
}

/// Knows what is to be corrected, and the closure forces.
struct Restore<S: Space, C: Closures> {
    level: Level,
    multipliers: C::Each<S::Scalar>,
}

impl<S: Space, C: Closures> Walk<S> for Restore<S, C> {
    type Carried = (FrameOf<S>, AccelerationOf<S>);
    type Stores = (
        Ref<Positions>,
        Ref<Rates>,
        Ref<Rates>,
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<C>>,
        Mut<Rates>,
    );
}

impl<S: Space, C: Closures> Outward<S> for Restore<S, C> {
    type In<Y: Way> = Restore<S, Y::Forces<C>>;

    /// Into an arm that no closure forces reach.
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        go(&mut Restore { level: self.level, multipliers: Y::Forces::<C>::each(|_| S::Scalar::zero()) })
    }
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        (frame, acceleration): (FrameOf<S>, AccelerationOf<S>),
        (_, _, _, x, y, p, q, _, _): AtBody<'_, S, Self, B>,
    ) -> (FrameOf<S>, AccelerationOf<S>) {
        (body.motion(frame).1, body.swung(acceleration, (x, y, p, q)))
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        (frame, acceleration): (FrameOf<S>, AccelerationOf<S>),
        (position, rate, second, x, y, p, q, kept, correction): AtJoint<'_, S, Self, J>,
    ) -> (FrameOf<S>, AccelerationOf<S>) {
        let frame = joint.motion(frame, position, rate, second).1;
        (frame, joint.respond::<C>(acceleration, (x, y, p, q), kept, &self.multipliers, correction))
    }
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        (frame, acceleration): (FrameOf<S>, AccelerationOf<S>),
        stores: Of<'_, S, Self, N>,
    ) -> (FrameOf<S>, AccelerationOf<S>) {
        let (main, side, (_, _, _, _, _, _, _, (gain, _), _)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let in_main = Coordinates::<S, N::Main> { position: main.0, rate: main.1, acceleration: main.2 };
        let in_side = Coordinates::<S, N::Side> { position: side.0, rate: side.1, acceleration: side.2 };
        let (main_end, side_end) = (look(net.main_arm(), frame, in_main), look(net.side_arm(), frame, in_side));
        let [place, velocity] = net.closing_joint().residual(&side_end, &main_end);
        let residual = match self.level {
            Level::Place => place,
            Level::Velocity => velocity,
        };
        let gap = OwnOf::<S, N>::reduced(gain, &residual);
        let forces = OwnOf::<S, N>::forces(gain, |w| w.work(&acceleration), &self.multipliers, &gap);
        let mut walk = Restore::<S, OwnOf<S, N>> { level: self.level, multipliers: forces };
        net.side_arm().outward(&mut walk, (frame, acceleration), side);
        let multipliers = (self.multipliers, forces);
        let mut walk = Restore::<S, Looped<C, OwnOf<S, N>>> { level: self.level, multipliers };
        net.main_arm().outward(&mut walk, (frame, acceleration), main)
    }
}
