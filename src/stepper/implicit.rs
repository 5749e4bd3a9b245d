//! Steps by the generalised-α family.

use super::displace::mean_square;
use super::{Method, MotionIn, Stepper, TimeIn, check};
use crate::element::{Implicit, Reading};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::system::{Dynamics, StiffDynamics};
use crate::time::GeneralizedAlpha;
use num_traits::{One, Zero};

/// Steps by a rule of the generalised-α family.
pub struct ImplicitStepper<D: StiffDynamics<L>, L> {
    rule: GeneralizedAlpha,
    scene: D,
    workspace: D::Workspace,
    stiff: D::StiffWorkspace,
    /// What is known of the last motion written, and of the one before.
    last: Memory<D, L>,
    before: Memory<D, L>,
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
    still: MotionIn<D, L>,
    zero: D::Rate,
    sweeps: usize,
}

/// A motion, to be recognised by, and how far its auxiliary acceleration A is from the true one; no time before the first step.
struct Memory<D: Dynamics<L>, L> {
    time: Option<TimeIn<D, L>>,
    position: D::Position,
    rate: D::Rate,
    /// A − a, and the size (s) of the step that left it: it grows with the size.
    offset: D::Rate,
    size: TimeIn<D, L>,
}

impl<D: Dynamics<L>, L> Memory<D, L> {
    /// Whether it is of this motion.
    fn is_of(&self, motion: &MotionIn<D, L>) -> bool {
        let mut same = |a, b| a == b;
        self.time == Some(motion.time)
            && self.position.all(&motion.position, &mut same)
            && self.rate.all(&motion.rate, &mut same)
    }

    /// Keeps a motion, without its accelerations.
    fn keep(&mut self, motion: &MotionIn<D, L>, size: TimeIn<D, L>, zero: &D::Rate) {
        self.time = Some(motion.time);
        self.position.drift_0(&motion.position, (TimeIn::<D, L>::zero(), zero));
        self.rate.set(&motion.rate);
        self.size = size;
    }
}

impl<D: StiffDynamics<L>, L> Method<D, L> for GeneralizedAlpha {
    type Stepper = ImplicitStepper<D, L>;

    fn stepper(&self, scene: D) -> ImplicitStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        let place = (still.position.clone(), zero.clone());
        let memory = || Memory {
            time: None,
            position: still.position.clone(),
            rate: zero.clone(),
            offset: zero.clone(),
            size: TimeIn::<D, L>::one(),
        };
        ImplicitStepper {
            rule: *self,
            workspace: scene.workspace(),
            stiff: scene.stiff_workspace(),
            last: memory(),
            before: memory(),
            free: place.clone(),
            at: place,
            first: zero.clone(),
            auxiliary: zero.clone(),
            earlier: zero.clone(),
            change: zero.clone(),
            estimate: (zero.clone(), zero.clone()),
            still,
            zero,
            scene,
            sweeps: 0,
        }
    }
}

impl<D: StiffDynamics<L>, L> ImplicitStepper<D, L> {
    /// Makes `before` the memory of `past`: that of the last step if `past` is where it ended; otherwise A is the true
    /// acceleration, from which it differs by O(h). Where the acceleration has jumped since (with a load), so does A.
    fn recall(&mut self, past: &MotionIn<D, L>, dt: TimeIn<D, L>) {
        if self.last.is_of(past) {
            core::mem::swap(&mut self.last, &mut self.before);
        } else if !self.before.is_of(past) {
            self.before.keep(past, dt, &self.zero);
            self.before.offset.set(&self.zero);
        }
        self.last.time = None;
    }

    /// The step from the accelerations in `first` and the memory of `past`, and nothing else: it changes neither.
    fn leap(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &mut MotionIn<D, L>) {
        let real = TimeIn::<D, L>::of;
        let GeneralizedAlpha { beta, gamma, sweeps, .. } = self.rule;
        // A is the acceleration at a time apart by a share of the step; another size of step needs another one.
        self.auxiliary.mix_1(&self.first, (dt / self.before.size, &self.before.offset));
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
            if sweep + 1 == sweeps {
                self.earlier.set(&next.acceleration);
            }
            let (at, free) = ((&self.at.0, &self.at.1), (&self.free.0, &self.free.1));
            let reading = Reading { position: free.0, rate: free.1, acceleration: &self.zero };
            let (found, stiff) = (&mut next.acceleration, &mut self.stiff);
            next.multipliers =
                self.scene.implicit_accelerations(next.time, at, free, reading, springs, loads, stiff, found);
            self.sweeps += 1;
        }
        let found = &next.acceleration;
        next.position.drift_1(&self.free.0, (none, &self.zero), (springs.position, found));
        next.rate.mix_1(&self.free.1, (springs.rate, found));
        self.scene.project_stiff(next, &mut self.stiff);
    }

    /// The step from the accelerations in `first`, remembered.
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
        match self.scene.accept(next) {
            Err(Error { fault: Fault::NonFiniteMotion, .. }) => Err(self.diagnose(past, loads, dt)),
            outcome => outcome,
        }
    }

    /// Refuses motions of another scene, steps that are none, and parameters that make no rule.
    fn check(&self, past: &MotionIn<D, L>, next: &MotionIn<D, L>, dt: TimeIn<D, L>) -> Result<(), Error> {
        check::<D, L>(&self.still, past, next, dt)?;
        self.rule.fault.map_or(Ok(()), |fault| Err(Error::new(fault)))
    }

    /// Finds where a step went wrong: at its start, or at its end.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        // Joints may remember accelerations of the sweeps that failed.
        self.stiff = self.scene.stiff_workspace();
        let mut stage = past.clone();
        stage.acceleration.clone_from(&self.first);
        if stage.is_finite() {
            stage.time = past.time + dt;
        }
        self.scene.diagnose(&stage, loads, &mut self.workspace)
    }
}

impl<D: StiffDynamics<L>, L> Stepper<D, L> for ImplicitStepper<D, L> {
    const SETTLED: bool = false;

    fn step(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.check(past, next, dt)?;
        let first = &mut self.first;
        self.scene.accelerations(past.time, &past.position, &past.rate, loads, &mut self.workspace, first);
        self.sweeps += 1;
        self.make(past, loads, dt, next)
    }

    fn advance(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.check(past, next, dt)?;
        self.first.set(&past.acceleration);
        self.make(past, loads, dt, next)
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
        let geometry = mean_square(next, (position, &self.zero), tolerance);
        let [of_position, of_rate] = self.rule.truncation().map(real);
        let (forth, back) = (of_position * square, of_rate * dt);
        position.mix_2(&self.zero, (forth, &next.acceleration), (-forth, &self.first));
        rate.mix_2(&self.zero, (back, &next.acceleration), (-back, &self.first));
        let truncation = mean_square(next, (position, rate), tolerance);
        Some(real(geometry).sqrt() + real(truncation).sqrt())
    }

    fn error_order(&self) -> f64 {
        if self.rule.truncation()[1] == 0.0 { 3.0 } else { 2.0 }
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
        self.leap(past, loads, TimeIn::<D, L>::of(theta) * dt, between);
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }
}
