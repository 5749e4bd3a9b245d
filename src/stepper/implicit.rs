//! Steps by the generalised-α family.

use super::{Method, MotionIn, Stepper, TimeIn};
use crate::element::Implicit;
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::scalar::Real;
use crate::system::Dynamics;
use crate::time::GeneralizedAlpha;
use num_traits::{One, Zero};

/// Steps by a rule of the generalised-α family.
pub struct ImplicitStepper<D: Dynamics<L>, L> {
    rule: GeneralizedAlpha,
    scene: D,
    workspace: D::Workspace,
    stiff: D::StiffWorkspace,
    /// Where the last step ended, and where it started.
    last: Memory<D, L>,
    before: Memory<D, L>,
    /// Where positions and rates would be without the acceleration sought.
    free: (D::Position, D::Rate),
    /// Where the geometry of a sweep is taken.
    at: (D::Position, D::Rate),
    /// Acceleration at the start of the last step.
    first: D::Rate,
    start: Option<MotionIn<D, L>>,
    zero: D::Rate,
    sweeps: usize,
}

/// A motion with its accelerations, the true one and the auxiliary one A; nothing before the first step.
struct Memory<D: Dynamics<L>, L> {
    known: bool,
    time: TimeIn<D, L>,
    position: D::Position,
    rate: D::Rate,
    acceleration: D::Rate,
    auxiliary: D::Rate,
}

impl<D: Dynamics<L>, L> Memory<D, L> {
    /// Whether this is the motion.
    fn is(&self, motion: &MotionIn<D, L>) -> bool {
        self.known
            && self.time == motion.time
            && self.position.all(&motion.position, &mut |a, b| a == b)
            && self.rate.all(&motion.rate, &mut |a, b| a == b)
    }

    /// Remembers where a motion is.
    fn note(&mut self, motion: &MotionIn<D, L>) {
        self.known = true;
        self.time = motion.time;
        self.position.clone_from(&motion.position);
        self.rate.clone_from(&motion.rate);
        self.acceleration.clone_from(&motion.acceleration);
    }
}

impl Method for GeneralizedAlpha {
    type Stepper<D: Dynamics<L>, L> = ImplicitStepper<D, L>;

    fn stepper<D: Dynamics<L>, L>(&self, scene: D) -> ImplicitStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        let place = (still.position.clone(), zero.clone());
        let memory = || Memory {
            known: false,
            time: still.time,
            position: still.position.clone(),
            rate: zero.clone(),
            acceleration: zero.clone(),
            auxiliary: zero.clone(),
        };
        let (last, before) = (memory(), memory());
        ImplicitStepper {
            rule: *self,
            workspace: scene.workspace(),
            stiff: scene.stiff_workspace(),
            last,
            before,
            free: place.clone(),
            at: place,
            first: zero.clone(),
            start: Some(still),
            zero,
            scene,
            sweeps: 0,
        }
    }
}

impl<D: Dynamics<L>, L> ImplicitStepper<D, L> {
    /// Makes `before` the memory of `past`, and says whether there was one.
    ///
    /// A lies at t + (α_m − α_f) h, so it can neither be had from the motion alone nor replaced by the true acceleration: with
    /// that at every step the rule would have order one. Where loads have jumped, A jumps with the true acceleration.
    fn recall(&mut self, past: &MotionIn<D, L>) -> bool {
        if self.last.is(past) {
            core::mem::swap(&mut self.last, &mut self.before);
        }
        self.last.known = false;
        let remembered = self.before.is(past);
        if remembered {
            let (one, terms) = (TimeIn::<D, L>::one(), [&past.acceleration, &self.before.acceleration]);
            self.before.auxiliary.accumulate(&[one, -one], terms);
        } else {
            self.before.auxiliary.clone_from(&past.acceleration);
        }
        self.before.note(past);
        remembered
    }
}

impl<D: Dynamics<L>, L> Stepper<D, L> for ImplicitStepper<D, L> {
    fn step(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        if !(self.start.as_ref().is_some_and(|start| past.fits(start)) && past.fits(next)) {
            return Err(Error::new(Fault::Shape));
        }
        let Some(mut start) = self.start.take() else {
            return Err(Error::new(Fault::Shape)); // never: it is put back below
        };
        start.time = past.time;
        start.position.clone_from(&past.position);
        start.rate.clone_from(&past.rate);
        let Motion { time, position, rate, acceleration, multipliers } = &mut start;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
        let outcome = self.advance(&start, loads, dt, next);
        self.start = Some(start);
        outcome
    }

