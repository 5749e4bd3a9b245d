//! Where a load has a kink within a step, which ends there.

use super::accept::Taken;
use super::crossing::{crosses, crossing, departure};
use super::drive::Running;
use super::shown::Shown;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Runs, System};
use crate::time::Control;

/// Under error control a step whose kink lies beyond this share of what was tried ends before it, at a share of the way.
const CLOSE: f64 = 0.15;
const NEAR: f64 = 0.9;
/// A function that has more than this share of its value before where a step ends near its zero has none there.
const DISTANT: f64 = 0.5;
/// Where dense output was wrong of a kink nearby a step of this share is looked at.
const SHORTER: f64 = 0.2;
/// The share of its value before at which a function is about zero.
const ABOUT: f64 = 1e-2;
/// By how much more than what ends a step at zero a function may differ from zero where the next one begins, beside its end.
const BEGUN: f64 = 64.0;

/// A function that crosses zero within a step: which one, and where.
struct Crossing {
    number: usize,
    /// Share of the step from which the function is looked at, and value there.
    from: (f64, f64),
    /// Value at the end of the step.
    end: f64,
    /// Share at which dense output has the function zero.
    share: f64,
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
    /// Number of functions at whose zeros steps end.
    pub(super) const KINKS: usize = <E as EventFunction<Now<'a, S, R, C, P, L>, S::Scalar>>::KINKS;

    /// Up to this share of its value before, a function that ends a step is zero there: what a step errs by that is of higher order.
    fn nothing() -> f64 {
        0.05 * RealOf::<S>::EPSILON.sqrt().as_f64()
    }

    /// Ends a trial step where the first of all functions crosses zero, if one does: by steps made anew, so that the rule's order is that of
    /// the place found.
    pub(super) fn end_at_kink(&mut self, step: &mut Taken<RealOf<S>>) -> Result<(), Error> {
        let mut found = match self.plan.rule.control {
            Control::Fixed(_) => self.first_kink(step.size, Self::nothing())?,
            Control::Tolerance(_) => self.about_kink(step)?,
        };
        // A step made shorter may have another kink before its end, of which dense output of the longer one did not know.
        for _ in 0..=Self::KINKS {
            let Some(crossing) = found else { break };
            (step.cut, step.kink) = (step.cut.or(Some(step.size)), true);
            if crossing.share >= 1.0 {
                break;
            }
            (step.size, step.last) = (self.made_up_to(&crossing, step.size)?, false);
            found = self.first_kink(step.size, Self::nothing())?;
        }
        Ok(())
    }

    /// Makes a trial step shorter, so that it ends about where the first of all functions crosses zero, or before; gives the one that crosses zero in it.
    fn about_kink(&mut self, step: &mut Taken<RealOf<S>>) -> Result<Option<Crossing>, Error> {
        let memory = self.stepper.memory();
        let anew = |run: &mut Self, step: &mut Taken<RealOf<S>>, size: RealOf<S>| {
            (step.size, step.last) = (size, false);
            run.make_anew(&memory, size)
        };
        while let Some(about) = self.first_kink(step.size, ABOUT)? {
            let (tried, share) = (step.size, about.share);
            // A step that is long leads near that place first: its stages err by more than its end, and would lie beyond. If it was far
            // too long, dense output is wrong: a place nearby is looked for in a step that is short.
            if share > CLOSE {
                anew(self, step, tried * RealOf::<S>::of(NEAR * share))?;
                self.evaluate(Shown::Next);
                let (before, value) = (about.from.1, self.kink(about.number, Shown::Next)?);
                step.cut = (value.abs() <= DISTANT * before.abs()).then_some(tried);
                return if crosses([before, value]) { self.first_kink(step.size, Self::nothing()) } else { Ok(None) };
            }
            anew(self, step, tried * RealOf::<S>::of(2.0 * share))?;
            let found = self.first_kink(step.size, Self::nothing())?;
            if found.is_some() {
                step.cut = Some(tried);
                return Ok(found);
            }
            anew(self, step, tried * RealOf::<S>::of(SHORTER))?;
        }
        Ok(None)
    }

