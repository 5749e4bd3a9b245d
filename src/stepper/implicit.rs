//! Steps by the generalised-α family.

mod memory;

pub use self::memory::ImplicitMemory;

use self::memory::Trace;
use super::displace::mean_square;
use super::{Method, MotionIn, Stepper, TimeIn, check, of_prediction};
use crate::element::{Implicit, Reading};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Elementary, Real};
use crate::system::StiffDynamics;
use crate::time::GeneralizedAlpha;
use num_traits::{One, Zero};

/// Steps longer than the one before by this factor are no rounding.
const GROWTH: f64 = 1.01;

/// Steps by a rule of the generalised-α family.
pub struct ImplicitStepper<D: StiffDynamics<L>, L> {
    rule: GeneralizedAlpha,
    scene: D,
    workspace: D::Workspace,
    stiff: D::StiffWorkspace,
    /// What joints keep of the step, while others are looked at within it.
    kept: D::Gains,
    /// What is known of the last motion written, and of the one before.
    last: Trace<TimeIn<D, L>, D::Position, D::Rate>,
    before: Trace<TimeIn<D, L>, D::Position, D::Rate>,
    /// Where positions and rates would be without the acceleration sought.
    free: (D::Position, D::Rate),
    /// Where the geometry of a sweep is taken.
    at: (D::Position, D::Rate),
    /// True and auxiliary acceleration at the start of the last step.
    first: D::Rate,
    auxiliary: D::Rate,
    /// Outcome of the last sweep but one, and by how much the last sweep of the last step changed it.
    earlier: D::Rate,
    change: D::Rate,
    /// Room for estimates of errors.
    estimate: (D::Rate, D::Rate),
    /// Whether the step is longer than the one before.
    grows: bool,
    still: MotionIn<D, L>,
    zero: D::Rate,
    sweeps: usize,
}

impl<D: StiffDynamics<L>, L> Method<D, L> for GeneralizedAlpha {
    type Stepper = ImplicitStepper<D, L>;

    fn stepper(&self, scene: D) -> ImplicitStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        let place = (still.position.clone(), zero.clone());
        let trace = || Trace {
            time: None,
            position: still.position.clone(),
            rate: zero.clone(),
            offset: zero.clone(),
            size: TimeIn::<D, L>::one(),
            change: zero.clone(),
        };
        let stiff = scene.stiff_workspace();
        ImplicitStepper {
            rule: *self,
            workspace: scene.workspace(),
            kept: scene.gains(&stiff).clone(),
            stiff,
            last: trace(),
            before: trace(),
            free: place.clone(),
            at: place,
            first: zero.clone(),
            auxiliary: zero.clone(),
            earlier: zero.clone(),
            change: zero.clone(),
            estimate: (zero.clone(), zero.clone()),
            grows: false,
            still,
            zero,
            scene,
            sweeps: 0,
        }
    }
}

impl<D: StiffDynamics<L>, L> ImplicitStepper<D, L> {
    /// Makes `before` the trace of `past`: that of the last step if `past` is where it ended; otherwise A is the true
    /// acceleration, from which it differs by O(h). Where the acceleration has jumped since (with a load), so does A.
    fn recall(&mut self, past: &MotionIn<D, L>, dt: TimeIn<D, L>) {
        let is = |trace: &Trace<TimeIn<D, L>, D::Position, D::Rate>| {
            trace.time.is_some_and(|time| past.has_state(time, &trace.position, &trace.rate))
        };
        if is(&self.last) {
            core::mem::swap(&mut self.last, &mut self.before);
        } else if !is(&self.before) {
            self.before.keep(past, dt, &self.zero);
            self.before.offset.set(&self.zero);
            self.before.change.set(&self.zero);
        }
        self.last.time = None;
        self.grows = dt > self.before.size * TimeIn::<D, L>::of(GROWTH);
    }

