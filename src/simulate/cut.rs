//! Where a mode of a joint changes within a step, which ends there.

use super::accept::Taken;
use super::drive::Running;
use super::jump::Delay;
use super::now::settled;
use super::settle::CHANGES;
use super::shown::Shown;
use super::{EventFunction, Now, Simulation};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mirror::margin::{forward, margin, rounded};
use crate::mirror::{Mode, Position, Told};
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{MotionOf, RateOf, Runs, System};
use crate::time::Control;
use num_traits::Zero;

/// So small a share of its ends is next to nothing where a cubic tells of what is within a step.
const NEXT_TO: f64 = 0.1;
/// So many joints are looked at at once.
const BLOCK: usize = 8;
/// Beside how it changes in a step so small a value is that of what has just begun to move.
const BEGUN: f64 = 1e-6;
/// Into so many parts a step is divided by looks at what sticks in it, and where these show that friction changes much.
const LOOKS: [u32; 2] = [2, 8];
/// By how much friction may change from look to look, as a share of that at which a joint breaks away.
const CHANGE: f64 = 0.1;

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
    /// The least margin at a motion, with the accelerations that belong to it, and which joint has it.
    fn least(plan: &Simulation<'a, S, R, C, P, L, M, E>, motion: &mut MotionOf<S, R, C, P>) -> (f64, usize) {
        if K::SETTLED {
            return Self::margins(motion);
        }
        Self::margins(&mut settled(plan.system, plan.loads, motion))
    }

    /// The least margin where the step begins, and which joint has it.
    pub(super) fn margin_here(&mut self) -> (f64, usize) {
        Self::least(&self.plan, &mut self.past)
    }

    /// The least margin at the end of the step.
    pub(super) fn margin_ahead(&mut self) -> f64 {
        Self::least(&self.plan, &mut self.next).0
    }

    /// The end of the step, with the accelerations that belong to it.
    fn ahead(&self) -> MotionOf<S, R, C, P> {
        if K::SETTLED { self.next.clone() } else { settled(self.plan.system, self.plan.loads, &self.next) }
    }

    /// Whether a mode is to change before the step ends, if the least margin is this there: not for rounding of what holds a joint.
    fn fails(&mut self, least: f64) -> bool {
        if least >= 0.0 || least < -rounded::<RealOf<S>>() {
            return least < 0.0;
        }
        let (mut next, mut moves) = (self.ahead(), false);
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            moves |= !mode.is_locked() && margin(*mode, *rate, &told) < 0.0;
        });
        moves
    }

    /// How friction of the joints that stick has changed at most from what is kept, which it replaces, and the least margin of those that do not
    /// move.
    fn pull(motion: &mut MotionOf<S, R, C, P>, kept: &mut RateOf<S, R, C>) -> (f64, f64) {
        let (mut change, mut least) = (0.0_f64, f64::INFINITY);
        motion.position.each_mode(kept, &motion.acceleration, &mut |mode, kept, told| {
            if mode.is_locked() {
                least = least.min(margin(*mode, told.rate, &told));
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
                if margin < -rounded::<RealOf<S>>() && k < looks {
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

    /// Where in the step a joint that moves comes to rest, or meets its stop, and goes back before the step ends, and the least margin there: what
    /// values and slopes at both ends tell of it, and then what is there.
    fn dip(&mut self, size: RealOf<S>) -> Option<(f64, f64)> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let mut next = self.ahead();
        for first in (0..).step_by(BLOCK) {
            let [(starts, count), (ends, _)] =
                [&mut self.past, &mut next].map(|motion| Self::approaches(motion, first, size.as_f64()));
            for (start, end) in starts.iter().flatten().zip(ends.iter().flatten()) {
                let Some(theta) = lowest::<RealOf<S>>(*start, *end) else { continue };
                self.interpolate(size, theta);
                let margin = Self::margins(&mut settled(system, loads, &self.between)).0;
                if margin < 0.0 {
                    return Some((theta, margin));
                }
            }
            if count <= first + BLOCK {
                break;
            }
        }
        None
    }

    /// How some joints from a number on near rest and their stops, and how many joints there are.
    fn approaches(motion: &mut MotionOf<S, R, C, P>, first: usize, size: f64) -> ([[Near; 3]; BLOCK], usize) {
        let (mut found, mut count) = ([[FAR; 3]; BLOCK], 0_usize);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            if let Some(entry) = count.checked_sub(first).and_then(|k| found.get_mut(k)) {
                *entry = approach((*mode, *rate, told), size);
            }
            count += 1;
        });
        (found, count)
    }

    /// The next step that is accepted, which ends where a mode changes. What holds a joint may be used up, but for rounding,
    /// where the step before has ended: then its mode changes where this one begins.
    pub(super) fn cut_short(&mut self) -> Result<Taken<RealOf<S>>, Error> {
        let mut taken = self.accepted()?;
        if const { !Self::CUTS } {
            return Ok(taken);
        }
        let mut changes = 0;
        let cut = loop {
            match self.cut(taken.size) {
                Err(error) => {
                    changes += 1;
                    // Several may be let go at once, one after the other.
                    if changes > CHANGES || !self.lets_go(taken.size)? {
                        return Err(error);
                    }
                    taken = self.accepted()?;
                }
                Ok(cut) => break cut,
            }
        };
        Ok(cut.map_or(taken, |size| Taken { size, last: false, switches: true, ..taken }))
    }

    /// Changes the mode of a joint that does not move although nothing holds it where a step of a size (s) begins; whether there is one.
    fn lets_go(&mut self, size: RealOf<S>) -> Result<bool, Error> {
        let (margin, least) = self.margin_here();
        let locked = Self::joint(&mut self.past, least).is_some_and(|(mode, ..)| mode.is_locked());
        if !locked || margin > 0.0 {
            return Ok(false);
        }
        self.let_go(size)?;
        core::mem::swap(&mut self.past, &mut self.next);
        self.value = self.value(Shown::Past)?;
        Ok(true)
    }

    /// Changes the mode of the joint that is held least where a step of a size (s) begins: what is next is then the motion there. Gives how
    /// much later that is.
    pub(super) fn let_go(&mut self, size: RealOf<S>) -> Result<Delay<S::Scalar>, Error> {
        let (_, least) = self.margin_here();
        let mut pace = RealOf::<S>::zero();
        if const { Self::DERIVED } {
            let memory = self.stepper.memory();
            self.make_anew(&memory, size)?;
            pace = self.pace(least, -size);
        }
        self.next = self.past.clone();
        self.switch(|_, _| pace)
    }

    /// Ends the step where the first of all joints is to change its mode, if one is: by steps made anew, so that the rule's order is that of
    /// the place found. Gives the size of the step (s).
    pub(super) fn cut(&mut self, size: RealOf<S>) -> Result<Option<RealOf<S>>, Error> {
        let mut high = (1.0, self.margin_ahead());
        if let Control::Tolerance(_) = self.plan.rule.control
            && let Some(earlier) = self.look(size)
        {
            high = earlier;
        } else if let (Control::Tolerance(_), true) = (self.plan.rule.control, high.1 >= 0.0)
            && let Some(within) = self.dip(size)
        {
            high = within;
        }
        if high.1.is_nan() || high.1 >= 0.0 || (high.0 >= 1.0 && !self.fails(high.1)) {
            return Ok(None);
        }
        self.located(size, high).map(Some)
    }
}

/// A value before it is zero, by a rate or a distance, and how it changes in a step.
type Near = [f64; 2];

/// Of what does not near zero.
const FAR: Near = [f64::INFINITY, 0.0];

/// How a joint that moves nears rest, its lower stop and its upper one.
fn approach<T: Scalar>((mode, rate, told): (Mode, T, Told<T>), size: f64) -> [Near; 3] {
    let (real, mut near) = (|x: T| x.real().as_f64(), [FAR; 3]);
    if mode.is_locked() {
        return near;
    }
    if told.rubs {
        near[0] = [forward(mode, rate), forward(mode, told.rate) * size];
    }
    let apart = real(told.apart);
    if told.stops {
        near[if apart < 0.0 { 1 } else { 2 }] = [apart.abs(), -apart.signum() * real(rate) * size];
    }
    near
}

/// Where a cubic between two ends is least within, if it is next to nothing or less there, beside the ends.
fn lowest<R: Real>([from, down]: Near, [to, up]: Near) -> Option<f64> {
    if !(up > 0.0 && to.is_finite() && from.is_finite()) {
        return None;
    }
    let (square, cube) = (3.0 * (to - from) - 2.0 * down - up, 2.0 * (from - to) + down + up);
    // 3 c θ² + 2 b θ + down = 0, where it rises.
    let root = Elementary::sqrt(R::of(square * square - 3.0 * cube * down)).as_f64();
    let theta = if square > 0.0 { -down / (square + root) } else { (root - square) / (3.0 * cube) };
    let value = from + theta * (down + theta * (square + theta * cube));
    // What has just begun to move is at zero but for rounding, and so is what is least just then.
    let nothing = BEGUN * (up + if down < 0.0 { -down } else { down });
    let most = if from > nothing { NEXT_TO * from.max(to) } else { -nothing };
    (theta > 0.0 && theta < 1.0 && value < most).then_some(theta)
}
