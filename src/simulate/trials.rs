//! Trial steps under error control: what is made of one that is rejected, and when a run has tried enough.

use crate::error::{Cause, Error, Fault, Place};
use crate::scalar::Real;
use crate::stepper::roots::{inverse_root, power};
use crate::time::Control;

/// In so many trial steps a run must advance by more than [`ADVANCE`], or half of them must be taken: one that has coasted for long may go on
/// in steps that are short beside those, and has no difficulty.
const WINDOW: usize = 1000;
/// A share of the longest step that the run has taken.
const ADVANCE: f64 = 1e-6;

/// An error that is no matter of the step's size, as a multiple of the tolerance: the step met it unawares.
const STARTLING: f64 = 100.0;
/// The largest error that is kept: infinity is no data.
const LARGEST: f64 = 1e30;
/// Steps somewhat shorter that are tried first where closures may have become dependent within such a step, and by how much.
const EVASIONS: usize = 5;
const SHORTER: f64 = 0.8;
/// By how many times the error of such a step falls where it was a matter of where stages fell: by more than any order explains.
const FALL: f64 = 10.0;
/// So many times a step that ends where closures are all but dependent is tried shorter.
const DODGES: usize = 3;
/// Trial steps that are shorter than the best one and no better, before that is taken.
const WORSE: usize = 2;

/// The cause of a rejection that was not written.
#[cfg(feature = "serde")]
fn unknown() -> (Cause, Option<Place>) {
    (Cause::Inaccurate, None)
}

/// The trial steps of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Trials<R> {
    /// The error (as a multiple of the tolerance) that a step may have where shorter ones are no better, in a scene that closures hold
    /// together: near a place where they become dependent, errors rise as steps shrink.
    allowed: Option<R>,
    /// How small a pivot of a closure may be at the end of a step there, as a share of its measure.
    least: R,
    /// What was wrong with the last one that was rejected, and where.
    #[cfg_attr(feature = "serde", serde(skip, default = "unknown"))] // its words would have to outlive the text
    cause: (Cause, Option<Place>),
    /// The longest one accepted (s).
    longest: R,
    /// When the last window began (s), and the number of trials since.
    mark: R,
    count: usize,
    /// How many of these were taken.
    #[cfg_attr(feature = "serde", serde(default))]
    advances: usize,
    /// Of those from the present motion the most accurate: its size (s) and its error as a multiple of the tolerance.
    best: Option<(R, R)>,
    /// How many shorter ones were no better, the error of the last one, and how many have evaded.
    worse: usize,
    last: R,
    evasions: usize,
    /// Whether closures hold the present motion firmly, and how many steps from it would have ended where they do not.
    firm: bool,
    dodges: usize,
    /// Whether the next one is the best one again, to be taken.
    settled: bool,
}

impl<R: Real> Trials<R> {
    /// None yet, at a time (s).
    pub(super) fn new(time: R) -> Self {
        Self {
            allowed: None,
            least: R::zero(),
            cause: (Cause::Inaccurate, None),
            longest: R::zero(),
            mark: time,
            count: 0,
            advances: 0,
            best: None,
            worse: 0,
            last: R::zero(),
            evasions: 0,
            firm: true,
            dodges: 0,
            settled: false,
        }
    }

    /// These under a control of steps, whatever it was before.
    pub(super) fn under(&mut self, control: Control<R>, closed: bool) {
        (self.allowed, self.least) = (None, R::zero());
        if let Control::Tolerance(tolerance) = control {
            let (root, coarse) = (R::EPSILON.sqrt(), R::EPSILON.sqrt().sqrt());
            let allowed = (R::of(STARTLING) * tolerance.max(root)).min(coarse) / tolerance;
            self.allowed = (closed && tolerance < coarse).then_some(allowed);
            // A share δ² leaves roundings / δ³ of accelerations: that is to be no startling error.
            self.least = (R::EPSILON / (R::of(STARTLING) * tolerance)).powf(R::of(2.0 / 3.0));
        }
    }

    /// None since a time (s): the run is tried again.
    pub(super) fn renew(&mut self, time: R) {
        self.taken(R::zero());
        (self.mark, self.count, self.advances) = (time, 0, 0);
    }

    /// Whether trials can go on from here: what was read as data may be anything.
    pub(super) fn is_sound(&self) -> bool {
        let counts = [self.count, self.advances, self.worse, self.evasions, self.dodges];
        counts.iter().all(|count| *count <= usize::MAX / 2) && self.mark.is_finite() && self.longest.is_finite()
    }

    /// Whether a step with an error as a multiple of the tolerance is to be taken.
    pub(super) fn accepts(&self, error: R) -> bool {
        error <= R::one() || (self.settled && error < R::INFINITY) || self.evaded(error)
    }

    /// Whether a step somewhat shorter than one of a startling error errs by so much less that the size of steps is not what matters.
    fn evaded(&self, error: R) -> bool {
        self.evasions > 0 && self.allows(error) && error * R::of(FALL) < self.last
    }

    /// Whether an error is within what closures leave open of a position where they are dependent.
    fn allows(&self, error: R) -> bool {
        self.allowed.is_some_and(|most| error <= most)
    }

    /// Whether steps from the present motion have failed by more than their size.
    pub(super) fn startled(&self) -> bool {
        self.evasions > 0
    }

    /// The best step leads where a run cannot stay.
    pub(super) fn blocked(&mut self, error: Error) -> Result<(), Error> {
        (self.best, self.worse) = (None, 0);
        self.failed(error)
    }

