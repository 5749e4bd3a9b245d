//! How a motion is put back where its tip is held, its loops are closed and its joints are coupled.

use super::corrections::{Corrections, MOST_CORRECTIONS};
use crate::element::{Element, Level, Loading, RealOf, Space, Sweep, look};
use crate::ends::{Root, Tip};
use crate::loading::couples;
use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use crate::solve::riccati::{Workspace, correction};
use crate::system::{Elements, MotionOf, RateOf, System, coordinates};

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Puts a motion back where it is closed, and, where loads couple joints, where these hold them: in one correction after the other, through
    /// gains and responses of the last sweeps.
    pub(super) fn project_by<W: Sweep<S, Closures = P::Closures>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &W::Loads,
        workspace: &mut Workspace<S, Elements<S, R, C>, W>,
    ) {
        // A constant, so that a compiler does not even look at what follows where nothing is closed.
        if const { Self::CLOSED == 0 } {
            return;
        }
        // The gains belong to a configuration nearby, so one correction leaves an error of second order: twice. And where loops are
        // nested, an outer one closes by what inner ones miss no more. Near where a loop is straight it takes more of them, and couplings are
        // kept to rounding.
        let settles = const { Self::LOOPED || couples::<S, W::Loads>() };
        let most = if settles { MOST_CORRECTIONS } else { Self::CLOSED };
        let responses = core::mem::take(&mut workspace.responses);
        let mut corrections = Corrections::<S::Scalar>::begin();
        if settles {
            motion.position.visit(&mut |x| corrections.see(x));
        }
        for count in 0..=most {
            if let Some(step) = self.correct(Level::Place, motion, (loads, &responses), workspace) {
                motion.position.displace(step);
                if settles && (corrections.end(step, count >= Self::CLOSED) || corrections.overshoot()) {
                    break;
                }
            }
        }
        if settles && corrections.lead_nowhere() {
            motion.position.replace(&mut |_| S::Scalar::constant(RealOf::<S>::INFINITY));
        }
        // Velocities are linear, but the gains are not of this very place: near where closures depend on each other it takes more than two.
        let mut corrections = Corrections::<S::Scalar>::begin();
        if settles {
            motion.rate.visit(&mut |x| corrections.see(x));
        }
        for count in 1..=most {
            if let Some(step) = self.correct(Level::Velocity, motion, (loads, &responses), workspace) {
                motion.rate.add(step);
                if settles && corrections.end(step, count >= Self::CLOSED) {
                    break;
                }
            }
        }
        workspace.responses = responses;
    }

    /// The correction of positions or of rates, to first order.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub(super) fn correct<'w, W: Sweep<S, Closures = P::Closures>>(
        &self,
        level: Level,
        motion: &MotionOf<S, R, C, P>,
        (loads, responses): (&W::Loads, &<W::Loads as Loading<S>>::Responses<RateOf<S, R, C>>),
        workspace: &'w mut Workspace<S, Elements<S, R, C>, W>,
    ) -> Option<&'w RateOf<S, R, C>> {
        let ([place, velocity], ground) = (self.residual(motion), self.root.ground(motion.time));
        let residual = if let Level::Place = level { place } else { velocity };
        let step = correction(&self.chain, ground, coordinates(motion), level, &residual, workspace)?;
        loads.rejoin(responses, level, (&motion.position, &motion.rate), step);
        Some(step)
    }

    /// Residual of the tip, in place and in velocity.
    pub(super) fn residual(&self, motion: &MotionOf<S, R, C, P>) -> [<P::Closures as Closures>::Each<S::Scalar>; 2] {
        let frame = look(&self.chain, self.root.ground(motion.time), coordinates(motion));
        self.tip.residual(motion.time, &frame)
    }
}
