//! Which modes of joints follow where a run changes one, begins, or goes on.

use super::drive::Running;
use super::jump::{Delay, shifted};
use super::now::settled;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::couples;
use crate::mirror::margin::{forward, idles, margin, meets, rests, stands, touched};
use crate::mirror::{Mode, Position, Rate, Told, let_all_go, let_last_go, with_joint};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, PositionOf, Runs, System};
use num_traits::Zero;

/// Up to so many roundings of what a joint gains in a step its rate is that of one at rest.
const ROUNDINGS: f64 = 1e4;
/// Up to so many roundings of the fastest rate, too.
const ROUNDED: f64 = 1024.0;
/// A margin of this is none of a joint whose mode is about to change.
const BARELY: f64 = 1e-6;

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
    /// Whether joints may stand because others do. In a chain that nothing closes each is held by its own friction: what stands there and slips has
    /// just begun to move.
    pub(super) const HELD_BY_OTHERS: bool = System::<S, R, C, P>::CLOSED > 0 || couples::<S, L>();
    /// Whether steps end where a mode of such a joint changes.
    pub(super) const CUTS: bool = Self::MODES && !K::SWITCHES;

    /// Finds accelerations. Where more joints stick than closures leave free to move, their modes are [found](Self::share_surplus); for a method that
    /// finds modes itself the last ones are let go, which is what is given.
    pub(super) fn accelerated(&mut self) -> Result<bool, Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let (mut workspace, mut loosened) = (Dynamics::<L>::workspace(system), false);
        while let Err(error) = system.accelerate(&mut self.next, loads, &mut workspace) {
            let overlocked = Self::MODES && matches!(error.fault, Fault::RedundantClosures { .. });
            if overlocked && self.slip_as_prescribed() {
                continue;
            }
            if overlocked && !K::SWITCHES {
                return self.share_surplus(error).map(|()| false);
            }
            let next = &mut self.next;
            if !(overlocked && let_last_go(&mut next.position, &mut next.rate, &next.acceleration, Mode::is_locked)) {
                return Err(error);
            }
            loosened = true;
        }
        Ok(loosened)
    }

    /// This error, or, of closures that depend on each other only where a joint does not move, what keeps the scene from moving.
    #[cold]
    pub(super) fn jammed(&mut self, error: Error) -> Error {
        let Fault::RedundantClosures { .. } = error.fault else { return error };
        let (system, loads, mut number) = (self.plan.system, self.plan.loads, 0);
        let moves = |mut loose: MotionOf<S, R, C, P>| {
            system.accelerate(&mut loose, loads, &mut Dynamics::<L>::workspace(system)).is_ok()
        };
        while let Some((mode, _, told)) = Self::joint(&mut self.next, number) {
            let mut loose = self.next.clone();
            if mode.is_locked() || touched(mode, &told).is_some() {
                let (position, rate) = (&mut loose.position, &mut loose.rate);
                with_joint(position, rate, &loose.acceleration, number, &mut |mode, _, told| {
                    *mode = mode.moving(told.rubs)
                });
                if moves(loose) {
                    return Error { fault: Fault::Jammed { joint: number }, place: None, ..error };
                }
            }
            number += 1;
        }
        error
    }

    /// The least margin of the joints at a motion, and which joint has it.
    pub(super) fn margins(motion: &mut MotionOf<S, R, C, P>) -> (f64, usize) {
        let (mut least, mut count) = ((f64::INFINITY, 0), 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            let margin = margin(*mode, *rate, &told);
            if margin < least.0 {
                least = (margin, count);
            }
            count += 1;
        });
        least
    }

    /// A joint that slips and stands, held by others, and is all but pushed back: where it is, its margin falls from none at all.
    fn pushed_back(motion: &mut MotionOf<S, R, C, P>) -> Option<usize> {
        let (mut found, mut count) = (None, 0);
        let most = -0.5 * Mode::reluctance::<RealOf<S>>().as_f64();
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            if mode.slips() && stands(*rate) && forward(*mode, told.rate) < most {
                found = found.or(Some(count));
            }
            count += 1;
        });
        found
    }

    /// What the joint of a number does, its rate, and what is told of it.
    pub(super) fn joint(
        motion: &mut MotionOf<S, R, C, P>,
        number: usize,
    ) -> Option<(Mode, S::Scalar, Told<S::Scalar>)> {
        let (mut found, mut count) = (None, 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            if count == number {
                found = Some((*mode, *rate, told));
            }
            count += 1;
        });
        found
    }

    /// Has a joint do something else.
    pub(super) fn set_mode(&mut self, joint: usize, to: Mode) {
        let next = &mut self.next;
        with_joint(&mut next.position, &mut next.rate, &next.acceleration, joint, &mut |mode, _, _| *mode = to);
    }

    /// Changes the mode of the joint that has ended the step, and of those that change with it; `pace` tells how fast the guard of a joint that does
    /// not move changes (1/s). Gives how much later that is than at the time found.
    pub(super) fn switch(
        &mut self,
        pace: impl FnOnce(&mut Self, usize) -> RealOf<S>,
    ) -> Result<Delay<S::Scalar>, Error> {
        let mut next = settled(self.plan.system, self.plan.loads, &self.next);
        let ((margin, nearest), pushed) = (Self::margins(&mut next), Self::pushed_back(&mut next));
        let earliest = pushed.filter(|_| margin > BARELY).unwrap_or(nearest);
        let (mut count, mut strikes, mut breaks) = (0, false, false);
        let holds = Self::HELD_BY_OTHERS && Self::holds_others(&mut next, earliest);
        let delay = if const { Self::DERIVED } { self.delay(&mut next, earliest, pace)? } else { Delay::None };
        let before = if const { Self::DERIVED } { Some(next.acceleration.clone()) } else { None };
        if let Delay::Moving(delay) = delay {
            shifted(&mut next, delay);
        }
        let (still, mut fastest) = (self.still(), 0.0_f64);
        next.rate.visit(&mut |rate| fastest = fastest.max(rate.real().as_f64().abs()));
        let least = ROUNDED * RealOf::<S>::EPSILON.as_f64() * fastest;
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            let due = count == earliest;
            count += 1;
            match *mode {
                Mode::Sticks if due => (*mode, breaks) = (Mode::broken_away(told.guard), holds),
                Mode::RestsBelow | Mode::RestsAbove if due => (*mode, breaks) = (mode.moving(told.rubs), holds),
                Mode::Swings if due => strikes = true,
                Mode::SlipsForward | Mode::SlipsBack if due && meets(*mode, *rate, &told) => strikes = true,
                // What others hold stays held, if they do not come to rest just here.
                Mode::SlipsForward | Mode::SlipsBack if !due && idles(*rate, &told) => (),
                Mode::SlipsForward | Mode::SlipsBack
                    if due || forward(*mode, *rate) <= (told.rate.real().as_f64().abs() * still).max(least) =>
                {
                    (*mode, *rate) = (Mode::Sticks, S::Scalar::zero());
                }
                _ => (),
            }
        });
        self.next = next;
        match (strikes, breaks) {
            (true, _) => self.strike(),
            (_, true) => self.yield_from(earliest),
            _ => self.settle_modes(Some(earliest)),
        }?;
        before.map_or(Ok(()), |before| self.returned(delay, &before))?;
        Ok(delay)
    }

    /// Finds modes of a motion of which only rates are known. Where numbers have derivatives joints that rest at their stops may be `kept` there.
    pub(super) fn begin_modes(&mut self, kept: bool) -> Result<(), Error> {
        let (mut stops, next) = (false, &mut self.next);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            stops |= told.stops;
            if told.rubs {
                *mode = Mode::of(*rate);
            }
        });
        if stops {
            let_all_go(&mut next.position, &mut next.rate, &next.acceleration);
            self.stands_between()?;
            let start = const { Self::DERIVED }.then(|| self.next.clone());
            if let (Some(start), false) = (&start, kept) {
                self.strikes_surely(start.clone(), false)?;
            }
            self.strike()?;
            if let (Some(start), true) = (start, kept) {
                self.strikes_surely(start, true)?;
            }
        } else {
            self.settle_modes(None)?;
        }
        if const { Self::DERIVED } { self.halted() } else { Ok(()) }
    }

    /// So long (s) a joint slips on whose rate is zero but for rounding: joints of one freedom come to rest together.
    fn still(&self) -> f64 {
        (self.progress.size * RealOf::<S>::EPSILON).as_f64() * ROUNDINGS
    }

    /// Finds modes anew where a run that goes on does not have those that follow from it: its rates or loads have changed, or an event has
    /// stopped it where a joint comes to rest.
    pub(super) fn settle_anew(&mut self) -> Result<(), Error> {
        let (mut now, mut due) = (settled(self.plan.system, self.plan.loads, &self.past), false);
        let still = self.still();
        let at_event = self.progress.at_event;
        now.position.each_mode(&mut now.rate, &now.acceleration, &mut |mode, rate, told| {
            let (slips, second) = (mode.slips(), told.rate);
            let gain = second.real().as_f64().abs() * still;
            if at_event && slips && !rate.real().is_zero() && rate.real().as_f64().abs() <= gain {
                (*rate, due) = (S::Scalar::zero(), true);
            }
            let pushed_back = slips && rate.real().is_zero() && forward(*mode, second) < 0.0;
            let strikes = touched(*mode, &told).is_some_and(|side| side * rate.real().as_f64() > 0.0);
            let moved = mode.is_locked() && !rate.real().is_zero();
            let passed = margin(*mode, *rate, &told) < 0.0;
            due |= passed || pushed_back || strikes || moved || rests(*mode, *rate, &told).is_some();
        });
        if due {
            self.next = now;
            self.begin_modes(false)?;
            core::mem::swap(&mut self.past, &mut self.next);
        }
        Ok(())
    }
}
