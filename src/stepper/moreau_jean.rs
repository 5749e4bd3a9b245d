//! Steps after Moreau and Jean.

mod pivoting;

use super::{Method, MotionIn, Stepper, TimeIn, check, inconsistent, modes_of_one, of_prediction};
use crate::element::{Implicit, Reading};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::Real;
use crate::system::StiffDynamics;
use crate::time::MoreauJean;
use num_traits::Zero;
use pivoting::{Pivoting, begun, ended};

/// Steps by [`MoreauJean`].
///
/// A step needs no accelerations of its start: [`step`](Stepper::step) and [`advance`](Stepper::advance) do the same.
pub struct MoreauJeanStepper<D: StiffDynamics<L>, L> {
    scene: D,
    workspace: D::Workspace,
    stiff: D::StiffWorkspace,
    /// What joints keep of the step, while others are looked at within it.
    kept: D::Gains,
    /// Where positions would be, and rates are, without the acceleration sought.
    free: (D::Position, D::Rate),
    still: MotionIn<D, L>,
    zero: D::Rate,
    /// Whether there are joints with hard stops.
    stops: bool,
    sweeps: usize,
}

impl<D: StiffDynamics<L>, L> Method<D, L> for MoreauJean {
    type Stepper = MoreauJeanStepper<D, L>;

    fn stepper(&self, scene: D) -> MoreauJeanStepper<D, L> {
        let mut still = scene.still();
        let (zero, mut stops) = (still.rate.clone(), false);
        still.position.each_mode(&mut still.rate, &zero, &mut |_, _, told| stops |= told.stops);
        let stiff = scene.stiff_workspace();
        MoreauJeanStepper {
            workspace: scene.workspace(),
            kept: scene.gains(&stiff).clone(),
            stiff,
            free: (still.position.clone(), zero.clone()),
            still,
            zero,
            stops,
            scene,
            sweeps: 0,
        }
    }
}

impl<D: StiffDynamics<L>, L> MoreauJeanStepper<D, L> {
    /// The step: a sweep, and others until what joints with friction and stops do goes together.
    ///
    /// # Errors
    /// The number, among those with modes, of a joint that would change what it does again.
    fn leap(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), usize> {
        let Self { scene, stiff, free: (position, rate), zero, .. } = self;
        let springs = Implicit { position: dt * dt, rate: dt };
        position.drift_0(&past.position, (dt, &past.rate));
        rate.set(&past.rate);
        next.time = past.time + dt;
        if const { D::Position::MODES } {
            position.each_mode(rate, zero, &mut |mode, rate, told| *mode = begun(*mode, *rate, told.rubs));
        }
        let mut pivoting = Pivoting::new::<TimeIn<D, L>>(D::CLOSED);
        loop {
            let (at, free) = ((&past.position, &past.rate), (&*position, &*rate));
            // Laws that are not linear, and contacts, are read where the step leads without accelerations.
            let reading = Reading { position: free.0, rate: free.1, acceleration: &*zero };
            let found = &mut next.acceleration;
            next.multipliers = scene.implicit_accelerations(next.time, at, free, reading, springs, loads, stiff, found);
            self.sweeps += 1;
            if const { !D::Position::MODES } {
                break;
            }
            let found = &next.acceleration;
            if !pivoting.lets_one_go(position, rate, found) && pivoting.agreed(position, rate, found, dt)? {
                break;
            }
        }
        let found = &next.acceleration;
        next.position.drift_1(position, (Zero::zero(), zero), (springs.position, found));
        next.rate.mix_1(rate, (springs.rate, found));
        if const { D::Position::MODES } {
            next.position.each_mode(&mut next.rate, found, &mut |mode, rate, told| ended(mode, rate, &told, dt));
        }
        scene.project_stiff(next, loads, stiff);
        Ok(())
    }

    /// Finds where a step went wrong: at its start, or where its springs are read.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        // Joints may remember accelerations of the sweeps that failed.
        self.stiff = self.scene.stiff_workspace();
        let mut stage = past.clone();
        let Self { scene, workspace, .. } = self;
        scene.accelerations(past.time, &past.position, &past.rate, loads, workspace, &mut stage.acceleration);
        of_prediction(scene, stage, loads, dt, workspace)
    }
}

impl<D: StiffDynamics<L>, L> Stepper<D, L> for MoreauJeanStepper<D, L> {
    const SETTLED: bool = false;
    const SWITCHES: bool = true;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        check::<D, L>(&self.still, past, next, dt)?;
        modes_of_one::<D::Scalar>(D::Position::MODES)?;
        if self.stops && size_of::<D::Scalar>() > size_of::<TimeIn<D, L>>() {
            let what = "derivatives of steps across shocks, which do not tend to those of the motion: runs with events have these";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        self.scene.admits(loads)
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let agreed = self.leap(past, loads, dt, next);
        match self.scene.accept(next) {
            Err(Error { fault: Fault::NonFiniteMotion, .. }) => Err(self.diagnose(past, loads, dt)),
            outcome => outcome.and(agreed.map_err(|joint| inconsistent(joint, past.time))),
        }
    }

    fn error(
        &mut self,
        _: &MotionIn<D, L>,
        _: TimeIn<D, L>,
        _: &MotionIn<D, L>,
        _: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        None
    }

    fn error_order(&self) -> usize {
        2
    }

    /// A step of the share `theta`: as good as the rule at any stiffness, where an interpolation would strain stiff springs.
    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        self.scene.copy_gains(self.scene.gains(&self.stiff), &mut self.kept);
        let agreed = self.leap(past, loads, TimeIn::<D, L>::of(theta) * dt, between);
        core::mem::swap(self.scene.gains_mut(&mut self.stiff), &mut self.kept);
        if agreed.is_err() {
            between.copy_state(next);
        }
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
