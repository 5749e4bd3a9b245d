//! Steps by explicit methods.

use super::between::complete;
use super::displace::{are_few, displace, displace_by_row, gather, gather_few, mean_square};
use super::{Method, MotionIn, Stepper, TimeIn, of_stage};
use crate::error::{Error, Fault, ensure_finite};
use crate::mirror::{Position, Rate, Retraction};
use crate::motion::Motion;
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::Dynamics;
use crate::time::Explicit;
use num_traits::{One, Zero};

/// Steps by an explicit method.
pub struct ExplicitStepper<D: Dynamics<L>, L, M: Explicit> {
    pub(super) scene: D,
    pub(super) workspace: D::Workspace,
    /// Accelerations of the rows: of the past motion, of the stages, of the next motion, of stages for the dense output.
    pub(super) slopes: M::Rows<D::Rate>,
    pub(super) stage: (D::Position, D::Rate),
    still: MotionIn<D, L>,
    zero: D::Rate,
    /// Room for increments of positions, and for estimates of errors.
    estimate: (D::Rate, D::Rate),
    /// The size of the step under way. Read anew for each row: a compiler that knew it throughout would scale the weights of all rows
    /// first, and keep them in memory.
    size: TimeIn<D, L>,
    dense_ready: bool,
    pub(super) sweeps: usize,
}

impl<D: Dynamics<L>, L, M: Explicit> Method<D, L> for M {
    type Stepper = ExplicitStepper<D, L, M>;

    fn stepper(&self, scene: D) -> ExplicitStepper<D, L, M> {
        let still = scene.still();
        let zero = still.rate.clone();
        ExplicitStepper {
            workspace: scene.workspace(),
            slopes: M::rows(&zero),
            stage: (still.position.clone(), zero.clone()),
            estimate: (zero.clone(), zero.clone()),
            zero,
            scene,
            still,
            size: Zero::zero(),
            dense_ready: false,
            sweeps: 0,
        }
    }
}

/// Weights of a row in position and rate: of the accelerations before it.
pub(crate) fn row_weights<M: Explicit>(row: usize) -> (&'static [f64], &'static [f64]) {
    (&M::position(row)[..row], &M::rate(row)[..row])
}

/// Calls a method for each row, by its number as a literal.
macro_rules! each_row {
    ($($row:literal)* => |$name:ident| $call:expr) => {$(
        let $name = $row;
        $call;
    )*};
}

impl<D: Dynamics<L>, L, M: Explicit> ExplicitStepper<D, L, M> {
    /// Whether sums are formed in registers, row by row.
    const FEW: bool = are_few::<D::Scalar, D::Rate>();

    /// Positions and rates of a row.
    #[cfg_attr(optimised, inline(always))]
    fn displace(
        row: usize,
        past: &MotionIn<D, L>,
        slopes: &[D::Rate],
        dt: TimeIn<D, L>,
        room: (&D::Rate, &mut D::Rate),
        into: (&mut D::Position, &mut D::Rate),
    ) {
        displace_by_row(past, slopes, M::node(row), row_weights::<M>(row), dt, room, into);
    }

    /// Evaluates a row that is not the step itself: its accelerations become slopes.
    // Inlined, so that the compiler knows the weights, where it optimises at all.
    #[cfg_attr(optimised, inline(always))]
    fn evaluate(&mut self, row: usize, past: &MotionIn<D, L>, loads: &L) {
        let dt = self.size;
        let (position, rate) = &mut self.stage;
        let slopes = self.slopes.as_mut();
        Self::displace(row, past, slopes, dt, (&self.zero, &mut self.estimate.0), (position, rate));
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        let time = past.time + TimeIn::<D, L>::of(M::node(row)) * dt;
        self.scene.accelerations(time, position, rate, loads, &mut self.workspace, &mut slopes[row]);
        if D::Position::CURVED {
            position.inverse_retract_acceleration(&past.position, rate, &mut slopes[row]);
        }
        self.sweeps += 1;
    }

    /// Finds where a step went wrong, row by row.
    #[cold]
    pub(super) fn diagnose(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
    ) -> Error {
        let finite = |position: &D::Position| {
            let mut finite = true;
            position.visit(&mut |x| finite &= x.is_finite());
            finite
        };
        self.size = dt;
        for row in 0..=M::STAGES {
            let mut stage = past.clone();
            if row > 0 {
                self.evaluate(row, past, loads);
                stage.time = past.time + TimeIn::<D, L>::of(M::node(row)) * dt;
                stage.position.clone_from(&self.stage.0);
                stage.rate.clone_from(&self.stage.1);
            }
            if row == M::STAGES && finite(&stage.position) && !finite(&next.position) {
                break; // no projection closes it: the step was too long
            }
            stage.acceleration.clone_from(&self.slopes.as_ref()[row]);
            if !stage.is_finite() {
                return of_stage(self.scene.diagnose(&stage, loads, &mut self.workspace));
            }
        }
        Error::new(Fault::NonFiniteMotion).at_time((past.time + dt).as_f64())
    }
}

