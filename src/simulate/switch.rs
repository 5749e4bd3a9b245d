//! Joints with modes in a run: where these change, and which follow.

use super::EventFunction;
use super::Now;
use super::crossing::crossing;
use super::drive::Running;
use super::now::settled;
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Cause, Error, Fault};
use crate::mirror::{GuardedRate, Mode, Position};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, PositionOf, RateOf, Runs, System};
use crate::time::Control;
use num_traits::Zero;

/// Halvings of a step in which a joint moves on before it comes to rest.
const HALVINGS: i32 = 40;
/// So many corrections put the end of a step where a joint meets its stop.
const NEWTON: usize = 3;
/// Into so many parts a step is divided by looks at what sticks in it, and where these show that friction changes much.
const LOOKS: [u32; 2] = [2, 8];
/// By how much friction may change from look to look, as a share of that at which a joint breaks away.
const CHANGE: f64 = 0.1;
/// Up to so many roundings of what a joint gains in a step its rate is that of one at rest.
const ROUNDINGS: f64 = 1e4;
/// Changes of mode at one instant, besides one of each joint, before it is clear that none are consistent.
const CHANGES: usize = 64;

/// How far a joint is from a change of its mode: positive before.
fn margin<T: Scalar>(mode: Mode, rate: T, guard: T) -> f64 {
    let guard = guard.real().as_f64();
    match mode {
        Mode::Sticks | Mode::Struck => 1.0 - guard.abs(),
        // A little beyond, so that what stands at its stop is before it.
        Mode::Swings => 1.0 - guard.abs() + 0.5 * Mode::touch::<T::Real>().as_f64(),
        Mode::RestsBelow | Mode::RestsAbove => Mode::reluctance::<T::Real>().as_f64() - guard,
        Mode::SlipsForward | Mode::SlipsBack => (mode.sign::<T>() * rate).real().as_f64(),
    }
}

/// The mode of a joint that breaks away: it goes where friction does not hold it.
fn broken_away<T: Scalar>(friction: T) -> Mode {
    Mode::of(-friction)
}

/// The side of the stop that a joint touches: −1 the lower, 1 the upper one.
pub(super) fn touched<T: Scalar>(mode: Mode, guard: T) -> Option<f64> {
    let (guard, touch) = (guard.real().as_f64(), Mode::touch::<T::Real>().as_f64());
    (mode == Mode::Swings && guard.abs() >= 1.0 - touch).then(|| guard.signum())
}

