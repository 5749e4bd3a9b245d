//! A run under way: step control, samples by dense output, location of events.

use super::crossing::crossing;
use super::trials::{Trials, factor};
use super::{EventFunction, Find, Now, Progress, Simulation, limits, settled};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Cause, Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::Dynamics;
use crate::system::{MotionOf, Runs, System};
use crate::time::Control;
use core::cell::OnceCell;
use num_traits::{One, Zero};

/// A run under way, step by step: made by [`begin`](Simulation::begin) and [`resume`](Simulation::resume).
pub struct Running<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L, M, E, K, O> {
    pub(super) plan: Simulation<'a, S, R, C, P, L, M, E>,
    pub(super) end: RealOf<S>,
    pub(super) stepper: K,
    pub(super) past: MotionOf<S, R, C, P>,
    pub(super) next: MotionOf<S, R, C, P>,
    pub(super) between: MotionOf<S, R, C, P>,
    pub(super) observe: O,
    pub(super) progress: Progress<RealOf<S>>,
    /// The value of the event function at the past motion.
    pub(super) value: Option<S::Scalar>,
}

/// What came of a step.
enum Outcome {
    Continue,
    Stop,
}

impl<'a, S, R, C, P, L, M, E, K, O> Running<'a, S, R, C, P, L, M, E, K, O>
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

    /// Refuses what makes no run, and motions of another scene.
    fn check(&mut self) -> Result<(), Error> {
        let system = self.plan.system;
        system.fits(&self.past)?;
        system.loadable(self.plan.loads)?;
        system.accept(&self.past)?;
        if System::<S, R, C, P>::CLOSED > 0 {
            // Whether they are independent, once.
            system.accelerate(&mut self.next, self.plan.loads, &mut system.workspace())?;
        }
        let Simulation { rule, every, longest, .. } = &self.plan;
        limits::check([self.past.time, self.end], rule.control, *every, *longest)
    }

    /// Makes the start ready and shows it.
    pub(super) fn start(&mut self) -> Result<(), Error> {
        self.check()?;
        let system = self.plan.system;
        let mut workspace = Dynamics::<L>::workspace(system);
        // In a copy: a run that cannot start gives the start back as it was.
        system.accelerate(&mut self.next, self.plan.loads, &mut workspace)?;
        core::mem::swap(&mut self.past, &mut self.next);
        let size = match self.plan.rule.control {
            Control::Fixed(dt) => dt,
            Control::Tolerance(tolerance) => self.first_step(tolerance),
        };
        let (Control::Fixed(chosen) | Control::Tolerance(chosen)) = self.plan.rule.control;
        let trials = Trials::new(System::<S, R, C, P>::CLOSED > 0, chosen, self.past.time);
        self.progress = Progress::at(self.past.time, size, trials);
        self.show(Shown::Past, false);
        self.value = self.value(Shown::Past)?;
        Ok(())
    }

    /// Takes up what another run has left.
    pub(super) fn take_up(&mut self, memory: &K::Memory) -> Result<(), Error> {
        self.check()?;
        self.stepper.restore(memory);
        // An event where it stands was seen.
        self.value = if self.progress.stopped { None } else { self.value(Shown::Past)? };
        self.progress.stopped = false;
        Ok(())
    }

    /// The next step that is accepted; `false` where the run has ended, at its end or at an event.
    ///
    /// # Errors
    /// What kept it from a finite motion within the tolerance; the motion is then that before the step.
    pub fn step(&mut self) -> Result<bool, Error> {
        if self.progress.stopped || self.past.time >= self.end {
            return Ok(false);
        }
        let (size, last) = self.accepted()?;
        if last {
            self.next.time = self.end;
        }
        self.progress.steps += 1;
        self.progress.mark.1 += 1;
        let next_value = self.value(Shown::Next)?;
        if let Outcome::Stop = self.shown(self.progress.start, size, [self.value, next_value])? {
            self.progress.stopped = true;
            self.progress.mark = (self.past.time, 0);
            return Ok(false);
        }
        self.value = next_value;
        core::mem::swap(&mut self.past, &mut self.next);
        Ok(true)
    }

    /// Tries steps until one is accepted; gives its size (s), and whether it is the last.
    fn accepted(&mut self) -> Result<(RealOf<S>, bool), Error> {
        let one = RealOf::<S>::one();
        let mut trials = self.progress.trials;
        loop {
            // Fixed steps end at multiples of their size, without the rounding of a running sum.
            let planned = match self.plan.rule.control {
                Control::Fixed(dt) => {
                    let (mark, count) = self.progress.mark;
                    mark + dt * RealOf::<S>::of((count + 1) as f64) - self.past.time
                }
                Control::Tolerance(tolerance) => {
                    // What a method proposes it has found wanting, if a step was rejected.
                    let proposed = match self.progress.careful {
                        true => None,
                        false => self.stepper.propose(&self.past, self.plan.loads, tolerance),
                    };
                    let wanted = proposed.unwrap_or(self.progress.size);
                    self.plan.longest.map_or(wanted, |longest| wanted.min(longest))
                }
            };
            // The last step lands on the end; it may be longer by rounding.
            let remaining = self.end - self.past.time;
            let last = remaining <= planned * (one + RealOf::<S>::EPSILON * RealOf::<S>::of(1e6));
            let size = if last { remaining } else { planned };
            if let Control::Tolerance(_) = self.plan.rule.control {
                trials.count(self.past.time, size).map_err(|error| self.named(error))?;
            }
            let outcome = self.stepper.advance(&self.past, self.plan.loads, size, &mut self.next);
            let Control::Tolerance(tolerance) = self.plan.rule.control else {
                outcome?;
                return Ok((size, last));
            };
            let error = self.judge(outcome, size, tolerance, &mut trials)?;
            let factor = factor(error, self.stepper.error_order());
            let other = if !trials.accepts(error) {
                Some(trials.after(size, error, factor))
            } else if error <= one && !last {
                self.dodge(size, &mut trials)
            } else {
                None
            };
            if let Some(other) = other {
                self.progress.rejected += 1;
                self.progress.careful = true;
                self.progress.size = other;
                continue;
            }
            trials.taken(size);
            self.progress.trials = trials;
            // No growth right after a rejection, and none from a step cut short by the end.
            let factor = if self.progress.careful || last { factor.min(one) } else { factor };
            self.progress.careful = false;
            self.progress.size = size * factor;
            return Ok((size, last));
        }
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

    /// The error of a trial step as a multiple of the tolerance: infinite where its outcome is no motion, though the past one is sound.
    fn judge(
        &mut self,
        outcome: Result<(), Error>,
        size: RealOf<S>,
        tolerance: RealOf<S>,
        trials: &mut Trials<RealOf<S>>,
    ) -> Result<RealOf<S>, Error> {
        let Self { stepper, past, next, .. } = self;
        let mut estimate = |size_of: &MotionOf<S, R, C, P>| {
            let error = stepper.error(past, size, size_of, tolerance).unwrap_or(RealOf::<S>::zero());
            if error.is_finite() { error } else { RealOf::<S>::INFINITY }
        };
        let Err(refused) = outcome else {
            let error = estimate(next);
            if !trials.accepts(error) {
                trials.inaccurate();
            } else if trials.startled()
                && let Err(dependent) = self.stands()
            {
                trials.blocked(dependent)?;
                return Ok(RealOf::<S>::INFINITY);
            }
            return Ok(error);
        };
        trials.failed(refused)?;
        if let Fault::AngleOutOfRange { .. } = refused.fault {
            // A step that is far too long may leap anywhere: its error by the size of the past motion says so.
            let leap = estimate(past);
            return if leap > RealOf::<S>::one() { Ok(leap) } else { Err(refused) };
        }
        Ok(RealOf::<S>::INFINITY)
    }

    /// The size of another step, to be tried instead of an accurate one that ends where closures are all but dependent.
    fn dodge(&self, size: RealOf<S>, trials: &mut Trials<RealOf<S>>) -> Option<RealOf<S>> {
        // A constant, so that a compiler does not even look at what follows where nothing is closed.
        if const { System::<S, R, C, P>::CLOSED == 0 } {
            return None;
        }
        let firm = self.stepper.firm(&self.next, trials.least_share()?);
        trials.dodge(size, firm)
    }

    /// Whether closures are independent at the end of a step: where they are not, a motion could go on in more than one way.
    #[cold]
    fn stands(&mut self) -> Result<(), Error> {
        self.between.clone_from(&self.next);
        let system = self.plan.system;
        system.accelerate(&mut self.between, self.plan.loads, &mut system.workspace())
    }

    /// This error; closures that have become dependent where a run does not come on are named.
    fn named(&mut self, error: Error) -> Error {
        let Fault::StepTooSmall { step, cause: Cause::Inaccurate } = error.fault else { return error };
        let (system, mut workspace) = (self.plan.system, self.plan.system.workspace());
        self.next.clone_from(&self.past);
        match system.accelerate(&mut self.next, self.plan.loads, &mut workspace) {
            Err(Error { fault, place, .. }) => {
                let cause = Cause::of(fault).unwrap_or(Cause::Inaccurate);
                Error { place, fault: Fault::StepTooSmall { step, cause }, ..error }
            }
            Ok(()) => error,
        }
    }

    /// The value of the event function, if there is one.
    ///
    /// # Errors
    /// [`Fault::NotFinite`] where it is not a number, whose sign says nothing.
    fn value(&mut self, which: Shown) -> Result<Option<S::Scalar>, Error> {
        let Self { plan, past, next, between, .. } = self;
        let stepped = which.of(past, next, between);
        let (find, found) = (Self::FIND, OnceCell::new());
        let now = Now { system: plan.system, stepped, loads: plan.loads, event: false, find, found };
        let value = plan.event.value(&now);
        let number = value.is_none_or(|value| value.real() == value.real());
        let fault = Fault::NotFinite { parameter: "value of the event function" };
        if number { Ok(value) } else { Err(Error::new(fault).at_time(stepped.time.as_f64())) }
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
    fn shown(&mut self, start: RealOf<S>, size: RealOf<S>, values: [Option<S::Scalar>; 2]) -> Result<Outcome, Error> {
        let crossing = match values.map(|value| value.map(|value| value.real().as_f64())) {
            [Some(before), Some(after)] if before != 0.0 && before * after <= 0.0 => {
                Some(self.crossing(size, [before, after])?)
            }
            _ => None,
        };
        if let Some(theta) = crossing {
            self.samples_until(start, size, theta);
            self.interpolate(size, theta);
            self.show(Shown::Between, true);
            if self.plan.stop {
                core::mem::swap(&mut self.past, &mut self.between);
                return Ok(Outcome::Stop);
            }
        }
        self.samples_until(start, size, 1.0);
        if self.plan.every.is_none() {
            self.show(Shown::Next, false);
        }
        Ok(Outcome::Continue)
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
            let time = start + every * RealOf::<S>::of(self.progress.samples as f64);
            let theta = ((time - self.past.time) / size).as_f64();
            if theta > share + slack {
                return;
            }
            self.progress.samples += 1;
            if theta >= 1.0 - slack {
                self.show(Shown::Next, false);
            } else {
                self.interpolate(size, theta);
                self.show(Shown::Between, false);
            }
        }
    }

    /// The share of the step at which the event function crosses zero.
    fn crossing(&mut self, size: RealOf<S>, values: [f64; 2]) -> Result<f64, Error> {
        crossing(values, |theta| {
            self.interpolate(size, theta);
            Ok(self.value(Shown::Between)?.map_or(0.0, |value| value.real().as_f64()))
        })
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
