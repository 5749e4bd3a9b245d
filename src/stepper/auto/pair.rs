//! Runge-Kutta steps or series, as loads and tolerance have it.

use super::Chosen;
use super::single::Single;
use crate::error::Error;
use crate::stepper::{ExplicitStepper, Method, MotionIn, Stepper, TaylorMemory, TaylorStepper, TimeIn};
use crate::system::SeriesDynamics;
use crate::time::{Dop853, Taylor};

/// From this tolerance on series of functions of time are dearer than stages of `Dop853`; those of laws that are not linear and
/// of loads that depend on motion are at any.
const COARSE: f64 = 1e-10;

/// Steps by [`Dop853`] or by series of orders up to `P`: by the latter, but under efforts that are functions of time at coarse tolerances.
pub struct PairStepper<D: SeriesDynamics<L, P>, L, const P: usize> {
    series: TaylorStepper<D, L, P>,
    staged: bool,
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> PairStepper<D, L, P> {
    /// A stepper for a scene.
    pub(super) fn of(scene: D) -> Self {
        Self { series: Taylor.stepper(scene), staged: false }
    }
}

/// Calls the stepper that makes the steps.
macro_rules! of {
    ($self:ident, |$stepper:ident| $call:expr) => {
        if $self.staged {
            let $stepper = &mut $self.series.stages;
            $call
        } else {
            let $stepper = &mut $self.series;
            $call
        }
    };
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Stepper<D, L> for PairStepper<D, L, P> {
    const SETTLED: bool = false;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.series.admit(past, loads, dt, next)
    }
    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        of!(self, |stepper| stepper.begin(past, loads));
    }
    fn resume(&mut self, past: &MotionIn<D, L>) {
        of!(self, |stepper| stepper.resume(past));
    }
    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        of!(self, |stepper| stepper.make(past, loads, dt, next))
    }
    fn propose(&mut self, past: &MotionIn<D, L>, loads: &L, tolerance: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        of!(self, |stepper| stepper.propose(past, loads, tolerance))
    }
    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        of!(self, |stepper| stepper.error(past, dt, next, tolerance))
    }
    fn error_order(&self) -> usize {
        if self.staged { self.series.stages.error_order() } else { self.series.error_order() }
    }
    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        if self.staged { self.series.stages.firm(next, least) } else { self.series.firm(next, least) }
    }
    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        of!(self, |stepper| stepper.interpolate(past, loads, dt, next, theta, between));
    }
    fn sweeps(&self) -> usize {
        self.series.sweeps()
    }

    type Memory = ();

    fn memory(&self) {}
    fn restore(&mut self, (): &()) {}
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Single<D, L> for PairStepper<D, L, P> {
    fn chosen(tolerance: Option<f64>) -> Chosen {
        let coarse = tolerance.is_some_and(|tolerance| tolerance >= COARSE);
        let staged = const { !D::LINEAR } || const { D::OVER_TIME } && coarse;
        if staged { Chosen::Dop853 } else { Chosen::Taylor }
    }
    fn leaves_to_multistep(coordinates: usize, tolerance: Option<f64>) -> bool {
        match Self::chosen(tolerance) {
            Chosen::Dop853 => ExplicitStepper::<D, L, Dop853>::leaves_to_multistep(coordinates, tolerance),
            _ => TaylorStepper::<D, L, P>::leaves_to_multistep(coordinates, tolerance),
        }
    }
    fn makes(chosen: Chosen) -> bool {
        chosen == Chosen::Taylor || ((D::OVER_TIME || !D::LINEAR) && chosen == Chosen::Dop853)
    }
    fn carried(&self) -> TaylorMemory<TimeIn<D, L>> {
        self.series.memory()
    }
    fn carry(&mut self, memory: &TaylorMemory<TimeIn<D, L>>) {
        self.series.restore(memory);
    }
    fn take(&mut self, chosen: Chosen) {
        self.staged = chosen == Chosen::Dop853;
    }
    fn limited(&mut self, next: &MotionIn<D, L>, dt: TimeIn<D, L>, fastest: Option<f64>, room: &mut D::Rate) -> bool {
        of!(self, |stepper| stepper.limited(next, dt, fastest, room))
    }
}