    /// The step from the accelerations in `first` and the trace of `past`, and nothing else: it changes neither.
    fn leap(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &mut MotionIn<D, L>) {
        let real = TimeIn::<D, L>::of;
        let GeneralizedAlpha { beta, gamma, sweeps, .. } = self.rule;
        // A is the acceleration at a time apart by a share of the step; another size of step needs another one. What is left in it of earlier
        // steps changes sign from step to step and would outgrow the rest where these become longer: then it is made anew.
        let Trace { offset, size, change, .. } = &self.before;
        let share = dt / *size;
        if self.grows {
            self.auxiliary.mix_1(&self.first, (share * real(self.rule.lead()), change));
        } else {
            self.auxiliary.mix_1(&self.first, (share, offset));
        }
        let [kappa, of_true, of_auxiliary] = self.rule.recurrence();
        let Self { first, auxiliary, .. } = self;
        let (position, rate) = &mut self.free;
        let square = dt * dt;
        let [u, v] = [real(beta * of_true) * square, real(0.5 - beta + beta * of_auxiliary) * square];
        position.drift_2(&past.position, (dt, &past.rate), (u, first), (v, auxiliary));
        let [u, v] = [real(gamma * of_true) * dt, real(1.0 - gamma + gamma * of_auxiliary) * dt];
        rate.mix_2(&past.rate, (u, first), (v, auxiliary));
        let springs = Implicit { position: real(beta * kappa) * square, rate: real(gamma * kappa) * dt };

        next.time = past.time + dt;
        let none = TimeIn::<D, L>::zero();
        // The first geometry is a prediction without accelerations: those of stiff joints are too rough for it.
        self.at.0.drift_0(&past.position, (dt, &past.rate));
        self.at.1.set(&past.rate);
        for sweep in 0..sweeps {
            if sweep > 0 {
                let found = &next.acceleration;
                self.at.0.drift_1(&self.free.0, (none, &self.zero), (springs.position, found));
                self.at.1.mix_1(&self.free.1, (springs.rate, found));
            }
            if !D::LINEAR || sweep + 1 == sweeps {
                self.earlier.set(&next.acceleration);
            }
            let (at, free) = ((&self.at.0, &self.at.1), (&self.free.0, &self.free.1));
            // Laws that are not linear are read where the last sweep has led.
            let reading = if D::LINEAR || sweep == 0 {
                Reading { position: free.0, rate: free.1, acceleration: &self.zero }
            } else {
                Reading { position: at.0, rate: at.1, acceleration: &self.earlier }
            };
            let (found, stiff) = (&mut next.acceleration, &mut self.stiff);
            next.multipliers =
                self.scene.implicit_accelerations(next.time, at, free, reading, springs, loads, stiff, found);
            self.sweeps += 1;
        }
        let found = &next.acceleration;
        next.position.drift_1(&self.free.0, (none, &self.zero), (springs.position, found));
        next.rate.mix_1(&self.free.1, (springs.rate, found));
        self.scene.project_stiff(next, loads, &mut self.stiff);
    }

    /// Finds where a step went wrong: at its start, or where its first geometry is taken.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        // Joints may remember accelerations of the sweeps that failed.
        self.stiff = self.scene.stiff_workspace();
        let mut stage = past.clone();
        stage.acceleration.clone_from(&self.first);
        of_prediction(&self.scene, stage, loads, dt, &mut self.workspace)
    }
}

