//! Joints that stick and slip in a run: where their modes change, and which follow.

use super::EventFunction;
use super::crossing::crossing;
use super::drive::Running;
use super::{Now, settled};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Cause, Error, Fault};
use crate::mirror::{Mode, Position};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, PositionOf, Runs, System};
use num_traits::Zero;

/// Halvings of a step in which a joint moves on before it comes to rest.
const HALVINGS: i32 = 40;
/// Changes of mode at one instant before it is clear that none are consistent.
const CHANGES: usize = 64;

/// How far a joint is from a change of its mode: positive before.
fn margin<T: Scalar>(mode: Mode, rate: T, friction: T) -> f64 {
    match mode {
        Mode::Sticks => 1.0 - friction.real().as_f64().abs(),
        slips => (slips.sign::<T>() * rate).real().as_f64(),
    }
}

/// The mode of a joint that breaks away: it goes where friction does not hold it.
fn broken_away<T: Scalar>(friction: T) -> Mode {
    Mode::of(-friction)
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
    /// Whether there are joints that stick and slip.
    pub(super) const STICKS: bool = PositionOf::<S, R, C>::STICKS;

    /// Refuses numbers whose derivatives or lanes would have changes of mode of their own.
    pub(super) fn sticks_by_numbers(&self) -> Result<(), Error> {
        if Self::STICKS && size_of::<S::Scalar>() > size_of::<RealOf<S>>() {
            let what = "derivatives or lanes of a run in which joints stick and slip";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        Ok(())
    }

    /// The least margin of the joints at a motion, and which joint has it.
    fn margins(motion: &mut MotionOf<S, R, C, P>) -> (f64, usize) {
        let (mut least, mut count) = ((f64::INFINITY, 0), 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, [_, friction]| {
            let margin = margin(*mode, *rate, friction);
            if margin < least.0 {
                least = (margin, count);
            }
            count += 1;
        });
        least
    }

    /// The least margin at the end of the step, with the accelerations that belong to it.
    fn margin_ahead(&mut self) -> f64 {
        if K::SETTLED {
            return Self::margins(&mut self.next).0;
        }
        Self::margins(&mut settled(self.plan.system, self.plan.loads, &self.next)).0
    }

    /// Makes the step anew, as long as a share of it, with what the stepper carried after it.
    fn made_anew(&mut self, memory: &K::Memory, size: RealOf<S>, share: f64) -> Result<f64, Error> {
        self.stepper.restore(memory);
        self.stepper.advance(&self.past, self.plan.loads, size * RealOf::<S>::of(share), &mut self.next)?;
        Ok(self.margin_ahead())
    }

    /// Ends the step where the first of all joints is to change its mode, if one is: by steps made anew, so that the rule's order is that of
    /// the place found. Gives the size of the step (s).
    pub(super) fn cut(&mut self, size: RealOf<S>) -> Result<Option<RealOf<S>>, Error> {
        let mut high = (1.0, self.margin_ahead());
        if high.1.is_nan() || high.1 >= 0.0 {
            return Ok(None);
        }
        let memory = self.stepper.memory();
        let mut low = (0.0, Self::margins(&mut self.past).0);
        // One that has just begun to slip is at rest where the step begins.
        let mut share = 1.0;
        for _ in 0..HALVINGS {
            if low.1 > 0.0 {
                break;
            }
            share *= 0.5;
            let margin = self.made_anew(&memory, size, share)?;
            if margin > 0.0 {
                low = (share, margin);
            } else {
                high = (share, margin);
            }
        }
        if low.1 <= 0.0 {
            return Err(self.inconsistent(self.past.time));
        }
        let (width, below) = (high.0 - low.0, low.0);
        let within = crossing([low.1, high.1], |theta| self.made_anew(&memory, size, below + theta * width))?;
        Ok(Some(size * RealOf::<S>::of(below + within * width)))
    }

    /// Changes the mode of the joint that has ended the step, and of those that change with it.
    pub(super) fn switch(&mut self) -> Result<(), Error> {
        let mut next = settled(self.plan.system, self.plan.loads, &self.next);
        let (earliest, mut count) = (Self::margins(&mut next).1, 0);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, [_, friction]| {
            let due = count == earliest;
            count += 1;
            if *mode == Mode::Sticks {
                if due {
                    *mode = broken_away(friction);
                }
            } else if due || margin(*mode, *rate, friction) <= 0.0 {
                (*mode, *rate) = (Mode::Sticks, S::Scalar::zero());
            }
        });
        self.next = next;
        self.settle_modes(Some(earliest))
    }

    /// Finds modes that belong together where the next step begins, and the accelerations there: what friction does not hold breaks away,
    /// the joint first that it holds least. At a start they follow from its rates; elsewhere one joint has just changed its mode.
    pub(super) fn settle_modes(&mut self, changed: Option<usize>) -> Result<(), Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let (mut workspace, next) = (Dynamics::<L>::workspace(system), &mut self.next);
        if changed.is_none() {
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, _| *mode = Mode::of(*rate));
        }
        for _ in 0..CHANGES {
            system.accelerate(next, loads, &mut workspace)?;
            // Held least, or pushed back where it is about to slip.
            let (mut worst, mut count) = ((1.0, None), 0);
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, [second, friction]| {
                let pull = friction.real().as_f64().abs();
                if *mode == Mode::Sticks {
                    if pull > worst.0 {
                        worst = (pull, Some(count));
                    }
                } else if changed != Some(count) && rate.is_zero() && margin(*mode, second, friction) < 0.0 {
                    *mode = Mode::Sticks;
                    worst = (f64::INFINITY, Some(usize::MAX));
                }
                count += 1;
            });
            let Some(worst) = worst.1 else { return Ok(()) };
            let mut count = 0;
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, _, [_, friction]| {
                if count == worst {
                    *mode = broken_away(friction);
                }
                count += 1;
            });
        }
        let time = next.time;
        Err(self.inconsistent(time))
    }

    fn inconsistent(&self, time: RealOf<S>) -> Error {
        Error::new(Fault::StepTooSmall { step: 0.0, cause: Cause::Inaccurate }).at_time(time.as_f64())
    }
}
