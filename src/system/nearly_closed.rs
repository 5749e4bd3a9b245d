//! What a run may begin with: tips and loops that are nearly closed, and rates that they allow.

use crate::element::{Element, Level, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate, let_all_go};
use crate::scalar::{Real, Scalar};
use crate::system::{Dynamics, MotionOf, PositionOf, Runs, System};
use num_traits::{One, Zero};

/// The longest correction of a coordinate (rad, m) that a run may begin with.
const NEAR: f64 = 0.1;
/// The share of it that the next one has at most.
const NEARER: f64 = 0.1;
/// Up to such a share of the largest, or of one (rad/s, m/s), rates may miss what closures allow, which the first step closes: so that small changes of a
/// start, as of lengths and in differences, are what they are in gradients, which go through that step.
const MISSED: f64 = 1e-2;
/// Corrections of rates, of which the first but for rounding does.
const CORRECTIONS: usize = 3;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Refuses a motion that steps would not close but by a jump: whose correction is large, or leads to another that is not much smaller.
    pub(crate) fn nearly_closed<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let (mut now, mut steps) = (Self::loose(motion), [RealOf::<S>::zero(); 2]);
        for step in &mut steps {
            if self.accelerate(&mut now, loads, workspace).is_err() {
                *step = RealOf::<S>::INFINITY;
                continue;
            }
            let mut corrected = now.clone();
            self.project(&mut corrected, loads, workspace);
            *step = self.correction(&now, &corrected);
            now = corrected;
        }
        let [first, second] = steps;
        let [near, nearer] = [NEAR, NEARER].map(RealOf::<S>::of);
        if first <= Self::tolerances().0 || (first <= near && second <= first * nearer) {
            return self.closes(&now);
        }
        Err(self.not_assembled(motion, Level::Place))
    }

    /// Refuses rates that closures do not allow, by more than what the first step closes.
    pub(crate) fn led(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        let (residual, _) = self.largest_residual(motion, Level::Velocity);
        let mut largest = RealOf::<S>::one();
        motion.rate.visit(&mut |rate| largest = largest.max(rate.real().abs()));
        if residual <= RealOf::<S>::of(MISSED) * largest {
            return Ok(());
        }
        Err(self.not_assembled(motion, Level::Velocity))
    }

    /// Says where a motion misses closures most, and by how much.
    fn not_assembled(&self, motion: &MotionOf<S, R, C, P>, level: Level) -> Error {
        let (residual, place) = self.largest_residual(motion, level);
        Error::new(Fault::NotAssembled { residual: residual.as_f64() }).at(place).at_time(motion.time.as_f64())
    }

    /// Takes rates that closures do not allow to the nearest that they do, by the inertia of the scene: as a first step of no size would.
    pub(crate) fn lead<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        for _ in 0..CORRECTIONS {
            if self.led(motion).is_ok() {
                break;
            }
            let mut now = Self::loose(motion);
            self.accelerate(&mut now, loads, workspace)?;
            self.project(&mut now, loads, workspace);
            motion.rate.set(&now.rate);
        }
        Ok(())
    }

    /// A motion with all joints let go: those that stick do not yield to corrections.
    fn loose(motion: &MotionOf<S, R, C, P>) -> MotionOf<S, R, C, P> {
        let mut loose = motion.clone();
        if const { PositionOf::<S, R, C>::MODES } {
            let_all_go(&mut loose.position, &mut loose.rate, &loose.acceleration);
        }
        loose
    }
}
