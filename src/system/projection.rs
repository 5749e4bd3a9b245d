//! How a motion is put back where its tip is held, its loops are closed and its joints are coupled.

use super::corrections::{Corrections, MOST_CORRECTIONS};
use crate::element::{Close, Condense, Element, Level, Loading, Reading, RealOf, Space, Springs, Sweep, look};
use crate::ends::{Root, Tip};
use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use crate::shape::Kept;
use crate::solve::riccati::{Spring, Workspace, correction, sweep};
use crate::system::{Elements, MotionOf, System, coordinates};
use crate::walks::copy::copy;

/// Turns of closing loops and of joining what is coupled.
const MOST_TURNS: usize = 6;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Puts a motion back where it is closed, and, where loads couple joints, where these hold them, in turns: what the one moves the other one
    /// misses in second order.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub(super) fn project_by<W: Sweep<S, Closures = P::Closures>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        springs: W::Springs,
        loads: &W::Loads,
        workspace: &mut Workspace<S, Elements<S, R, C>, W>,
    ) where
        Elements<S, R, C>: Condense<S, P::Relation, W, Out: Close<S, W::Closures>>,
    {
        self.close_by(motion, workspace);
        if const { !W::Loads::COUPLED || Self::CLOSED == 0 } {
            return;
        }
        let (time, mut zero) = (motion.time, motion.rate.clone());
        zero.replace(&mut |_| S::Scalar::constant(RealOf::<S>::of(0.0)));
        // What joints remember of the sweep before, which is none of those that ask what forces cause.
        let remembered = const { <W::Springs as Springs<S::Scalar>>::STIFF }.then(|| workspace.kept.clone());
        for _ in 0..MOST_TURNS {
            let mut finite = true;
            motion.position.visit(&mut |x| finite &= x.is_finite());
            if !finite {
                break; // closing led nowhere
            }
            let there = loads.rejoined(&mut motion.position, &mut motion.rate, |loads, position, rate, found| {
                let reading = Reading { position, rate, acceleration: &zero };
                let spring = Spring { position, rate, reading, springs };
                sweep(&self.chain, &self.site(time, loads), position, rate, &spring, workspace, found);
            });
            if there {
                break;
            }
            self.close_by(motion, workspace);
        }
        if let Some(remembered) = &remembered {
            copy::<S, _, Kept<W::Closures>>(&self.chain, remembered, &mut workspace.kept);
        }
    }

    /// Puts a motion back where it is closed.
    fn close_by<W: Sweep<S, Closures = P::Closures>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        workspace: &mut Workspace<S, Elements<S, R, C>, W>,
    ) {
        // A constant, so that a compiler does not even look at what follows where nothing is closed.
        if const { Self::CLOSED == 0 } {
            return;
        }
        // The gains belong to a configuration nearby, so one correction leaves an error of second order: twice. And where loops are
        // nested, an outer one closes by what inner ones miss no more. Near where a loop is straight it takes more of them.
        let most = if Self::LOOPED { MOST_CORRECTIONS } else { Self::CLOSED };
        let mut corrections = Corrections::<S::Scalar>::begin();
        if Self::LOOPED {
            motion.position.visit(&mut |x| corrections.see(x));
        }
        for count in 0..=most {
            let [place, _] = self.residual(motion);
            let ground = self.root.ground(motion.time);
            if let Some(step) = correction(&self.chain, ground, coordinates(motion), Level::Place, &place, workspace) {
                motion.position.displace(step);
                if Self::LOOPED && (corrections.end(step, count >= Self::CLOSED) || corrections.overshoot()) {
                    break;
                }
            }
        }
        if Self::LOOPED && corrections.lead_nowhere() {
            motion.position.replace(&mut |_| S::Scalar::constant(RealOf::<S>::INFINITY));
        }
        // Velocities are linear, but the gains are not of this very place: near where closures depend on each other it takes more than two.
        let mut corrections = Corrections::<S::Scalar>::begin();
        if Self::LOOPED {
            motion.rate.visit(&mut |x| corrections.see(x));
        }
        for count in 1..=most {
            let [_, velocity] = self.residual(motion);
            let ground = self.root.ground(motion.time);
            let level = Level::Velocity;
            if let Some(step) = correction(&self.chain, ground, coordinates(motion), level, &velocity, workspace) {
                motion.rate.add(step);
                if Self::LOOPED && corrections.end(step, count >= Self::CLOSED) {
                    break;
                }
            }
        }
    }

    /// Residual of the tip, in place and in velocity.
    pub(super) fn residual(&self, motion: &MotionOf<S, R, C, P>) -> [<P::Closures as Closures>::Each<S::Scalar>; 2] {
        let frame = look(&self.chain, self.root.ground(motion.time), coordinates(motion));
        self.tip.residual(motion.time, &frame)
    }
}
