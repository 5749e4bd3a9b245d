//! Steps by the predictor and corrector of Adams, Bashforth and Moulton of variable order.

mod past;

use super::between::complete;
use super::displace::{displace, gather};
use super::explicit::ExplicitStepper;
use super::{Method, MotionIn, Stepper, TimeIn};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate, Retraction};
use crate::motion::Motion;
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::Dynamics;
use crate::time::Dop853;
use crate::time::vcabm::{Coefficients, Integrals, TERMS, Vcabm};
use num_traits::{One, Zero};
pub use past::VcabmMemory;

/// What share of what free bodies would yield closures must keep at the end of a step. Where they keep less they depend on each other
/// nearby, and accelerations are lost in rounding, which differences multiply: another method leads over that place, whose steps are longer
/// and which remembers none of them.
const NEAR: f64 = 0.1;

/// Steps by [`Vcabm`].
pub struct VcabmStepper<D: Dynamics<L>, L> {
    most: usize,
    /// Steps of a given size where too little is remembered. It owns the scene.
    start: ExplicitStepper<D, L, Dop853>,
    memory: VcabmMemory<MotionIn<D, L>, D::Rate, TimeIn<D, L>>,
    coefficients: Coefficients,
    /// Whether a run asks for a tolerance, so that sizes of steps and orders are chosen here.
    controlled: bool,
    /// Whether differences of past accelerations made the last step, and of which order.
    own: bool,
    order: usize,
    /// Accelerations where the predictor leads, and by how much they are not those predicted.
    evaluated: D::Rate,
    surprise: D::Rate,
    stage: (D::Position, D::Rate),
    room: [D::Rate; 2],
    zero: D::Rate,
}

impl<D: Dynamics<L>, L> Method<D, L> for Vcabm {
    type Stepper = VcabmStepper<D, L>;

    fn stepper(&self, scene: D) -> VcabmStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        VcabmStepper {
            most: self.most(),
            start: Dop853.stepper(scene),
            memory: VcabmMemory::new(&still, &zero),
            coefficients: Coefficients::none(),
            controlled: false,
            own: true,
            order: 1,
            evaluated: zero.clone(),
            surprise: zero.clone(),
            stage: (still.position, zero.clone()),
            room: [zero.clone(), zero.clone()],
            zero,
        }
    }
}

impl<D: Dynamics<L>, L> VcabmStepper<D, L> {
    /// Whether the next step has a low order although enough motions are remembered.
    pub(super) fn is_low(&self, order: usize) -> bool {
        self.own && self.memory.is_low(order)
    }

    /// Predicts, evaluates, corrects; and evaluates once more in steps of a given size.
    fn leap(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let Self { memory, coefficients, start, evaluated, surprise, stage, room, zero, order, controlled, .. } = self;
        let ((position, rate), [increment, sum]) = (stage, room);
        let (order, differences, one) = (*order, &memory.differences, TimeIn::<D, L>::one());
        let scaled = |integrals: &[f64; TERMS]| -> [f64; TERMS] {
            core::array::from_fn(|i| integrals[i] * coefficients.scale[i])
        };
        let (of_position, of_rate) = (scaled(&coefficients.whole.twice), scaled(&coefficients.whole.once));
        next.time = past.time + dt;
        let weights = (&of_position[..order], &of_rate[..order]);
        displace(past, differences, 1.0, weights, dt, (zero, increment), (position, rate));
        sum.set(rate);
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        next.multipliers = start.scene.accelerations(next.time, position, rate, loads, &mut start.workspace, evaluated);
        next.acceleration.set(evaluated);
        start.sweeps += 1;
        if D::Position::CURVED {
            position.inverse_retract_acceleration(&past.position, rate, evaluated);
        }
        let predicted = coefficients.scale.map(|scale| -scale);
        gather(surprise, evaluated, one, &predicted[..order], differences);
        // The corrector has the predictor's terms and one more.
        let real = TimeIn::<D, L>::of;
        rate.mix_1(increment, (real(coefficients.whole.twice[order]), surprise));
        next.position.drift_1(&past.position, (dt, &past.rate), (dt * dt, rate));
        next.rate.mix_1(sum, (real(coefficients.whole.once[order]) * dt, surprise));
        if D::Position::CURVED {
            next.position.retract_rate(&past.position, &mut next.rate);
        }
        start.scene.project(next, loads, &mut start.workspace);
        if !*controlled {
            let Motion { time, position, rate, acceleration, multipliers } = next;
            *multipliers = start.scene.accelerations(*time, position, rate, loads, &mut start.workspace, acceleration);
            start.sweeps += 1;
        }
        match start.scene.accept(next) {
            // Where the step goes wrong, Dop853's does too.
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => Err(start.diagnose(past, loads, dt, next)),
            outcome => outcome,
        }
    }

