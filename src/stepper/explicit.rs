//! Steps by explicit methods.

use super::{Method, MotionIn, Stepper, TimeIn};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use crate::system::Dynamics;
use crate::time::Explicit;
use num_traits::{One, Zero};

/// Steps by an explicit method.
pub struct ExplicitStepper<D: Dynamics<L>, L, M: Explicit> {
    scene: D,
    workspace: D::Workspace,
    /// Accelerations of the rows: of the past motion, of the stages, of the next motion, of stages for the dense output.
    slopes: M::Rows<D::Rate>,
    stage: (D::Position, D::Rate),
    start: Option<MotionIn<D, L>>,
    zero: D::Rate,
    estimate: (D::Rate, D::Rate),
    dense_ready: bool,
    sweeps: usize,
}

impl<M: Explicit> Method for M {
    type Stepper<D: Dynamics<L>, L> = ExplicitStepper<D, L, M>;

    fn stepper<D: Dynamics<L>, L>(&self, scene: D) -> ExplicitStepper<D, L, M> {
        let still = scene.still();
        let zero = still.rate.clone();
        ExplicitStepper {
            workspace: scene.workspace(),
            slopes: M::rows(&zero),
            stage: (still.position.clone(), zero.clone()),
            estimate: (zero.clone(), zero.clone()),
            zero,
            scene,
            start: Some(still),
            dense_ready: false,
            sweeps: 0,
        }
    }
}

/// The first `M` accelerations of a step.
#[inline(always)]
fn first<R, const M: usize>(slopes: &[R]) -> [&R; M] {
    core::array::from_fn(|j| &slopes[j])
}

/// The past motion displaced by `M` accelerations with the weights of a row (position, rate).
#[inline(always)]
fn displace<T: Scalar, P: Position<T>, C: Closures, const M: usize>(
    past: &Motion<T, P, C>,
    terms: [&P::Rate; M],
    node: f64,
    weights: (&[f64], &[f64]),
    dt: T::Real,
    position: &mut P,
    rate: &mut P::Rate,
) {
    let of_position = core::array::from_fn(|j| T::Real::of(weights.0[j]) * (dt * dt));
    let of_rate = core::array::from_fn(|j| T::Real::of(weights.1[j]) * dt);
    position.drift(&past.position, T::Real::of(node) * dt, &past.rate, &of_position, terms);
    rate.combine(&past.rate, &of_rate, terms);
}

/// Calls a function that is generic over the number of terms, so that its loops unroll.
macro_rules! unrolled {
    ($count:expr, $call:ident!($($M:literal)*)) => {
        match $count {
            $($M => $call!($M),)*
            _ => (),
        }
    };
}

impl<D: Dynamics<L>, L, M: Explicit> ExplicitStepper<D, L, M> {
    /// The state of a row (a stage, the step, a dense stage), from the accelerations of those before.
    #[inline]
    fn row(
        row: usize,
        past: &MotionIn<D, L>,
        slopes: &[D::Rate],
        dt: TimeIn<D, L>,
        position: &mut D::Position,
        rate: &mut D::Rate,
    ) {
        let weights = (M::position(row), M::rate(row));
        macro_rules! call {
            ($M:literal) => {{
                let terms = first::<_, $M>(slopes);
                displace(past, terms, M::node(row), weights, dt, position, rate)
            }};
        }
        unrolled!(row, call!(1 2 3 4 5 6 7 8 9 10 11 12 13 14 15));
    }

    /// Evaluates a row that is not the step itself: its accelerations become slopes.
    #[inline]
    fn evaluate(&mut self, row: usize, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) {
        let (position, rate) = &mut self.stage;
        let slopes = self.slopes.as_mut();
        Self::row(row, past, slopes, dt, position, rate);
        let time = past.time + TimeIn::<D, L>::of(M::node(row)) * dt;
        self.scene.accelerations(time, position, rate, loads, &mut self.workspace, &mut slopes[row]);
        self.sweeps += 1;
    }

