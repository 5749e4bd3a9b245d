//! What joints with friction and hard stops do in a step: block principal pivoting.
//!
//! Each such joint has two choices: it is let go, against its friction, or it is held, so that it ends the step at rest or at its stop. Held
//! forces and rates let go are a linear complementarity problem, of a matrix that is positive definite: one solution, if friction is the same
//! at rest. Choices that do not go together are changed all at once as long as they become fewer, otherwise the first alone, after
//! which K. G. Murty's pivots by least index end (J. J. Júdice, F. M. Pires 1994). Each pass is a sweep.

use crate::mirror::{Mode, Position, Rate, Told, let_last_go, with_joint};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// So many passes may change all at once without there being fewer of them.
const PATIENCE: usize = 3;
/// Passes, and passes for each joint, after which rates are those of rest by more than rounding, and before it is clear that no choices go
/// together.
const LOOSE: [usize; 2] = [8, 2];
const PASSES: [usize; 2] = [64, 8];
/// A force of friction beyond this share of its limit, where something is closed, is that of more joints than closures leave free, but for rounding.
const BEYOND: f64 = 1e6;
/// So often joints turn round, for each of them, before it is clear that not drives alone move them.
const TURNS: usize = 2;
/// A rate is that of rest by so many roundings, and, where others keep a joint that is let go at rest, by such a share: they do so by their
/// accelerations, and closures miss their rates by a share of the step.
const ROUNDINGS: f64 = 1e4;
const MISSED: f64 = 0.01;

/// Passes so far.
pub(super) struct Pivoting {
    /// Whether closures may leave less free to move than there are joints.
    closed: bool,
    passes: usize,
    fewest: usize,
    patience: usize,
    /// A rate is that of rest by this share of the largest one that any pass has seen, or change of one.
    still: f64,
    largest: f64,
    /// Turns of joints that slip, once more were held than closures leave free to move.
    turns: Option<usize>,
    /// The joint that alone was held since the pass before, and what it did then.
    held: Option<(usize, Mode)>,
}

impl Pivoting {
    /// Before the first pass of a step of a scene in which something is held or closed, or is not.
    pub(super) fn new<R: Real>(closed: bool) -> Self {
        Self {
            closed,
            passes: 0,
            fewest: usize::MAX,
            patience: PATIENCE,
            still: ROUNDINGS * R::EPSILON.as_f64(),
            largest: 0.0,
            turns: None,
            held: None,
        }
    }

    /// Changes one of the joints that are held, where accelerations are no numbers, or forces out of all proportion: of more than closures leave free
    /// to move. The one that was held last moves as the others have it, against its friction the other way; otherwise the last one is let go.
    pub(super) fn lets_one_go<T: Scalar, P: Position<T>>(
        &mut self,
        position: &mut P,
        rate: &mut P::Rate,
        found: &P::Rate,
    ) -> bool {
        let (mut sound, closed) = (true, self.closed);
        found.visit(&mut |x| sound &= x.is_finite());
        position.each_mode(rate, found, &mut |mode, _, told| {
            let halts = closed && *mode == Mode::Halts;
            sound &= !(halts && told.guard.real().as_f64().abs() > BEYOND);
        });
        let held = self.held.take();
        if sound {
            return false;
        }
        self.patience = 0;
        let Some((joint, before)) = held else {
            self.still = MISSED;
            self.turns.get_or_insert(0);
            // One at its stop can yield to nothing.
            let is_halted = |mode| mode == Mode::Halts;
            return let_last_go(position, rate, found, is_halted)
                || let_last_go(position, rate, found, Mode::is_locked);
        };
        with_joint(position, rate, found, joint, &mut |mode, _, _| *mode = before.turned_round());
        self.passes += 1;
        true
    }

