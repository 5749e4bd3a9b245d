//! Where in a step a mode changes: guessed by dense output, and found by steps made anew.

use super::crossing::crossing_within;
use super::cut::HALVINGS;
use super::drive::Running;
use super::margin::nearness;
use super::now::settled;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mirror::{Mode, Told};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
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

    /// Makes the step anew, as long as a share of it; gives the least margin at its end.
    pub(super) fn made_anew(&mut self, memory: &K::Memory, size: RealOf<S>, share: f64) -> Result<f64, Error> {
        self.make_anew(memory, size * RealOf::<S>::of(share))?;
        Ok(self.margin_ahead())
    }

    /// Where in the step a mode changes, as far as dense output tells, between one share and another with margins on either side of zero, and how fast the
    /// margin falls there.
    pub(super) fn guessed(
        &mut self,
        size: RealOf<S>,
        [mut low, mut high]: [(f64, f64); 2],
    ) -> Result<Option<(f64, f64)>, Error> {
        let mut within = |theta: f64| {
            self.interpolate(size, theta);
            Self::margins(&mut settled(self.plan.system, self.plan.loads, &self.between)).0
        };
        let mut share = high.0;
        for _ in 0..HALVINGS {
            if low.1 > 0.0 {
                break;
            }
            share *= 0.5;
            let margin = within(share);
            *(if margin > 0.0 { &mut low } else { &mut high }) = (share, margin);
        }
        if !(low.1 > 0.0 && high.1 < 0.0) {
            return Ok(None);
        }
        let (below, width) = (low.0, high.0 - low.0);
        let found = crossing_within::<Error>(GUESS, [low.1, high.1], &mut |theta| Ok(within(below + theta * width)))?;
        let (share, before) = (below + found * width, below + (1.0 - BESIDE) * found * width);
        let slope = (within(share) - within(before)) / (share - before);
        Ok((slope < 0.0).then_some((share, slope)))
    }

    /// Ends the step that ends beyond a stop a little earlier, at the stop. Gives its size (s).
    pub(super) fn at_stop(&mut self, memory: &K::Memory, size: RealOf<S>, share: f64) -> Result<RealOf<S>, Error> {
        let mut share = share;
        // What strikes has been found a little beyond its stop, where it is faster by what it has fallen since.
        for _ in 0..NEWTON {
            let back = self.beyond() / size.as_f64();
            if !(back > 0.0 && back < 0.5 * share) {
                break;
            }
            share -= back;
            self.made_anew(memory, size, share)?;
        }
        Ok(size * RealOf::<S>::of(share))
    }
}