    /// Finds where a step went wrong, row by row.
    #[cold]
    fn diagnose(&mut self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>) -> Error {
        for row in 0..=M::STAGES {
            let mut stage = past.clone();
            if row > 0 {
                self.evaluate(row, past, loads, dt);
                stage.time = past.time + TimeIn::<D, L>::of(M::node(row)) * dt;
                stage.position.clone_from(&self.stage.0);
                stage.rate.clone_from(&self.stage.1);
                stage.acceleration.clone_from(&self.slopes.as_ref()[row]);
            }
            if !stage.is_finite() {
                return self.scene.diagnose(&stage, loads, &mut self.workspace);
            }
        }
        Error::new(Fault::NonFiniteMotion).at_time((past.time + dt).as_f64())
    }
}

impl<D: Dynamics<L>, L, M: Explicit> Stepper<D, L> for ExplicitStepper<D, L, M> {
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
        if !(self.start.as_ref().is_none_or(|start| past.fits(start)) && past.fits(next)) {
            return Err(Error::new(Fault::Shape));
        }
        self.dense_ready = false;
        self.slopes.as_mut()[0].clone_from(&past.acceleration);
        for row in 1..M::STAGES {
            self.evaluate(row, past, loads, dt);
        }
        next.time = past.time + dt;
        let slopes = self.slopes.as_ref();
        Self::row(M::STAGES, past, slopes, dt, &mut next.position, &mut next.rate);
        // The gains of the last stage serve to project, so that the sweep that follows sees a closed scene.
        self.scene.project(next, &mut self.workspace);
        let Motion { time, position, rate, acceleration, multipliers } = next;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
        self.slopes.as_mut()[M::STAGES].clone_from(&next.acceleration);
        match self.scene.accept(next) {
            Ok(()) => Ok(()),
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => Err(self.diagnose(past, loads, dt)),
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
        for ((of_position, of_rate), square) in M::errors().iter().zip(&mut squares) {
            let (position, rate) = &mut self.estimate;
            let zero = &self.zero;
            macro_rules! call {
                ($M:literal) => {{
                    let terms = first::<_, $M>(slopes);
                    let scaled =
                        |weights: &[f64], by| core::array::from_fn::<_, $M, _>(|j| TimeIn::<D, L>::of(weights[j]) * by);
                    position.combine(zero, &scaled(of_position, dt * dt), terms);
                    rate.combine(zero, &scaled(of_rate, dt), terms);
                }};
            }
            unrolled!(M::STAGES + 1, call!(7 13));
            let (mut sum, mut count) = (TimeIn::<D, L>::zero(), 0usize);
            let mut note = |error: D::Scalar, size: TimeIn<D, L>| {
                let share = error.real() / (tolerance * (TimeIn::<D, L>::one() + size));
                sum += share * share;
                count += 1;
            };
            next.position.measure(position, &mut note);
            rate.all(&next.rate, &mut |error, rate| {
                note(error, rate.real().abs());
                true
            });
            *square = sum.as_f64() / count.max(1) as f64;
        }
        let count = M::errors().len();
        (count > 0).then(|| TimeIn::<D, L>::of(M::combine_errors(&squares[..count])).sqrt())
    }

    fn error_order(&self) -> f64 {
        M::ORDER as f64
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
            for row in M::STAGES + 1..M::ROWS {
                self.evaluate(row, past, loads, dt);
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
        let slopes = self.slopes.as_ref();
        let weights = (&of_position[..], &of_rate[..]);
        macro_rules! call {
            ($M:literal) => {{
                let Motion { position, rate, .. } = between;
                let terms = first::<_, $M>(slopes);
                displace(past, terms, theta, weights, dt, position, rate);
            }};
        }
        unrolled!(M::ROWS, call!(5 7 16));
        between.time = past.time + TimeIn::<D, L>::of(theta) * dt;
        let Motion { time, position, rate, acceleration, multipliers } = between;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }
}
