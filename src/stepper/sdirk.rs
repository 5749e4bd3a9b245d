//! Steps by a singly diagonally implicit Runge-Kutta method.

mod estimate;

use super::displace::{displace, gather, mean_square};
use super::{Method, MotionIn, Stepper, TimeIn, check, of_stage};
use crate::element::{Implicit, Reading};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::{Elementary, Real};
use crate::system::StiffDynamics;
use crate::time::Sdirk4;
use crate::time::sdirk4::{ERROR, GAMMA, STAGES, TABLE};
use num_traits::Zero;

/// Steps by [`Sdirk4`].
///
/// A step needs no accelerations of its start: [`step`](Stepper::step) and [`advance`](Stepper::advance) do the same.
pub struct SdirkStepper<D: StiffDynamics<L>, L> {
    rule: Sdirk4,
    pub(super) scene: D,
    workspace: D::Workspace,
    pub(super) stiff: D::StiffWorkspace,
    /// What joints keep of the step, while others are looked at within it.
    pub(super) kept: D::Gains,
    /// Accelerations of the stages.
    pub(super) slopes: [D::Rate; STAGES],
    /// Where positions and rates of a stage would be without its acceleration.
    pub(super) free: (D::Position, D::Rate),
    /// Where the geometry of a sweep is taken.
    at: (D::Position, D::Rate),
    /// The acceleration that led there, where something is read there.
    pub(super) led: D::Rate,
    still: MotionIn<D, L>,
    pub(super) zero: D::Rate,
    /// Room for increments of positions.
    pub(super) room: D::Rate,
    /// Estimated errors of the last step, in positions and in rates.
    estimate: (D::Rate, D::Rate),
    /// The least and the largest accelerations of the stages.
    range: (D::Rate, D::Rate),
    /// What steps are controlled by, if they are.
    tolerance: Option<TimeIn<D, L>>,
    pub(super) sweeps: usize,
}

impl<D: StiffDynamics<L>, L> Method<D, L> for Sdirk4 {
    type Stepper = SdirkStepper<D, L>;

    fn stepper(&self, scene: D) -> SdirkStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        let place = (still.position.clone(), zero.clone());
        let stiff = scene.stiff_workspace();
        SdirkStepper {
            rule: *self,
            workspace: scene.workspace(),
            kept: scene.gains(&stiff).clone(),
            stiff,
            slopes: core::array::from_fn(|_| zero.clone()),
            free: place.clone(),
            at: place,
            led: zero.clone(),
            room: zero.clone(),
            estimate: (zero.clone(), zero.clone()),
            range: (zero.clone(), zero.clone()),
            zero,
            scene,
            still,
            tolerance: None,
            sweeps: 0,
        }
    }
}

impl<D: StiffDynamics<L>, L> SdirkStepper<D, L> {
    /// Whether laws are read where the last sweep has led. Linear ones need not be.
    const FOLLOWS: bool = D::Position::CURVED || !D::LINEAR;

    /// Solves a stage: its accelerations become slopes, its place and rates stand in `at`, its time and closure forces in
    /// `next`.
    fn solve(&mut self, stage: usize, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &mut MotionIn<D, L>) {
        let real = TimeIn::<D, L>::of;
        let node = TABLE.nodes[stage];
        let weights = (&TABLE.position[stage][..stage], &TABLE.rate[stage][..stage]);
        let (position, rate) = &mut self.free;
        displace(past, &self.slopes, node, weights, dt, (&self.zero, &mut self.room), (position, rate));
        let own = real(GAMMA) * dt;
        let springs = Implicit { position: own * own, rate: own };
        next.time = past.time + real(node) * dt;
        // Accelerations of the start are too rough to predict a geometry with, where stiff joints are not in equilibrium: the
        // first stage does without, and with one more sweep. The others take those of the stage before.
        let mut sweeps = self.rule.sweeps;
        if stage == 0 {
            sweeps += 1;
            self.at.0.drift_0(&past.position, (real(node) * dt, &past.rate));
            self.at.1.set(&past.rate);
            if Self::FOLLOWS {
                self.led.set(&self.zero);
            }
            if D::Position::CURVED {
                self.at.0.retract_rate(&past.position, &mut self.at.1);
            }
        } else {
            self.set_geometry(springs, stage - 1, past, (node, dt));
        }
        for sweep in 0..sweeps {
            // Where closures are nearly dependent, a geometry that misses them by little is led astray.
            if D::CLOSED && sweep > 0 {
                next.position.drift_0(&self.at.0, (Zero::zero(), &self.zero));
                next.rate.set(&self.at.1);
                self.scene.project_stiff(next, loads, &mut self.stiff);
                self.at.0.drift_0(&next.position, (Zero::zero(), &self.zero));
                self.at.1.set(&next.rate);
            }
            let (at, free) = ((&self.at.0, &self.at.1), (&self.free.0, &self.free.1));
            let reading = if Self::FOLLOWS {
                Reading { position: at.0, rate: at.1, acceleration: &self.led }
            } else {
                Reading { position: free.0, rate: free.1, acceleration: &self.zero }
            };
            let (found, stiff) = (&mut self.slopes[stage], &mut self.stiff);
            next.multipliers =
                self.scene.implicit_accelerations(next.time, at, free, reading, springs, loads, stiff, found);
            self.sweeps += 1;
            if Self::FOLLOWS {
                self.led.set(&self.slopes[stage]);
            }
            if D::Position::CURVED {
                next.acceleration.set(&self.slopes[stage]);
                self.at.0.inverse_retract_acceleration(&past.position, &self.at.1, &mut self.slopes[stage]);
            }
            self.set_geometry(springs, stage, past, (node, dt));
        }
    }