    /// Whether what joints do goes together, by the accelerations that came of it. It is changed otherwise.
    ///
    /// # Errors
    /// A joint that changes for ever.
    pub(super) fn agreed<T: Scalar, P: Position<T>>(
        &mut self,
        position: &mut P,
        rate: &mut P::Rate,
        found: &P::Rate,
        dt: T::Real,
    ) -> Result<bool, usize> {
        position.each_mode(rate, found, &mut |_, rate, told| {
            let [before, change] = [*rate, told.rate.scale(dt)].map(|x| x.real().as_f64().abs());
            self.largest = self.largest.max(before).max(change);
        });
        let still = (self.still * self.largest).max(Mode::touch::<T::Real>().as_f64());
        let (mut wrong, mut joints, mut first) = (0, 0, 0);
        position.each_mode(rate, found, &mut |mode, rate, told| {
            if changed(*mode, *rate, &told, (dt, still)).is_some() {
                if wrong == 0 {
                    first = joints;
                }
                wrong += 1;
            }
            joints += 1;
        });
        if wrong == 0 {
            return Ok(true);
        }
        if wrong < self.fewest {
            (self.fewest, self.patience) = (wrong, PATIENCE);
        } else {
            self.patience = self.patience.saturating_sub(1);
        }
        self.passes += 1;
        if self.passes > LOOSE[0] + LOOSE[1] * joints {
            self.still = MISSED;
            // More may be held than closures leave free, but for rounding: choices by least index would not end.
            if self.closed && self.turns.is_none() {
                self.turns = Some(0);
                if let_last_go(position, rate, found, Mode::is_locked) {
                    return Ok(false);
                }
            }
        }
        if self.passes > PASSES[0] + PASSES[1] * joints {
            return Err(first);
        }
        let (all, mut joint) = (self.patience > 0, 0);
        let turning = self.turns.as_mut().filter(|turns| **turns < TURNS * joints);
        // Where closures leave nothing free, friction halts nothing: what moves as drives say slips the way that it goes.
        let turns = turning.is_some();
        let mut held = None;
        position.each_mode(rate, found, &mut |mode, rate, told| {
            if all || joint == first {
                let before = *mode;
                *mode = match changed(*mode, *rate, &told, (dt, still)) {
                    Some(Mode::Halts) if turns => mode.turned_round(),
                    other => other.unwrap_or(*mode),
                };
                if !all && *mode == Mode::Halts {
                    held = Some((joint, before));
                }
            }
            joint += 1;
        });
        self.held = held;
        if let Some(turns) = turning {
            *turns += 1;
        }
        Ok(false)
    }
}

/// What a joint does at the start of a step, as far as it is known.
pub(super) fn begun<T: Scalar>(mode: Mode, rate: T, rubs: bool) -> Mode {
    if !rate.real().is_zero() {
        return Mode::at(rate, rubs);
    }
    match mode.stop() {
        Some(_) => Mode::Lands,
        None if rubs => Mode::Halts,
        None => Mode::Swings,
    }
}

/// What a joint does instead, if it cannot do this.
fn changed<T: Scalar>(mode: Mode, before: T, told: &Told<T>, (dt, still): (T::Real, f64)) -> Option<Mode> {
    let real = |x: T| x.real().as_f64();
    let (time, before, second) = (dt.as_f64(), real(before), real(told.rate));
    let (guard, answer, apart) = (real(told.guard), real(told.answer), real(told.apart));
    let (touch, side) = (Mode::touch::<T::Real>().as_f64(), guard.signum());
    let (after, meets) = (before + time * second, told.stops && !mode.is_locked());
    let gives_back = answer > 0.0 && side * before > 0.0;
    match mode {
        // Past its stop already by the rate that it has, it rebounds.
        _ if meets && guard.abs() > 1.0 && gives_back && side * (after + answer * before) > still => {
            Some(Mode::Rebounds)
        }
        _ if meets && side * (time * time * second - apart) > touch => Some(Mode::Lands),
        Mode::SlipsForward | Mode::SlipsBack => {
            let back = -after * real(mode.sign::<T>());
            (back > still).then_some(Mode::Halts)
        }
        Mode::Halts => (guard.abs() > 1.0 + touch).then(|| Mode::broken_away(told.guard)),
        Mode::Lands | Mode::Rebounds if side * answer > 0.0 => Some(Mode::at(told.guard, told.rubs)),
        _ => None,
    }
}

/// What a joint does where the step has led.
pub(super) fn ended<T: Scalar>(mode: &mut Mode, rate: &mut T, told: &Told<T>, dt: T::Real) {
    match mode {
        Mode::Halts => (*mode, *rate) = (Mode::Sticks, T::zero()),
        Mode::Lands if (*rate).real().abs() * dt <= Mode::touch() => {
            (*mode, *rate) = (Mode::resting(told.guard.real().as_f64()), T::zero());
        }
        Mode::Lands | Mode::Rebounds => *mode = Mode::at(*rate, told.rubs),
        _ => (),
    }
}
