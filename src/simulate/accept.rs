//! Trial steps of a run: judged, and repeated until one is accepted.

use super::drive::Running;
use super::trials::{factor, rough_factor};
use super::{EventFunction, Now, Progress};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Cause, Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::Dynamics;
use crate::system::{MotionOf, Runs, System};
use crate::time::Control;
use num_traits::{One, Zero};

/// A step that is accepted.
#[derive(Clone, Copy)]
pub(super) struct Taken<R> {
    /// Size of the step (s).
    pub(super) size: R,
    /// Whether the step ends the run.
    pub(super) last: bool,
    /// The size (s) that the step would have had, if it was cut for a kink.
    pub(super) cut: Option<R>,
    /// Whether a kink is where the step ends.
    pub(super) kink: bool,
    /// Whether a mode changes where the step ends.
    pub(super) switches: bool,
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
    /// Tries steps until one is accepted.
    pub(super) fn accepted(&mut self) -> Result<Taken<RealOf<S>>, Error> {
        let one = RealOf::<S>::one();
        loop {
            // Fixed steps end at multiples of their size, without the rounding of a running sum.
            let planned = match self.plan.rule.control {
                Control::Fixed(dt) => {
                    let (mark, count) = self.progress.mark;
                    mark + dt * RealOf::<S>::of((count + 1) as f64) - self.past.time
                }
                Control::Tolerance(tolerance) => {
                    // What a method proposes it has found wanting, if a step was rejected; asked, it knows the tolerance.
                    let proposed = self.stepper.propose(&self.past, self.plan.loads, tolerance);
                    let wanted = proposed.filter(|_| !self.progress.careful).unwrap_or(self.progress.size);
                    self.plan.longest.map_or(wanted, |longest| wanted.min(longest))
                }
            };
            // The last step lands on the end; it may be longer by rounding, in `f32` by a thousandth.
            let remaining = self.end - self.past.time;
            let rounding = (RealOf::<S>::EPSILON * RealOf::<S>::of(1e6)).min(RealOf::<S>::of(1e-3));
            let last = remaining <= planned * (one + rounding);
            let size = match self.plan.rule.control {
                _ if last => remaining,
                Control::Fixed(_) => planned,
                Control::Tolerance(_) => clocked(self.past.time, planned),
            };
            if let Control::Tolerance(tolerance) = self.plan.rule.control
                && let Err(error) = self.progress.trials.count(self.past.time, size)
            {
                return Err(self.given_up(error, tolerance));
            }
            let mut outcome = self.stepper.advance(&self.past, self.plan.loads, size, &mut self.next);
            let (size, last) = match self.plan.rule.control {
                Control::Tolerance(_) if outcome.is_ok() => self.made(size, last),
                _ => (size, last),
            };
            let mut taken = Taken { size, last, cut: None, kink: false, switches: false };
            if const { Self::KINKS > 0 } && outcome.is_ok() {
                outcome = self.end_at_kink(&mut taken);
                // Of where a step begins a shorter one says nothing else.
                if let Err(error) = outcome
                    && error.time == Some(self.past.time.as_f64())
                {
                    return Err(error);
                }
            }
            let Control::Tolerance(tolerance) = self.plan.rule.control else {
                outcome?;
                return Ok(taken);
            };
            let Taken { size, last, cut, .. } = taken;
            let error = self.judge(outcome, size, tolerance)?;
            let trials = &mut self.progress.trials;
            let accepts = trials.accepts(error);
            let order = self.stepper.error_order();
            let factor = if K::PLANS && accepts { rough_factor(error, order) } else { factor(error, order) };
            let other = if !accepts {
                Some(trials.after(size, error, factor))
            } else if error <= one && !last {
                self.dodge(size)
            } else {
                None
            };
            if let Some(other) = other {
                self.progress.rejected += 1;
                self.progress.careful = true;
                self.progress.size = other;
                continue;
            }
            self.progress.trials.taken(size);
            // No growth right after a rejection, and none from a step cut short by the end.
            let factor = if self.progress.careful || last { factor.min(one) } else { factor };
            self.progress.careful = false;
            // Nor says one cut for a kink how long those after it should be.
            self.progress.size = cut.unwrap_or(size * factor);
            return Ok(taken);
        }
    }