    fn advance(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let real = TimeIn::<D, L>::of;
        let GeneralizedAlpha { alpha_m, alpha_f, beta, gamma, sweeps } = self.rule;
        for (parameter, value) in [("beta", beta), ("gamma - 1/2 + tiny", gamma - 0.5 + 1e-12)] {
            if value.is_nan() || value <= 0.0 {
                return Err(Error::new(Fault::NotPositive { parameter, value }));
            }
        }
        if !(self.start.as_ref().is_none_or(|start| past.fits(start)) && past.fits(next)) {
            return Err(Error::new(Fault::Shape));
        }
        // A motion that this stepper has not made makes its first step by the trapezoidal rule, which needs no memory.
        let remembered = self.recall(past);
        let (alpha_m, alpha_f, beta, gamma) =
            if remembered || alpha_m == alpha_f { (alpha_m, alpha_f, beta, gamma) } else { (0.0, 0.0, 0.25, 0.5) };
        self.first.clone_from(&past.acceleration);
        // A₁ = κ a₁ + (α_f a₀ − α_m A₀) / (1 − α_m).
        let kappa = (1.0 - alpha_f) / (1.0 - alpha_m);
        let (of_true, of_auxiliary) = (alpha_f / (1.0 - alpha_m), -alpha_m / (1.0 - alpha_m));
        let terms = [&past.acceleration, &self.before.auxiliary];
        let (position, rate) = &mut self.free;
        let square = dt * dt;
        let weights = [real(beta * of_true) * square, real(0.5 - beta + beta * of_auxiliary) * square];
        position.drift(&past.position, dt, &past.rate, &weights, terms);
        let weights = [real(gamma * of_true) * dt, real(1.0 - gamma + gamma * of_auxiliary) * dt];
        rate.combine(&past.rate, &weights, terms);
        let springs = Implicit { position: real(beta * kappa) * square, rate: real(gamma * kappa) * dt };

        next.time = past.time + dt;
        let none = TimeIn::<D, L>::zero();
        // The first geometry is a prediction without accelerations: those of stiff joints are too rough for it.
        self.at.0.drift(&past.position, dt, &past.rate, &[], []);
        self.at.1.combine(&past.rate, &[], []);
        for sweep in 0..sweeps {
            if sweep > 0 {
                let found = [&next.acceleration];
                self.at.0.drift(&self.free.0, none, &self.zero, &[springs.position], found);
                self.at.1.combine(&self.free.1, &[springs.rate], found);
            }
            let (at, free) = ((&self.at.0, &self.at.1), (&self.free.0, &self.free.1));
            let acceleration = &mut next.acceleration;
            next.multipliers =
                self.scene.implicit_accelerations(next.time, at, free, springs, loads, &mut self.stiff, acceleration);
            self.sweeps += 1;
        }
        let found = [&next.acceleration];
        next.position.drift(&self.free.0, none, &self.zero, &[springs.position], found);
        next.rate.combine(&self.free.1, &[springs.rate], found);
        self.scene.project_stiff(next, &mut self.stiff);
        self.last.note(next);
        if remembered {
            let terms = [&next.acceleration, &past.acceleration, &self.before.auxiliary];
            self.last.auxiliary.combine(&self.zero, &[real(kappa), real(of_true), real(of_auxiliary)], terms);
        } else {
            let ahead = real(self.rule.alpha_m - self.rule.alpha_f);
            let terms = [&next.acceleration, &past.acceleration];
            self.last.auxiliary.combine(&next.acceleration, &[ahead, -ahead], terms);
        }
        match self.scene.accept(next) {
            Ok(()) => Ok(()),
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => {
                // The sweeps took place at the end of the step, somewhere near the start.
                let mut end = past.clone();
                if past.is_finite() {
                    end.time = next.time;
                }
                Err(self.scene.diagnose(&end, loads, &mut self.workspace))
            }
            Err(error) => Err(error),
        }
    }

    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        let _ = (past, dt, next, tolerance);
        None
    }

    fn error_order(&self) -> f64 {
        2.0
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
        // Accelerations linear in time between the two ends: third-order positions, at least as good as the rule.
        let real = TimeIn::<D, L>::of;
        let t = theta;
        between.time = past.time + real(theta) * dt;
        let square = dt * dt;
        let weights = [real(t * t / 2.0 - t * t * t / 6.0) * square, real(t * t * t / 6.0) * square];
        let terms = [&self.first, &next.acceleration];
        between.position.drift(&past.position, real(t) * dt, &past.rate, &weights, terms);
        let weights = [real(t - t * t / 2.0) * dt, real(t * t / 2.0) * dt];
        between.rate.combine(&past.rate, &weights, terms);
        let Motion { time, position, rate, acceleration, multipliers } = between;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }
}