    /// The error of the last step, had its predictor been of an order: of a difference that its accelerations show.
    // Not inlined: of arguments alone a compiler knows that they do not overlap.
    #[inline(never)]
    fn error_of(
        integrals: &Integrals,
        order: usize,
        difference: &D::Rate,
        squares: &mut D::Rate,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> f64 {
        let weight = |of: &[f64; TERMS]| TimeIn::<D, L>::of(of[order] - of[order - 1]);
        let sum = |squares: &D::Rate| {
            let mut sum = TimeIn::<D, L>::zero();
            squares.visit(&mut |square| sum += square.real());
            sum
        };
        next.position.square_shares(difference, squares);
        let of_position = sum(squares);
        squares.square_shares(difference, &next.rate);
        let of_rate = sum(squares);
        let mut count = 0_usize; // of numbers of both
        squares.visit(&mut |_| count += 2);
        let (twice, once) = (weight(&integrals.twice) * dt * dt / tolerance, weight(&integrals.once) * dt / tolerance);
        let sum = twice * twice * of_position + once * once * of_rate;
        Elementary::sqrt(sum / TimeIn::<D, L>::of(count.max(1) as f64)).as_f64()
    }
}

impl<D: Dynamics<L>, L> Stepper<D, L> for VcabmStepper<D, L> {
    const SETTLED: bool = false;
    const PLANS: bool = true;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.start.admit(past, loads, dt, next)
    }

    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        self.start.begin(past, loads);
    }

    fn resume(&mut self, past: &MotionIn<D, L>) {
        self.start.resume(past);
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let Self { memory, start, room: [room, _], .. } = self;
        memory.recall(past, &start.slopes.as_ref()[0]);
        let size = memory.size(dt.as_f64());
        if size == 0.0 {
            memory.forget();
            self.own = false;
            return self.start.make(past, loads, dt, next);
        }
        if memory.bridged() {
            self.own = false;
            start.begin(past, loads); // the accelerations that the predictor led to are not good enough there
            start.make(past, loads, dt, next)?;
            memory.write_bridge(next);
            return Ok(());
        }
        let usable = memory.usable(size);
        let order = if self.controlled { memory.order.min(usable).min(self.most) } else { self.most };
        self.own = order <= usable;
        self.order = order.min(usable);
        let count = usable.min(self.order + 1);
        memory.spread(count, past, room);
        self.coefficients.update(size, &memory.sizes, count);
        let made = if self.own { self.leap(past, loads, dt, next) } else { self.start.make(past, loads, dt, next) };
        made?;
        let Self { memory, surprise, evaluated, room: [room, other], .. } = self;
        // By how much accelerations are not those predicted, in coordinates of the step.
        let found = if D::Position::CURVED {
            room.set(&next.acceleration);
            next.position.inverse_retract_acceleration(&past.position, &next.rate, room);
            &*room
        } else {
            &next.acceleration
        };
        let one = TimeIn::<D, L>::one();
        if self.own && self.controlled {
            memory.change.set(surprise);
        } else if self.own {
            memory.change.mix_2(surprise, (one, found), (-one, evaluated));
        } else if !D::Position::CURVED {
            let weights = self.coefficients.scale.map(|scale| -scale);
            gather(other, found, one, &weights[..self.order], &memory.differences);
            memory.change.set(other);
        }
        memory.write(next, size, self.order, &self.coefficients.scale);
        Ok(())
    }

    fn propose(&mut self, past: &MotionIn<D, L>, _: &L, _: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        self.controlled = true;
        self.memory.proposed(past)
    }

    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        if D::CLOSED && !self.start.firm(next, NEAR) {
            self.memory.lead_over();
        }
        if !self.own {
            // A step of order 1 that errs as much as one of order 8.
            self.memory.want(dt * tolerance.powf(TimeIn::<D, L>::of(1.0 / 2.0 - 1.0 / 9.0)));
            return self.start.error(past, dt, next, tolerance);
        }
        let Self { order, most, memory, coefficients, surprise, room: [room, squares], .. } = self;
        let (order, scale) = (*order, |i: usize| TimeIn::<D, L>::of(coefficients.scale[i]));
        let mut error_of = |order: usize, difference: &D::Rate| {
            Self::error_of(&coefficients.whole, order, difference, squares, dt, next, tolerance)
        };
        let own = error_of(order, surprise);
        let lower = (order > 1).then(|| {
            room.mix_1(surprise, (scale(order - 1), &memory.differences[order - 1]));
            error_of(order - 1, room)
        });
        let higher = (order < *most && memory.may_rise()).then(|| {
            room.mix_1(&memory.change, (-scale(order), &memory.differences[order]));
            error_of(order + 1, room)
        });
        self.memory.choose([Some(own), lower, higher], dt, self.most);
        if D::CLOSED {
            self.memory.startled(own);
        }
        Some(TimeIn::<D, L>::of(own))
    }

    fn error_order(&self) -> usize {
        if self.own { self.memory.order + 1 } else { self.start.error_order() }
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        self.start.firm(next, least)
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
        if !self.own {
            return self.start.interpolate(past, loads, dt, next, theta, between);
        }
        let Self { memory, coefficients, start, room: [increment, _], zero, order, stage: (_, last), .. } = self;
        let integrals = coefficients.up_to(theta);
        let scaled = |of: &[f64; TERMS]| -> [f64; TERMS] { core::array::from_fn(|i| of[i] * coefficients.scale[i]) };
        let (of_position, of_rate) = (scaled(&integrals.twice), scaled(&integrals.once));
        let (weights, real) = ((&of_position[..*order], &of_rate[..*order]), TimeIn::<D, L>::of);
        let Motion { position, rate, .. } = between;
        displace(past, &memory.differences, theta, weights, dt, (zero, increment), (position, rate));
        // And what the end of the step adds.
        last.mix_1(increment, (real(integrals.twice[*order]), &memory.change));
        position.drift_1(&past.position, (real(theta) * dt, &past.rate), (dt * dt, last));
        last.set(rate);
        rate.mix_1(last, (real(integrals.once[*order]) * dt, &memory.change));
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        between.time = past.time + real(theta) * dt;
        start.sweeps += complete(&start.scene, between, loads, &mut start.workspace);
    }

    fn sweeps(&self) -> usize {
        self.start.sweeps
    }

    type Memory = VcabmMemory<MotionIn<D, L>, D::Rate, TimeIn<D, L>>;

    fn memory(&self) -> Self::Memory {
        self.memory.clone()
    }

    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        memory.sound(motion)
    }

    fn restore(&mut self, memory: &Self::Memory) {
        self.memory.clone_from(memory);
        self.memory.forgive();
    }

    fn restart(&mut self) {
        self.memory.forget();
    }
}