    /// The size (s) of the step that was made and whether it ends the run: a method may have ended it early.
    fn made(&self, size: RealOf<S>, last: bool) -> (RealOf<S>, bool) {
        let made = self.next.time - self.past.time;
        let early = made > RealOf::<S>::zero() && made < size * RealOf::<S>::of(0.5);
        if early { (made, false) } else { (size, last) }
    }

    /// A first step from the size of motion and accelerations (Hairer, Nørsett, Wanner, II.4, without its trial step).
    pub(super) fn first_step(&self, tolerance: RealOf<S>) -> RealOf<S> {
        let one = RealOf::<S>::one();
        let (mut size, mut slope) = (RealOf::<S>::zero(), RealOf::<S>::zero());
        let mut note = |rate: S::Scalar, value: S::Scalar| {
            let value = value.real();
            size = size.max(value / (one + value));
            slope = slope.max(rate.real().abs() / (one + value));
        };
        self.past.position.measure(&self.past.rate, &mut note);
        self.past.acceleration.all(&self.past.rate, &mut |acceleration, rate| {
            note(acceleration, rate.abs());
            true
        });
        let tiny = RealOf::<S>::of(1e-6);
        let small = if size < tiny || slope < tiny { tiny } else { RealOf::<S>::of(0.01) * size / slope };
        let exponent = one / RealOf::<S>::of(self.stepper.error_order() as f64);
        let safe = (RealOf::<S>::of(0.01) * tolerance / slope.max(tiny)).powf(exponent);
        // A first trial that does not advance time would be blamed for errors.
        let least = self.past.time.abs() * RealOf::<S>::EPSILON * RealOf::<S>::of(4.0);
        (small * RealOf::<S>::of(100.0)).min(safe).max(least)
    }

    /// The error of a trial step as a multiple of the tolerance: infinite where its outcome is no motion, though the past one is sound.
    fn judge(&mut self, outcome: Result<(), Error>, size: RealOf<S>, tolerance: RealOf<S>) -> Result<RealOf<S>, Error> {
        let Self { stepper, past, next, progress: Progress { trials, .. }, .. } = self;
        let mut estimate = |size_of: &MotionOf<S, R, C, P>| {
            let unknown = Fault::Unsupported { what: "error control by a method that does not estimate its errors" };
            let error = stepper.error(past, size, size_of, tolerance).ok_or(Error::new(unknown))?;
            Ok::<_, Error>(if error.is_finite() { error } else { RealOf::<S>::INFINITY })
        };
        let Err(refused) = outcome else {
            let error = estimate(next)?;
            if !trials.accepts(error) {
                trials.inaccurate();
            } else if trials.startled()
                && let Err(dependent) = self.stands()
            {
                self.progress.trials.blocked(dependent)?;
                return Ok(RealOf::<S>::INFINITY);
            }
            return Ok(error);
        };
        trials.failed(refused)?;
        if let Fault::AngleOutOfRange { .. } = refused.fault {
            // A step that is far too long may leap anywhere: its error by the size of the past motion says so.
            let leap = estimate(past)?;
            return if leap > RealOf::<S>::one() { Ok(leap) } else { Err(refused) };
        }
        Ok(RealOf::<S>::INFINITY)
    }

    /// The size of another step, to be tried instead of an accurate one that ends where closures are all but dependent.
    fn dodge(&mut self, size: RealOf<S>) -> Option<RealOf<S>> {
        // A constant, so that a compiler does not even look at what follows where nothing is closed.
        if const { System::<S, R, C, P>::CLOSED == 0 } {
            return None;
        }
        let trials = &mut self.progress.trials;
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

    /// This error, after which the run may be tried again as from a start: what was in its way may be gone. Closures that have become
    /// dependent where it does not come on are named.
    #[cold]
    fn given_up(&mut self, error: Error, tolerance: RealOf<S>) -> Error {
        self.progress.size = self.first_step(tolerance);
        self.progress.trials.renew(self.past.time);
        self.named(error)
    }

    /// This error, with the closures that have become dependent.
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
}

/// A step of this size (s) or hardly less that takes the motion as far as its clock, which rounds; of this size where that does not move the clock.
fn clocked<R: Real>(time: R, size: R) -> R {
    let ahead = (time + size) - time;
    // As many roundings of the clock less as may be one.
    let less = (time + (ahead - R::EPSILON * (time.abs() + ahead))) - time;
    let found = if ahead <= size { ahead } else { less };
    if found > R::zero() { found } else { size }
}
