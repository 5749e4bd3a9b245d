//! Steps near places where closures depend on each other.
//!
//! Rounding takes a motion off its closures, and one that is off them turns aside at such a place. So what is lost in a coefficient grows with its
//! order k, as the power k of the time to there: a series tells a radius that ends about there. Steps by it come to land before the place, each half as
//! far from it as the last one, and what closes their ends is divided by that distance. Stages do not go by powers.

use super::TaylorStepper;
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::scalar::{Elementary, Real};
use crate::stepper::displace::mean_square;
use crate::stepper::{ExplicitStepper, MotionIn, Stepper, TimeIn};
use crate::system::SeriesDynamics;
use crate::time::Dop853;
use num_traits::One;

/// What share of what free bodies would yield closures keep where they hold firmly. Where they keep less they depend on each other nearby, and
/// a step has to show that it has not come apart.
pub(super) const NEAR: f64 = 0.1;
/// The largest share at which a step from firm closures comes too near to such a place, whatever the tolerance.
const TOO_NEAR: f64 = 0.03;
/// How long steps by stages are, as a share of one by a series.
const SHORTER: f64 = 0.25;
/// Where a step of a given size is divided so that its stages fall elsewhere.
const DIVISIONS: [f64; 4] = [0.5, 0.6, 0.35, 0.75];

impl<D: SeriesDynamics<L, P>, L, const P: usize> TaylorStepper<D, L, P> {
    /// Closes the end of a step, through gains of its own, as between steps; whether it has not come apart.
    pub(super) fn close(&mut self, past: &MotionIn<D, L>, loads: &L, next: &mut MotionIn<D, L>) -> bool {
        let loose = self.is_loose(next, loads);
        let [too_near, lost] = if loose { self.too_near(next) } else { [false; 2] };
        self.ahead.copy_state(next);
        self.stages.scene.project(next, loads, &mut self.stages.workspace);
        let apart = lost || !self.is_closed(next);
        if apart || too_near {
            let known = self.memory.is_loose(past.time);
            let starts_loose = known.unwrap_or_else(|| self.is_loose(&mut past.clone(), loads));
            if (apart && (loose || starts_loose)) || (too_near && !starts_loose) {
                self.memory.lead_over(past.time, starts_loose);
                return false;
            }
            if known.is_none() {
                self.is_loose(next, loads); // gains are those of the end again
            }
        }
        self.memory.write(past.time, next.time, loose);
        true
    }

    /// Whether closures are all but dependent at a motion, as a sweep there sees it.
    fn is_loose(&mut self, motion: &mut MotionIn<D, L>, loads: &L) -> bool {
        let Motion { time, position, rate, acceleration, .. } = &mut *motion;
        self.stages.scene.accelerations(*time, position, rate, loads, &mut self.stages.workspace, acceleration);
        self.sweeps += 1;
        !self.stages.firm(motion, NEAR)
    }

    /// Whether a step under error control ends so near to a place where closures depend on each other that none goes on from there, if it began
    /// where they are firm; and whether it does wherever it began. A share δ² leaves roundings / δ³ of accelerations, which are to be a tenth of the
    /// tolerance. There are scenes whose closures are loose everywhere, by what bodies weigh: these are not meant.
    fn too_near(&self, next: &MotionIn<D, L>) -> [bool; 2] {
        let (Some(tolerance), real) = (self.asked, TimeIn::<D, L>::of) else { return [false; 2] };
        let share = (TimeIn::<D, L>::EPSILON * real(10.0) / tolerance).powf(real(2.0 / 3.0)).as_f64();
        [share.min(TOO_NEAR), lost::<TimeIn<D, L>>()].map(|least| !self.stages.firm(next, least))
    }

