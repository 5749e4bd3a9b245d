//! Where in a step a mode changes: guessed by dense output, and found by steps made anew.

use super::crossing::{bracketed, crossing, crossing_within, polished};
use super::drive::Running;
use super::now::settled;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mirror::margin::nearness;
use crate::mirror::{Mode, Told};
use crate::scalar::{Real, Scalar};
use crate::stepper::{Stepper, inconsistent};
use crate::system::{Runs, System};

/// So many corrections put the end of a step where a joint meets its stop.
const NEWTON: usize = 3;
/// To such a width of its range a guess is found: dense output errs by more.
const GUESS: f64 = 1e-6;
/// So large a share of where a mode changes is far enough before that for a slope.
const BESIDE: f64 = 1e-3;

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
    /// Ends the step of a size (s) where a mode changes, if a margin is below zero at a share of it. Gives its size then.
    ///
    /// # Errors
    /// Those of the rule; [`Cause::Modes`](crate::Cause::Modes) where no margin is above zero before.
    pub(super) fn located(&mut self, size: RealOf<S>, high: (f64, f64)) -> Result<RealOf<S>, Error> {
        let memory = self.stepper.memory();
        // One that has just begun to slip is at rest where the step begins.
        let (margin, least) = self.margin_here();
        let range = [(0.0, margin), high];
        let guess = self.guessed(size, range)?;
        let mut made_anew = |share| {
            self.make_anew(&memory, size * RealOf::<S>::of(share))?;
            Ok::<_, Error>(self.margin_ahead())
        };
        if let Some(guess) = guess
            && let Some(share) = polished(guess, high.0, &mut made_anew)?
        {
            return self.at_stop(&memory, size, share);
        }
        let Some([low, high]) = bracketed(range, &mut made_anew)? else {
            return Err(inconsistent(least, self.past.time));
        };
        let (width, below) = (high.0 - low.0, low.0);
        let within = crossing([low.1, high.1], &mut |theta| made_anew(below + theta * width))?;
        self.at_stop(&memory, size, below + within * width)
    }

    /// Where in the step a mode changes, as far as dense output tells, in a range of shares with their margins, and how fast the margin falls there.
    fn guessed(&mut self, size: RealOf<S>, range: [(f64, f64); 2]) -> Result<Option<(f64, f64)>, Error> {
        let mut within = |theta: f64| {
            self.interpolate(size, theta);
            Ok::<_, Error>(Self::margins(&mut settled(self.plan.system, self.plan.loads, &self.between)).0)
        };
        let found = bracketed(range, &mut within)?;
        let Some([low, high]) = found.filter(|[_, high]| high.1 < 0.0) else { return Ok(None) };
        let (below, width) = (low.0, high.0 - low.0);
        let found = crossing_within(GUESS, [low.1, high.1], &mut |theta| within(below + theta * width))?;
        let (share, before) = (below + found * width, below + (1.0 - BESIDE) * found * width);
        let slope = (within(share)? - within(before)?) / (share - before);
        Ok((slope < 0.0).then_some((share, slope)))
    }

    /// For how long the joint that is to change its mode has been beyond its stop (s), if it strikes one.
    fn beyond(&mut self) -> f64 {
        let mut next = settled(self.plan.system, self.plan.loads, &self.next);
        let earliest = Self::margins(&mut next).1;
        let beyond = |(mode, rate, told): (Mode, S::Scalar, Told<S::Scalar>)| {
            let near = nearness(mode, &told).filter(|near| *near > 1.0);
            near.map_or(0.0, |_| -(told.apart / rate).real().as_f64())
        };
        Self::joint(&mut next, earliest).map_or(0.0, beyond)
    }

    /// Ends the step that ends beyond a stop a little earlier, at the stop. Gives its size (s).
    fn at_stop(&mut self, memory: &K::Memory, size: RealOf<S>, share: f64) -> Result<RealOf<S>, Error> {
        let mut share = share;
        // What strikes has been found a little beyond its stop, where it is faster by what it has fallen since.
        for _ in 0..NEWTON {
            let back = self.beyond() / size.as_f64();
            if !(back > 0.0 && back < 0.5 * share) {
                break;
            }
            share -= back;
            self.make_anew(memory, size * RealOf::<S>::of(share))?;
        }
        Ok(size * RealOf::<S>::of(share))
    }
}