    /// A step was taken.
    pub(super) fn taken(&mut self, size: R) {
        self.longest = self.longest.max(size);
        self.advances += 1;
        (self.best, self.worse, self.evasions, self.dodges, self.settled) = (None, 0, 0, 0, false);
    }

    /// How small a pivot of a closure may be at the end of a step, as a share of its measure, in a scene that closures hold together.
    pub(super) fn least_share(&self) -> Option<f64> {
        self.allowed.map(|_| self.least.as_f64())
    }

    /// The size to try instead of an accurate one where closures do not hold its end firmly, unless the motion comes from such a place
    /// or stays there: that of a longer step which leads over it, if there was one that errs by what such a step may, or a shorter one.
    pub(super) fn dodge(&mut self, size: R, firm: bool) -> Option<R> {
        if firm || !self.firm || self.dodges > DODGES {
            self.firm = firm;
            return None;
        }
        let tired = self.dodges == DODGES;
        self.dodges += 1;
        match self.best {
            Some((over, error)) if over > size && (error <= R::of(STARTLING) || (tired && self.allows(error))) => {
                self.settled = true;
                Some(over)
            }
            _ if tired => {
                self.firm = false;
                None
            }
            _ => Some(size * R::of(SHORTER)),
        }
    }

    /// A step failed: by what no shorter step would mend, or it counts as one that is not accurate at all.
    pub(super) fn failed(&mut self, error: Error) -> Result<(), Error> {
        self.cause = (Cause::of(error.fault).ok_or(error)?, error.place);
        Ok(())
    }

    /// A step was finite, but inaccurate.
    pub(super) fn inaccurate(&mut self) {
        self.cause = (Cause::Inaccurate, None);
    }

    /// The size to try after a step that was rejected, whose error (not NaN) calls for a change by `factor`.
    ///
    /// A step over a place where closures become dependent errs by where its stages happen to fall, and by the more the shorter it is:
    /// what rounding leaves open of the motion grows towards that place with the inverse square of the distance. So steps of about the
    /// same size are tried first. One that errs by far less is taken; and if shorter ones are no better the best one is, unless it errs
    /// by more than a hundred tolerances and a hundred roots of rounding: at the place itself closures say no more of a position than the
    /// root, and an estimate is that of a step not yet led back to its closures. Tolerances coarser than the fourth root of rounding are
    /// kept.
    pub(super) fn after(&mut self, size: R, error: R, factor: R) -> R {
        let shorter = size * factor.min(R::of(0.9));
        if self.allowed.is_none() || self.longest <= R::zero() {
            return shorter;
        }
        let error = error.min(R::of(LARGEST));
        self.last = error;
        match self.best {
            Some((_, least)) if error >= least => self.worse += 1,
            _ => (self.best, self.worse) = (Some((size, error)), 0),
        }
        if let Some((best, least)) = self.best
            && self.worse >= WORSE
            && self.allows(least)
            && !self.settled
        {
            self.settled = true;
            return best;
        }
        self.settled = false;
        if error > R::of(STARTLING) && self.evasions < EVASIONS {
            self.evasions += 1;
            return size * R::of(SHORTER);
        }
        shorter
    }

    /// Counts a trial step from a time (s); fails where the run hardly advances.
    pub(super) fn count(&mut self, time: R, size: R) -> Result<(), Error> {
        if time + size <= time {
            return Err(self.too_small(time, size));
        }
        self.count += 1;
        if self.count > WINDOW {
            if time - self.mark <= self.longest * R::of(ADVANCE) && 2 * self.advances < WINDOW {
                return Err(self.too_small(time, size));
            }
            (self.mark, self.count, self.advances) = (time, 1, 0);
        }
        Ok(())
    }

    fn too_small(&self, time: R, size: R) -> Error {
        let (cause, place) = self.cause;
        let fault = Fault::StepTooSmall { step: size.as_f64(), cause };
        Error { place, ..Error::new(fault).at_time(time.as_f64()) }
    }
}

/// By how much the next step should differ, for an error given as a multiple of the tolerance.
#[inline(always)] // the order is a constant of most methods
pub(super) fn factor<R: Real>(error: R, order: usize) -> R {
    if !error.is_finite() {
        return R::of(0.1);
    }
    limited(inverse_root(error.as_f64().max(1e-12), order))
}

/// That factor to three thousandths, for an error that is accepted.
#[inline]
pub(super) fn rough_factor<R: Real>(error: R, order: usize) -> R {
    limited(power(error.as_f64().max(1e-12), -1.0 / order as f64))
}

#[inline(always)]
fn limited<R: Real>(longer: f64) -> R {
    R::of(0.9 * longer).max(R::of(0.2)).min(R::of(6.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run that coasts for a day and then meets a stiff spring, of whose trial steps one in so many is taken: whether it may go on.
    fn goes_on(taken: usize) -> Result<(), Error> {
        let (mut trials, mut time, mut size) = (Trials::new(0.0), 0.0, 1e-3);
        while time < 86400.0 {
            trials.count(time, size)?;
            trials.taken(size);
            time += size;
            size *= 6.0;
        }
        for trial in 0..5000 {
            trials.count(time, 5e-6)?;
            if trial % taken == 0 {
                trials.taken(5e-6);
                time += 5e-6;
            }
        }
        Ok(())
    }

    #[test]
    fn short_steps_after_long_ones_are_no_failure_if_they_are_taken() {
        assert_eq!(goes_on(1), Ok(()));
        let fault = goes_on(10).map_err(|error| error.fault);
        assert_eq!(fault, Err(Fault::StepTooSmall { step: 5e-6, cause: Cause::Inaccurate }));
    }
}