    /// Whether what has closed the end of a step is within the tolerance; of a step of a given size, within what rounding leaves of rates
    /// where closures are all but dependent.
    fn is_closed(&mut self, next: &MotionIn<D, L>) -> bool {
        let ((position, rate, _), one) = (&mut self.sums, TimeIn::<D, L>::one());
        let tolerance = self.asked.unwrap_or_else(|| TimeIn::<D, L>::EPSILON.powf(TimeIn::<D, L>::of(2.0 / 3.0)));
        next.position.apart(&self.ahead.position, position);
        rate.mix_2(&self.zero, (one, &next.rate), (-one, &self.ahead.rate));
        mean_square(next, (position, rate), [tolerance; 2]) <= 1.0
    }

    /// How far a step goes, where the series tells a reach. Where closures are all but dependent and that is a fraction of the step before, it is rounding
    /// that ends it, at tolerances that see rounding in so high orders: then stages lead on, and farther.
    pub(super) fn beyond(
        &mut self,
        past: &MotionIn<D, L>,
        reach: TimeIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> TimeIn<D, L> {
        let fine = tolerance.as_f64() < lost::<TimeIn<D, L>>();
        match self.memory.size_before(past.time).map(|before| before * TimeIn::<D, L>::of(SHORTER)) {
            Some(size) if fine && reach < size && self.memory.is_loose(past.time) == Some(true) => {
                self.memory.lead_over(past.time, true);
                size
            }
            _ => reach,
        }
    }

    /// A step by stages after one of a series that came apart. Under error control it is shorter: those are.
    pub(super) fn take_over(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let share = if self.asked.is_some() { SHORTER } else { 1.0 };
        self.lead(past, loads, dt * TimeIn::<D, L>::of(share), next)
    }

    /// A step by stages.
    pub(super) fn lead(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        (self.begun, self.divided) = (false, false);
        self.stages.begin(past, loads);
        let made = self.stages.make(past, loads, dt, next);
        if self.asked.is_none() {
            self.divide(past, loads, dt, next, made)?;
        } else {
            made?;
            // Error control has steps end elsewhere.
            self.stands(next, lost::<TimeIn<D, L>>())?;
        }
        let loose = !self.stages.firm(next, NEAR);
        self.memory.write(past.time, next.time, loose);
        Ok(())
    }

    /// Makes a step of a given size in two, if one was lost because a stage fell on a place where closures depend on each other.
    fn divide(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
        whole: Result<(), Error>,
    ) -> Result<(), Error> {
        let real = TimeIn::<D, L>::of;
        let Self { stages, ahead, divided, .. } = self;
        // Stages that miss each other by so much, as a share of rates, are astray by a hundredth of it.
        let most = TimeIn::<D, L>::EPSILON.powf(real(0.25));
        let keeps = |stages: &mut ExplicitStepper<D, L, Dop853>, from: &_, dt, to: &_| {
            stages.error(from, dt, to, real(1.0)).is_some_and(|error| error <= most)
        };
        if whole.is_ok() && keeps(stages, past, dt, next) {
            return Ok(());
        }
        let mut makes = |from: &_, dt, to: &mut _| {
            stages.begin(from, loads);
            stages.make(from, loads, dt, to).is_ok() && keeps(stages, from, dt, to)
        };
        for share in DIVISIONS {
            let first = dt * real(share);
            if makes(past, first, ahead) && makes(ahead, dt - first, next) {
                next.time = past.time + dt;
                *divided = true;
                return Ok(());
            }
        }
        whole?;
        for least in [NEAR, 1.0] {
            self.stages.begin(past, loads);
            self.stands(past, least)?;
        }
        Err(Error::new(Fault::NonFiniteMotion).at_time((past.time + dt).as_f64()))
    }

    /// Refuses ends of steps where closures keep no more than a share, as the last sweep saw them.
    fn stands(&self, motion: &MotionIn<D, L>, least: f64) -> Result<(), Error> {
        self.stages.scene.independent(motion, &self.stages.workspace, least, &mut |_, _| ())
    }
}

/// The share of which closures have no more where accelerations are lost in rounding.
fn lost<R: Real>() -> f64 {
    Elementary::sqrt(R::EPSILON).as_f64()
}
