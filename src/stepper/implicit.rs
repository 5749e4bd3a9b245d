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
    /// What is known of the last motion written, and of the one before.
    last: Memory<D, L>,
    before: Memory<D, L>,
    /// Where positions and rates would be without the acceleration sought.
    free: (D::Position, D::Rate),
    /// Where the geometry of a sweep is taken.
    at: (D::Position, D::Rate),
    /// Acceleration at the start of the last step.
    first: D::Rate,
    jump: D::Rate,
    still: MotionIn<D, L>,
    zero: D::Rate,
    sweeps: usize,
}

/// A motion, to be recognised by, and its auxiliary acceleration A; no time before the first step.
struct Memory<D: Dynamics<L>, L> {
    time: Option<TimeIn<D, L>>,
    position: D::Position,
    rate: D::Rate,
    acceleration: D::Rate,
    auxiliary: D::Rate,
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
    fn keep(&mut self, motion: &MotionIn<D, L>, zero: &D::Rate) {
        self.time = Some(motion.time);
        self.position.drift(&motion.position, TimeIn::<D, L>::zero(), zero, &[], []);
        self.rate.combine(&motion.rate, &[], []);
    }
}

impl Method for GeneralizedAlpha {
    type Stepper<D: Dynamics<L>, L> = ImplicitStepper<D, L>;

    fn stepper<D: Dynamics<L>, L>(&self, scene: D) -> ImplicitStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        let place = (still.position.clone(), zero.clone());
        let memory = || Memory {
            time: None,
            position: still.position.clone(),
            rate: zero.clone(),
            acceleration: zero.clone(),
            auxiliary: zero.clone(),
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
            jump: zero.clone(),
            still,
            zero,
            scene,
            sweeps: 0,
        }
    }
}

impl<D: Dynamics<L>, L> ImplicitStepper<D, L> {
    /// Makes `before` the memory of `past`: that of the last step if `past` is where it ended; otherwise A is the true
    /// acceleration, from which it differs by O(h). Where the acceleration has jumped since (with a load), so does A.
    fn recall(&mut self, past: &MotionIn<D, L>) {
        if self.last.is_of(past) {
            core::mem::swap(&mut self.last, &mut self.before);
        } else if !self.before.is_of(past) {
            self.before.keep(past, &self.zero);
            self.before.auxiliary.combine(&self.zero, &[], []);
            self.before.acceleration.combine(&self.zero, &[], []);
        }
        let one = TimeIn::<D, L>::one();
        let Memory { acceleration, auxiliary, .. } = &mut self.before;
        self.jump.combine(auxiliary, &[one, -one], [&self.first, acceleration]);
        auxiliary.combine(&self.jump, &[], []);
        acceleration.combine(&self.first, &[], []);
        self.last.time = None;
    }

    /// Refuses motions of another scene.
    fn fits(&self, past: &MotionIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        if past.fits(&self.still) && past.fits(next) { Ok(()) } else { Err(Error::new(Fault::Shape)) }
    }

    /// The step from the accelerations in `first`.
    fn make(
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
        self.recall(past);
        // A₁ = κ a₁ + (α_f a₀ − α_m A₀) / (1 − α_m).
        let kappa = (1.0 - alpha_f) / (1.0 - alpha_m);
        let (of_true, of_auxiliary) = (alpha_f / (1.0 - alpha_m), -alpha_m / (1.0 - alpha_m));
        let terms = [&self.first, &self.before.auxiliary];
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
        self.last.keep(next, &self.zero);
        self.last.acceleration.combine(&next.acceleration, &[], []);
        let terms = [&next.acceleration, &self.first, &self.before.auxiliary];
        let weights = [real(kappa), real(of_true), real(of_auxiliary)];
        self.last.auxiliary.combine(&self.zero, &weights, terms);
        match self.scene.accept(next) {
            Ok(()) => Ok(()),
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => Err(self.diagnose(past, loads, dt)),
            Err(error) => Err(error),
        }
    }

    /// Finds where a step went wrong: at its start, or at its end.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        let mut stage = past.clone();
        stage.acceleration.clone_from(&self.first);
        if stage.is_finite() {
            stage.time = past.time + dt;
        }
        self.scene.diagnose(&stage, loads, &mut self.workspace)
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
        self.fits(past, next)?;
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
        self.fits(past, next)?;
        self.first.combine(&past.acceleration, &[], []); // a copy that allocates nothing
        self.make(past, loads, dt, next)
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