impl<D: StiffDynamics<L>, L> Stepper<D, L> for ImplicitStepper<D, L> {
    const SETTLED: bool = false;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        check::<D, L>(&self.still, past, next, dt)?;
        self.rule.fault.map_or(Ok(()), |fault| Err(Error::new(fault)))?; // parameters that make no rule
        self.scene.admits(loads)
    }

    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        let first = &mut self.first;
        self.scene.accelerations(past.time, &past.position, &past.rate, loads, &mut self.workspace, first);
        self.sweeps += 1;
    }

    fn resume(&mut self, past: &MotionIn<D, L>) {
        self.first.set(&past.acceleration);
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.recall(past, dt);
        self.leap(past, loads, dt, next);
        let (real, one) = (TimeIn::<D, L>::of, TimeIn::<D, L>::one());
        // With a single sweep there is nothing to compare it with.
        let compared = if self.rule.sweeps > 1 { one } else { TimeIn::<D, L>::zero() };
        self.change.mix_2(&self.zero, (compared, &next.acceleration), (-compared, &self.earlier));
        self.last.keep(next, dt, &self.zero);
        let [kappa, of_true, of_auxiliary] = self.rule.recurrence();
        let found = (real(kappa - 1.0), &next.acceleration);
        let [first, auxiliary] = [(real(of_true), &self.first), (real(of_auxiliary), &self.auxiliary)];
        self.last.offset.mix_3(&self.zero, found, first, auxiliary);
        self.last.change.mix_2(&self.zero, (one, &next.acceleration), (-one, &self.first));
        match self.scene.accept(next) {
            Err(Error { fault: Fault::NonFiniteMotion, .. }) => Err(self.diagnose(past, loads, dt)),
            outcome => outcome,
        }
    }

    /// The change that the last sweep made (geometry), and the change of the acceleration during the step (truncation).
    fn error(
        &mut self,
        _: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        let real = TimeIn::<D, L>::of;
        let (position, rate) = &mut self.estimate;
        let square = dt * dt;
        let [kappa, ..] = self.rule.recurrence();
        position.mix_1(&self.zero, (real(self.rule.beta * kappa) * square, &self.change));
        let geometry = mean_square(next, (position, &self.zero), [tolerance; 2]);
        let [of_position, of_rate] = self.rule.truncation().map(real);
        let (forth, back) = (of_position * square, of_rate * dt);
        position.mix_2(&self.zero, (forth, &next.acceleration), (-forth, &self.first));
        rate.mix_2(&self.zero, (back, &next.acceleration), (-back, &self.first));
        let truncation = mean_square(next, (position, rate), [tolerance; 2]);
        Some(real(geometry).sqrt() + real(truncation).sqrt())
    }

    fn error_order(&self) -> usize {
        if self.rule.truncation()[1] == 0.0 { 3 } else { 2 }
    }

    /// A step of the share `theta`: as good as the rule at any stiffness, where an interpolation would strain stiff springs.
    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        _: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        self.scene.copy_gains(self.scene.gains(&self.stiff), &mut self.kept);
        self.leap(past, loads, TimeIn::<D, L>::of(theta) * dt, between);
        core::mem::swap(self.scene.gains_mut(&mut self.stiff), &mut self.kept);
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }

    type Memory = ImplicitMemory<Trace<TimeIn<D, L>, D::Position, D::Rate>, D::Gains>;

    fn memory(&self) -> Self::Memory {
        let traces = [self.last.clone(), self.before.clone()];
        ImplicitMemory { traces, gains: self.scene.gains(&self.stiff).clone() }
    }

    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        let fits = |trace: &Trace<TimeIn<D, L>, D::Position, D::Rate>| {
            motion.position.all(&trace.position, &mut |_, _| true)
                && [&trace.rate, &trace.offset, &trace.change]
                    .iter()
                    .all(|rate| motion.rate.all(rate, &mut |_, _| true))
        };
        memory.traces.iter().all(fits) && self.scene.gains_fit(&memory.gains)
    }

    fn restore(&mut self, memory: &Self::Memory) {
        let [last, before] = &memory.traces;
        self.last.clone_from(last);
        self.before.clone_from(before);
        self.scene.copy_gains(&memory.gains, self.scene.gains_mut(&mut self.stiff));
    }

    fn restart(&mut self) {
        (self.last.time, self.before.time) = (None, None);
    }
}