    /// Takes the geometry of the next sweep where these accelerations bring the stage under way, at a share `node` of the step.
    fn set_geometry(
        &mut self,
        springs: Implicit<TimeIn<D, L>>,
        slope: usize,
        past: &MotionIn<D, L>,
        (node, dt): (f64, TimeIn<D, L>),
    ) {
        let slope = &self.slopes[slope];
        self.at.1.mix_1(&self.free.1, (springs.rate, slope));
        if D::Position::CURVED {
            // Coordinates of the step add up, positions do not.
            let (increment, own) = ((dt * dt, &self.room), (springs.position, slope));
            self.at.0.drift_2(&past.position, (TimeIn::<D, L>::of(node) * dt, &past.rate), increment, own);
            self.at.0.retract_rate(&past.position, &mut self.at.1);
        } else {
            self.at.0.drift_1(&self.free.0, (Zero::zero(), &self.zero), (springs.position, slope));
        }
    }

    /// All stages, the last of which is the step; then the tip is put back where it is held.
    fn leap(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &mut MotionIn<D, L>) {
        for stage in 0..STAGES {
            self.solve(stage, past, loads, dt, next);
        }
        next.time = past.time + dt;
        next.position.drift_0(&self.at.0, (Zero::zero(), &self.zero));
        next.rate.set(&self.at.1);
        if !D::Position::CURVED {
            next.acceleration.set(&self.slopes[STAGES - 1]);
        }
        self.scene.project_stiff(next, loads, &mut self.stiff);
    }

    /// Finds where a step went wrong: at its start, or stage by stage.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        // Joints may remember accelerations of the sweeps that failed.
        self.stiff = self.scene.stiff_workspace();
        let mut stage = past.clone();
        let Self { scene, workspace, .. } = self;
        scene.accelerations(past.time, &past.position, &past.rate, loads, workspace, &mut stage.acceleration);
        for row in 0..STAGES {
            if !stage.is_finite() {
                break;
            }
            self.solve(row, past, loads, dt, &mut stage);
            stage.acceleration.set(&self.slopes[row]);
            stage.position.drift_0(&past.position, (stage.time - past.time, &past.rate));
        }
        of_stage(self.scene.diagnose(&stage, loads, &mut self.workspace))
    }
}

impl<D: StiffDynamics<L>, L> Stepper<D, L> for SdirkStepper<D, L> {
    const SETTLED: bool = false;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        check::<D, L>(&self.still, past, next, dt)?;
        self.scene.admits(loads)
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.leap(past, loads, dt, next);
        let (position, rate) = &mut self.estimate;
        gather(position, &self.zero, dt * dt, &ERROR.position, &self.slopes);
        gather(rate, &self.zero, dt, &ERROR.rate, &self.slopes);
        if let Some(tolerance) = self.tolerance {
            self.note_unseen(past, dt);
            // A sweep that only steps take which would be rejected.
            if mean_square(next, (&self.estimate.0, &self.estimate.1), [tolerance; 2]) > 1.0 {
                self.filter(loads, dt, next);
            }
        }
        match self.scene.accept(next) {
            Err(Error { fault: Fault::NonFiniteMotion, .. }) => Err(self.diagnose(past, loads, dt)),
            outcome => outcome,
        }
    }

    fn propose(&mut self, _: &MotionIn<D, L>, _: &L, tolerance: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        self.tolerance = Some(tolerance);
        None
    }

    fn error(
        &mut self,
        _: &MotionIn<D, L>,
        _: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        let square = mean_square(next, (&self.estimate.0, &self.estimate.1), [tolerance; 2]);
        Some(TimeIn::<D, L>::of(square).sqrt())
    }

    fn error_order(&self) -> usize {
        4
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

    /// What joints keep from sweep to sweep.
    type Memory = D::Gains;

    fn memory(&self) -> D::Gains {
        self.scene.gains(&self.stiff).clone()
    }

    fn remembers(&self, memory: &D::Gains, _: &MotionIn<D, L>) -> bool {
        self.scene.gains_fit(memory)
    }

    fn restore(&mut self, memory: &D::Gains) {
        self.scene.copy_gains(memory, self.scene.gains_mut(&mut self.stiff));
    }
}