impl<D: Dynamics<L>, L, M: Explicit> Stepper<D, L> for ExplicitStepper<D, L, M> {
    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.scene.admits(loads)?;
        ensure_finite(dt.is_finite(), "step size")?;
        if past.fits(&self.still) && past.fits(next) { Ok(()) } else { Err(Error::new(Fault::Shape)) }
    }

    /// Finds the accelerations of a motion, the first row.
    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        let first = &mut self.slopes.as_mut()[0];
        self.scene.accelerations(past.time, &past.position, &past.rate, loads, &mut self.workspace, first);
        self.sweeps += 1;
    }

    fn resume(&mut self, past: &MotionIn<D, L>) {
        self.slopes.as_mut()[0].set(&past.acceleration);
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        (self.size, self.dense_ready) = (dt, false);
        if Self::FEW {
            each_row!(1 2 3 4 5 6 7 8 9 10 11 => |row| if row < M::STAGES { self.evaluate(row, past, loads) });
        } else {
            for row in 1..M::STAGES {
                self.evaluate(row, past, loads);
            }
        }
        next.time = past.time + dt;
        let (slopes, room) = (self.slopes.as_ref(), (&self.zero, &mut self.estimate.0));
        Self::displace(M::STAGES, past, slopes, dt, room, (&mut next.position, &mut next.rate));
        if D::Position::CURVED {
            next.position.retract_rate(&past.position, &mut next.rate);
        }
        // The gains of the last stage serve to project, so that the sweep that follows sees a closed scene.
        self.scene.project(next, loads, &mut self.workspace);
        let Motion { time, position, rate, acceleration, multipliers } = next;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
        let last = &mut self.slopes.as_mut()[M::STAGES];
        last.set(&next.acceleration);
        if D::Position::CURVED {
            next.position.inverse_retract_acceleration(&past.position, &next.rate, last);
        }
        match self.scene.accept(next) {
            Ok(()) => Ok(()),
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => Err(self.diagnose(past, loads, dt, next)),
            Err(error) => Err(error),
        }
    }
    fn error(
        &mut self,
        _: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        let slopes = self.slopes.as_ref();
        let mut squares = [0.0; 2];
        let one = TimeIn::<D, L>::one();
        let tolerances = [tolerance / (dt * dt), tolerance / dt]; // of sums that are not scaled
        macro_rules! estimates {
            ($($k:literal)*) => {$(
                if let Some((of_rate, of_position)) = M::errors().get($k) {
                    let (position, rate) = &mut self.estimate;
                    let (of_position, of_rate) = (&of_position[..=M::STAGES], &of_rate[..=M::STAGES]);
                    if Self::FEW {
                        gather_few(position, &self.zero, |j| of_position.get(j).copied(), slopes);
                        gather_few(rate, &self.zero, |j| of_rate.get(j).copied(), slopes);
                    } else {
                        gather(position, &self.zero, one, of_position, slopes);
                        gather(rate, &self.zero, one, of_rate, slopes);
                    }
                    squares[$k] = mean_square(next, (position, rate), tolerances);
                }
            )*};
        }
        estimates!(0 1);
        let count = M::errors().len();
        (count > 0).then(|| TimeIn::<D, L>::of(M::combine_errors(&squares[..count])).sqrt())
    }

    fn error_order(&self) -> usize {
        M::ORDER
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        self.scene.independent(next, &self.workspace, least, &mut |_, _| ()).is_ok()
    }

    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        _: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        if !self.dense_ready {
            self.size = dt;
            for row in M::STAGES + 1..M::ROWS {
                self.evaluate(row, past, loads);
            }
            self.dense_ready = true;
        }
        let mut of_rate = [0.0; 16];
        M::dense(theta, &mut of_rate[..M::ROWS]);
        let mut of_position = [0.0; 16];
        for (j, weight) in of_rate[..M::ROWS].iter().enumerate() {
            for (sum, a) in of_position.iter_mut().zip(M::rate(j)) {
                *sum += weight * a;
            }
        }
        let weights = (&of_position[..M::ROWS], &of_rate[..M::ROWS]);
        let room = (&self.zero, &mut self.estimate.0);
        let Motion { position, rate, .. } = between;
        displace(past, self.slopes.as_ref(), theta, weights, dt, room, (position, rate));
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        between.time = past.time + TimeIn::<D, L>::of(theta) * dt;
        self.sweeps += complete(&self.scene, between, loads, &mut self.workspace);
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }

    /// Nothing: all that a step needs stands in its motion.
    type Memory = ();

    fn memory(&self) {}

    fn restore(&mut self, (): &()) {}
}