/// The mode of a joint that touches a stop and does not move: it rests, if it does not leave.
fn rests<T: Scalar>(mode: Mode, rate: T, told: &GuardedRate<T>) -> Option<Mode> {
    let side = touched(mode, told.guard).filter(|_| rate.is_zero())?;
    // Half of what a joint leaves its stop at: one that has just left does not come to rest again by rounding.
    let stays = side * told.rate.real().as_f64() > -0.5 * Mode::reluctance::<T::Real>().as_f64();
    stays.then_some(if side < 0.0 { Mode::RestsBelow } else { Mode::RestsAbove })
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
    /// Whether there are joints with modes.
    pub(super) const MODES: bool = PositionOf::<S, R, C>::MODES;

    /// Refuses numbers whose derivatives or lanes would have changes of mode of their own.
    pub(super) fn modes_by_numbers(&self) -> Result<(), Error> {
        if Self::MODES && size_of::<S::Scalar>() > size_of::<RealOf<S>>() {
            let what = "derivatives or lanes of a run in which joints stick and slip or strike stops";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        Ok(())
    }

    /// The least margin of the joints at a motion, and which joint has it.
    fn margins(motion: &mut MotionOf<S, R, C, P>) -> (f64, usize) {
        let (mut least, mut count) = ((f64::INFINITY, 0), 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            let margin = margin(*mode, *rate, told.guard);
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

    /// How friction of the joints that stick has changed at most from what is kept, which it replaces, and the least margin of those that do not
    /// move.
    fn pull(motion: &mut MotionOf<S, R, C, P>, kept: &mut RateOf<S, R, C>) -> (f64, f64) {
        let (mut change, mut least) = (0.0_f64, f64::INFINITY);
        motion.position.each_mode(kept, &motion.acceleration, &mut |mode, kept, told| {
            if mode.is_locked() {
                least = least.min(margin(*mode, told.rate, told.guard));
            }
            if *mode == Mode::Sticks {
                change = change.max((told.guard - *kept).real().as_f64().abs());
                *kept = told.guard;
            }
        });
        (change, least)
    }

    /// The first instant in the step at which a joint that does not move would do so, of some that are looked at, and its margin. What
    /// rests errs by nothing, whatever loads do: so the next step is to be no longer than one in which friction changes little.
    fn look(&mut self, size: RealOf<S>) -> Option<(f64, f64)> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let mut start = self.past.rate.clone();
        if Self::pull(&mut self.past, &mut start).1.is_infinite() {
            return None;
        }
        let mut coarse = None;
        for looks in LOOKS {
            let (mut kept, mut most) = (start.clone(), 0.0_f64);
            for k in 1..=looks {
                let theta = f64::from(k) / f64::from(looks);
                let mut seen = if k == looks {
                    settled(system, loads, &self.next)
                } else {
                    self.interpolate(size, theta);
                    settled(system, loads, &self.between)
                };
                let (change, margin) = Self::pull(&mut seen, &mut kept);
                if margin < 0.0 && k < looks {
                    return Some((theta, margin));
                }
                most = most.max(change);
            }
            coarse.get_or_insert(most);
            if most <= CHANGE {
                break;
            }
        }
        let progress = &mut self.progress;
        if let Some(change) = coarse.filter(|change| *change > 0.5 * CHANGE) {
            progress.size = progress.size.min(size * RealOf::<S>::of((CHANGE / change).max(0.2)));
            progress.careful = true;
        }
        None
    }

    /// For how long the joint that is to change its mode has been beyond its stop (s), if it strikes one.
    fn beyond(&mut self) -> f64 {
        let mut next = settled(self.plan.system, self.plan.loads, &self.next);
        let (earliest, mut count, mut time) = (Self::margins(&mut next).1, 0, 0.0);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            if count == earliest && *mode == Mode::Swings && told.guard.real().as_f64().abs() > 1.0 {
                time = -(told.apart / *rate).real().as_f64();
            }
            count += 1;
        });
        time
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
        if let Control::Tolerance(_) = self.plan.rule.control
            && let Some(earlier) = self.look(size)
        {
            high = earlier;
        }
        if high.1.is_nan() || high.1 >= 0.0 {
            return Ok(None);
        }
        let memory = self.stepper.memory();
        let (margin, least) = Self::margins(&mut self.past);
        let mut low = (0.0, margin);
        // One that has just begun to slip is at rest where the step begins.
        let mut share = high.0;
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
            return Err(inconsistent(least, self.past.time));
        }
        let (width, below) = (high.0 - low.0, low.0);
        let within = crossing([low.1, high.1], |theta| self.made_anew(&memory, size, below + theta * width))?;
        let mut share = below + within * width;
        // What strikes has been found a little beyond its stop, where it is faster by what it has fallen since.
        for _ in 0..NEWTON {
            let back = self.beyond() / size.as_f64();
            if !(back > 0.0 && back < 0.5 * share) {
                break;
            }
            share -= back;
            self.made_anew(&memory, size, share)?;
        }
        Ok(Some(size * RealOf::<S>::of(share)))
    }

    /// Changes the mode of the joint that has ended the step, and of those that change with it.
    pub(super) fn switch(&mut self) -> Result<(), Error> {
        let mut next = settled(self.plan.system, self.plan.loads, &self.next);
        let (earliest, mut count, mut strikes) = (Self::margins(&mut next).1, 0, false);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            let due = count == earliest;
            count += 1;
            match *mode {
                Mode::Sticks if due => *mode = broken_away(told.guard),
                Mode::RestsBelow | Mode::RestsAbove if due => *mode = Mode::Swings,
                Mode::Swings if due => strikes = true,
                Mode::SlipsForward | Mode::SlipsBack if due || margin(*mode, *rate, told.guard) <= 0.0 => {
                    (*mode, *rate) = (Mode::Sticks, S::Scalar::zero());
                }
                _ => (),
            }
        });
        self.next = next;
        if strikes { self.strike() } else { self.settle_modes(Some(earliest)) }
    }

    /// Finds modes of a motion of which only rates are known.
    pub(super) fn begin_modes(&mut self) -> Result<(), Error> {
        let (mut stops, next) = (false, &mut self.next);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, _| {
            stops |= mode.forgotten() == Mode::Swings;
            if mode.forgotten() == Mode::Sticks {
                *mode = Mode::of(*rate);
            }
        });
        if !stops {
            return self.settle_modes(None);
        }
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, _, _| *mode = mode.moving());
        self.stands_between()?;
        self.strike()
    }

    /// Finds modes that belong together where the next step begins, and the accelerations there: what friction does not hold breaks away,
    /// the joint first that it holds least; what leaves its stop does so, and what does not stays. One joint may have just changed its mode.
    pub(super) fn settle_modes(&mut self, changed: Option<usize>) -> Result<(), Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let (mut workspace, next) = (Dynamics::<L>::workspace(system), &mut self.next);
        let (mut least, mut changes) = (0, CHANGES);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |_, _, _| changes += 1);
        for _ in 0..changes {
            if let Err(error) = system.accelerate(next, loads, &mut workspace) {
                return Err(self.overlocked(error));
            }
            // Held least, or pushed back where it is about to move.
            let (mut worst, mut count) = ((0.0, None), 0);
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
                let resting = if changed == Some(count) { None } else { rests(*mode, *rate, &told) };
                let slips = matches!(*mode, Mode::SlipsForward | Mode::SlipsBack) && rate.is_zero();
                let back = slips && changed != Some(count) && margin(*mode, told.rate, told.guard) < 0.0;
                if let Some(now) = if back { Some(Mode::Sticks) } else { resting } {
                    *mode = now;
                    (worst, least) = ((f64::INFINITY, Some(usize::MAX)), count);
                } else if mode.is_locked() {
                    let over = -margin(*mode, told.rate, told.guard);
                    if over > worst.0 {
                        worst = (over, Some(count));
                    }
                }
                count += 1;
            });
            let Some(worst) = worst.1 else { return Ok(()) };
            if worst < usize::MAX {
                least = worst;
            }
            let mut count = 0;
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, _, told| {
                if count == worst {
                    *mode = if *mode == Mode::Sticks { broken_away(told.guard) } else { Mode::Swings };
                }
                count += 1;
            });
        }
        let time = next.time;
        Err(inconsistent(least, time))
    }

    /// This error, which may be that too many joints stick where the next step begins.
    #[cold]
    pub(super) fn overlocked(&self, error: Error) -> Error {
        let (system, mut loose) = (self.plan.system, self.next.clone());
        if const { !Self::MODES } || !matches!(error.fault, Fault::RedundantClosures { .. }) {
            return error;
        }
        loose.position.each_mode(&mut loose.rate, &loose.acceleration, &mut |mode, _, _| *mode = mode.moving());
        let what = "more joints that stick at once, or rest against stops, than closures leave free to move";
        match system.accelerate(&mut loose, self.plan.loads, &mut system.workspace()) {
            Ok(()) => Error { place: None, fault: Fault::Unsupported { what }, ..error },
            Err(_) => error,
        }
    }

    /// Finds modes anew where a run that goes on does not have those that follow from it: its rates or loads have changed, or an event has
    /// stopped it where a joint comes to rest.
    pub(super) fn settle_anew(&mut self) -> Result<(), Error> {
        let (mut now, mut due) = (settled(self.plan.system, self.plan.loads, &self.past), false);
        let still = (self.progress.size * RealOf::<S>::EPSILON).as_f64() * ROUNDINGS;
        let at_event = self.progress.at_event;
        now.position.each_mode(&mut now.rate, &now.acceleration, &mut |mode, rate, told| {
            let (slips, second) = (matches!(*mode, Mode::SlipsForward | Mode::SlipsBack), told.rate);
            let gain = second.real().as_f64().abs() * still;
            if at_event && slips && !rate.is_zero() && rate.real().as_f64().abs() <= gain {
                (*rate, due) = (S::Scalar::zero(), true);
            }
            let pushed_back = slips && rate.is_zero() && margin(*mode, second, told.guard) < 0.0;
            let strikes = touched(*mode, told.guard).is_some_and(|side| side * rate.real().as_f64() > 0.0);
            let moved = mode.is_locked() && !rate.is_zero();
            let passed = margin(*mode, *rate, told.guard) < 0.0;
            due |= passed || pushed_back || strikes || moved || rests(*mode, *rate, &told).is_some();
        });
        if due {
            self.next = now;
            self.begin_modes()?;
            core::mem::swap(&mut self.past, &mut self.next);
        }
        Ok(())
    }
}

/// Modes that do not belong together, at a joint of those with modes.
pub(super) fn inconsistent<R: Real>(joint: usize, time: R) -> Error {
    let cause = Cause::Modes { joint };
    Error::new(Fault::StepTooSmall { step: 0.0, cause }).at_time(time.as_f64())
}
