//! A run under way: step control, samples by dense output, location of events.

use super::{EventFunction, Find, Now, Run, Simulation, settled};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::Dynamics;
use crate::system::{MotionOf, Runs, System};
use crate::time::Control;
use core::cell::OnceCell;
use num_traits::{One, Zero};

/// A run under way.
pub(super) struct Driver<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L, M, E, K, O> {
    pub(super) plan: Simulation<'a, S, R, C, P, L, M, E>,
    pub(super) stepper: K,
    pub(super) past: MotionOf<S, R, C, P>,
    pub(super) next: MotionOf<S, R, C, P>,
    pub(super) between: MotionOf<S, R, C, P>,
    pub(super) observe: O,
    pub(super) counters: Run<()>,
    /// Number of the next sample.
    pub(super) samples: usize,
}

/// What came of a step.
enum Outcome {
    Continue,
    Stop,
}

impl<'a, S, R, C, P, L, M, E, K, O> Driver<'a, S, R, C, P, L, M, E, K, O>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    K: Stepper<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    O: FnMut(&Now<'_, S, R, C, P, L>),
{
    /// How readings find accelerations, if the method leaves others.
    const FIND: Option<Find<S, R, C, P, L>> = if K::SETTLED { None } else { Some(settled) };

    pub(super) fn drive(&mut self, end: RealOf<S>) -> Result<(), Error> {
        let system = self.plan.system;
        system.accept(&self.past)?;
        if System::<S, R, C, P>::CLOSED > 0 {
            // Whether they are independent, once.
            system.accelerate(&mut self.next, self.plan.loads, &mut system.workspace())?;
        }
        if !end.is_finite() || end < self.past.time {
            return Err(Error::new(Fault::NotFinite { parameter: "end of the run after its start" }));
        }
        let (Control::Fixed(chosen) | Control::Tolerance(chosen)) = self.plan.rule.control;
        let numbers = [
            ("step size or tolerance", Some(chosen)),
            ("interval between samples", self.plan.every),
            ("longest step", self.plan.longest),
        ];
        for (parameter, number) in numbers {
            if let Some(number) = number
                && !(number.is_finite() && number > RealOf::<S>::zero())
            {
                return Err(Error::new(Fault::NotPositive { parameter, value: number.as_f64() }));
            }
        }
        let mut workspace = Dynamics::<L>::workspace(system);
        // In a copy: a run that cannot start gives the start back as it was.
        system.accelerate(&mut self.next, self.plan.loads, &mut workspace)?;
        core::mem::swap(&mut self.past, &mut self.next);
        let start = self.past.time;
        let one = RealOf::<S>::one();
        let mut dt = match self.plan.rule.control {
            Control::Fixed(dt) => dt,
            Control::Tolerance(tolerance) => self.first_step(tolerance),
        };
        self.show(Shown::Past, false);
        let mut value = self.value(Shown::Past);
        let mut rejected = false;
        while self.past.time < end {
            // Fixed steps end at multiples of their size, without the rounding of a running sum.
            let planned = match self.plan.rule.control {
                Control::Fixed(dt) => start + dt * RealOf::<S>::of((self.counters.steps + 1) as f64) - self.past.time,
                Control::Tolerance(_) => self.plan.longest.map_or(dt, |longest| dt.min(longest)),
            };
            // The last step lands on the end; it may be longer by rounding.
            let remaining = end - self.past.time;
            let last = remaining <= planned * (one + RealOf::<S>::EPSILON * RealOf::<S>::of(1e6));
            let size = if last { remaining } else { planned };
            if self.past.time + size <= self.past.time {
                return Err(self.too_small(size));
            }
            let outcome = self.stepper.advance(&self.past, self.plan.loads, size, &mut self.next);
            if let Control::Tolerance(tolerance) = self.plan.rule.control {
                let error = match outcome {
                    Ok(()) => self.stepper.error(&self.past, size, &self.next, tolerance),
                    Err(Error { fault: Fault::NonFiniteMotion, .. }) => Some(RealOf::<S>::INFINITY),
                    // A step that is far too long may leap anywhere: its error by the size of the past motion says so.
                    Err(refused @ Error { fault: Fault::AngleOutOfRange { .. }, .. }) => {
                        let leap = self.stepper.error(&self.past, size, &self.past, tolerance);
                        if leap.is_none_or(|leap| leap <= one) {
                            return Err(refused);
                        }
                        leap
                    }
                    Err(error) => return Err(error),
                };
                let error = error.unwrap_or(RealOf::<S>::zero());
                let factor = factor(error, self.stepper.error_order());
                if !error.is_finite() || error > one {
                    self.counters.rejected += 1;
                    rejected = true;
                    dt = size * factor.min(RealOf::<S>::of(0.9));
                    continue;
                }
                // No growth right after a rejection, and none from a step cut short by the end.
                let factor = if rejected || last { factor.min(one) } else { factor };
                rejected = false;
                dt = size * factor;
            } else {
                outcome?;
            }
            if last {
                self.next.time = end;
            }
            self.counters.steps += 1;
            let next_value = self.value(Shown::Next);
            if let Outcome::Stop = self.shown(start, size, [value, next_value]) {
                return Ok(());
            }
            value = next_value;
            core::mem::swap(&mut self.past, &mut self.next);
        }
        Ok(())
    }

    /// A first step from the size of motion and accelerations (Hairer, Nørsett, Wanner, II.4, without its trial step).
    fn first_step(&self, tolerance: RealOf<S>) -> RealOf<S> {
        let one = RealOf::<S>::one();
        let (mut size, mut slope) = (RealOf::<S>::zero(), RealOf::<S>::zero());
        let mut note = |rate: S::Scalar, value: RealOf<S>| {
            size = size.max(value / (one + value));
            slope = slope.max(rate.real().abs() / (one + value));
        };
        self.past.position.measure(&self.past.rate, &mut note);
        self.past.acceleration.all(&self.past.rate, &mut |acceleration, rate| {
            note(acceleration, rate.real().abs());
            true
        });
        let tiny = RealOf::<S>::of(1e-6);
        let small = if size < tiny || slope < tiny { tiny } else { RealOf::<S>::of(0.01) * size / slope };
        let exponent = one / RealOf::<S>::of(self.stepper.error_order());
        let safe = (RealOf::<S>::of(0.01) * tolerance / slope.max(tiny)).powf(exponent);
        (small * RealOf::<S>::of(100.0)).min(safe)
    }

    fn too_small(&self, size: RealOf<S>) -> Error {
        Error::new(Fault::StepTooSmall { step: size.as_f64() }).at_time(self.past.time.as_f64())
    }

    /// The value of the event function, if there is one.
    fn value(&mut self, which: Shown) -> Option<S::Scalar> {
        let Self { plan, past, next, between, .. } = self;
        let stepped = which.of(past, next, between);
        let (find, found) = (Self::FIND, OnceCell::new());
        plan.event.value(&Now { system: plan.system, stepped, loads: plan.loads, event: false, find, found })
    }

    fn show(&mut self, which: Shown, event: bool) {
        let Self { plan, past, next, between, observe, .. } = self;
        let stepped = which.of(past, next, between);
        let (find, found) = (Self::FIND, OnceCell::new());
        observe(&Now { system: plan.system, stepped, loads: plan.loads, event, find, found });
    }

    fn interpolate(&mut self, size: RealOf<S>, theta: f64) {
        self.stepper.interpolate(&self.past, self.plan.loads, size, &self.next, theta, &mut self.between);
    }

    /// Shows what there is to see of an accepted step: samples, an event, its end.
    fn shown(&mut self, start: RealOf<S>, size: RealOf<S>, values: [Option<S::Scalar>; 2]) -> Outcome {
        let crossing = match values.map(|value| value.map(|value| value.real().as_f64())) {
            [Some(before), Some(after)] if before != 0.0 && before * after <= 0.0 => {
                Some(self.crossing(size, [before, after]))
            }
            _ => None,
        };
        if let Some(theta) = crossing {
            self.samples_until(start, size, theta);
            self.interpolate(size, theta);
            self.show(Shown::Between, true);
            if self.plan.stop {
                core::mem::swap(&mut self.past, &mut self.between);
                return Outcome::Stop;
            }
        }
        self.samples_until(start, size, 1.0);
        if self.plan.every.is_none() {
            self.show(Shown::Next, false);
        }
        Outcome::Continue
    }

    /// Shows the samples up to a share of the step.
    fn samples_until(&mut self, start: RealOf<S>, size: RealOf<S>, share: f64) {
        let Some(every) = self.plan.every else {
            return;
        };
        // A sample that falls on the end of a step but for rounding is its end.
        let rounding = RealOf::<S>::EPSILON * RealOf::<S>::of(4.0) * (self.past.time.abs() + size);
        let slack = 1e-9 * (every / size).as_f64().min(1.0) + (rounding / size).as_f64();
        loop {
            let time = start + every * RealOf::<S>::of(self.samples as f64);
            let theta = ((time - self.past.time) / size).as_f64();
            if theta > share + slack {
                return;
            }
            self.samples += 1;
            if theta >= 1.0 - slack {
                self.show(Shown::Next, false);
            } else {
                self.interpolate(size, theta);
                self.show(Shown::Between, false);
            }
        }
    }

    /// The share of the step at which the event function crosses zero: regula falsi with the Illinois modification.
    fn crossing(&mut self, size: RealOf<S>, values: [f64; 2]) -> f64 {
        let ([mut low, mut high], [mut below, mut above]) = ([0.0, 1.0], values);
        let mut kept = 0;
        for _ in 0..100 {
            let theta = high - above * (high - low) / (above - below);
            let theta = if theta > low && theta < high { theta } else { 0.5 * (low + high) };
            self.interpolate(size, theta);
            let value = self.value(Shown::Between).map_or(0.0, |value| value.real().as_f64());
            if value * above > 0.0 {
                (high, above) = (theta, value);
                below *= if kept == 1 { 0.5 } else { 1.0 };
                kept = 1;
            } else {
                (low, below) = (theta, value);
                above *= if kept == -1 { 0.5 } else { 1.0 };
                kept = -1;
            }
            if value == 0.0 || high - low < 4.0 * f64::EPSILON {
                return theta;
            }
        }
        0.5 * (low + high)
    }
}

/// One of the motions of a run under way.
#[derive(Clone, Copy)]
enum Shown {
    Past,
    Next,
    Between,
}

impl Shown {
    fn of<'m, M>(self, past: &'m M, next: &'m M, between: &'m M) -> &'m M {
        match self {
            Self::Past => past,
            Self::Next => next,
            Self::Between => between,
        }
    }
}

/// By how much the next step should differ, for an error given as a multiple of the tolerance.
fn factor<R: Real>(error: R, order: f64) -> R {
    if !error.is_finite() {
        return R::of(0.1);
    }
    let wanted = R::of(0.9) * error.max(R::of(1e-12)).powf(R::of(-1.0 / order));
    wanted.max(R::of(0.2)).min(R::of(6.0))
}