    /// The function that crosses zero first, by dense output: there it is nothing beside its value before.
    fn first_kink(&mut self, size: RealOf<S>, nothing: f64) -> Result<Option<Crossing>, Error> {
        let begun = self.progress.mark.1 == 0;
        [Shown::Past, Shown::Next].into_iter().for_each(|which| self.evaluate(which));
        let mut first: Option<Crossing> = None;
        for number in 0..Self::KINKS {
            let [before, end] = [self.kink(number, Shown::Past)?, self.kink(number, Shown::Next)?];
            if before == 0.0 && end == 0.0 {
                continue; // it is zero all along, as far as one sees
            }
            let from = if begun {
                departure([before, end], BEGUN * Self::nothing(), &mut |theta| self.kink_at(number, size, theta))?
            } else {
                (0.0, before)
            };
            let share = if end.abs() <= Self::nothing() * from.1.abs() {
                1.0
            } else if crosses([from.1, end]) {
                let share = |part: f64| from.0 + (1.0 - from.0) * part;
                let nothing = nothing * from.1.abs();
                share(crossing([from.1, end], &mut |part| {
                    self.kink_at(number, size, share(part))
                        .map(|value| if value.abs() <= nothing { 0.0 } else { value })
                })?)
            } else {
                continue;
            };
            if share <= self.least_share(size) {
                continue; // it has jumped where the step begins
            }
            if first.as_ref().is_none_or(|first| share < first.share) {
                first = Some(Crossing { number, from, end, share });
            }
        }
        Ok(first)
    }

    /// Makes the step anew, up to where a function is zero; gives its size (s).
    fn made_up_to(&mut self, found: &Crossing, size: RealOf<S>) -> Result<RealOf<S>, Error> {
        let Crossing { number, from, end, share } = *found;
        let (memory, nothing) = (self.stepper.memory(), Self::nothing() * from.1.abs());
        let mut made = |theta: f64| {
            self.make_anew(&memory, size * RealOf::<S>::of(theta))?;
            self.evaluate(Shown::Next);
            let value = self.kink(number, Shown::Next)?;
            Ok::<_, Error>(if value.abs() <= nothing { 0.0 } else { value })
        };
        let value = made(share)?;
        let (low, high) = if crosses([from.1, value]) { (from, (share, value)) } else { ((share, value), (1.0, end)) };
        if value == 0.0 {
            return Ok(size * RealOf::<S>::of(share));
        }
        let within = |part: f64| low.0 + (high.0 - low.0) * part;
        let share = within(crossing([low.1, high.1], &mut |part| made(within(part)))?);
        let least = self.least_share(size);
        if share <= least {
            self.make_anew(&memory, size * RealOf::<S>::of(2.0 * least))?;
        }
        Ok(size * RealOf::<S>::of(if share <= least { 2.0 * least } else { share }))
    }

    /// The share of a step that advances time by some roundings.
    fn least_share(&self, size: RealOf<S>) -> f64 {
        (self.past.time.abs() * RealOf::<S>::EPSILON / size).as_f64() * 8.0 + f64::EPSILON * 8.0
    }

    /// The value of one of the functions at a share of the step.
    fn kink_at(&mut self, number: usize, size: RealOf<S>, theta: f64) -> Result<f64, Error> {
        self.interpolate(size, theta);
        self.evaluate(Shown::Between);
        self.kink(number, Shown::Between)
    }

    /// Finds the values of all functions at a motion.
    fn evaluate(&mut self, which: Shown) {
        self.seen(which, false, |functions, _, now| functions.look(now, which as usize));
    }

    /// The value of one of the functions that was found at a motion.
    fn kink(&self, number: usize, which: Shown) -> Result<f64, Error> {
        let value = self.plan.event.kink(number, which as usize);
        self.a_number(which, value, "value of a function of kinks")
    }
}
