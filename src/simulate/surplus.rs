//! Which joints stick where closures leave fewer free to move than would.
//!
//! As many stick as closures leave free. The others stand still with them, whichever way their friction acts: of slips one way or the other. Which
//! way, and which stick, is a choice of vertices of a convex program (the acceleration is that of least constraint under dry friction), and
//! is made by least-index pivoting (R. G. Bland, New finite pivoting rules for the simplex method, Math. Oper. Res. 2, 1977).

use super::drive::Running;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::margin::{forward, idles, margin, stands, touched};
use crate::mirror::{Mode, Position, let_last_go, with_joint};
use crate::scalar::{Real, Scalar};
use crate::stepper::{Stepper, inconsistent};
use crate::system::{Dynamics, MotionOf, Runs, System};
use num_traits::Zero;

/// Changes, for each joint, before it is clear that none end.
const CHANGES: usize = 64;

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
    /// Finds modes that belong together, and their accelerations, where more joints stick than closures leave free to move, which `error` says.
    pub(super) fn share_surplus(&mut self, error: Error) -> Result<(), Error> {
        while self.is_surplus()? {
            let next = &mut self.next;
            if !let_last_go(&mut next.position, &mut next.rate, &next.acceleration, Mode::is_locked) {
                return Err(error);
            }
        }
        self.settle_surplus()
    }

    /// Whether others that slip stand still with a joint.
    pub(super) fn holds_others(motion: &mut MotionOf<S, R, C, P>, joint: usize) -> bool {
        let (mut found, mut count) = (false, 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            found |= count != joint && mode.slips() && idles(*rate, &told);
            count += 1;
        });
        found
    }

    /// Changes, one after another, what joints do that cannot go on so.
    fn settle_surplus(&mut self) -> Result<(), Error> {
        let (mut changes, mut joints) = (0, 0);
        while let Some((joint, from, to)) = self.first_wrong(&mut joints) {
            if from == Mode::Sticks {
                self.set_mode(joint, to);
                self.break_away(joint)?;
            } else {
                self.hold_by(joint, from, to)?;
            }
            changes += 1;
            if changes > CHANGES * joints {
                return Err(inconsistent(joint, self.next.time));
            }
        }
        Ok(())
    }

    /// Finds what follows where a joint that held others has broken away: if it takes one of them the way against which its friction does not act,
    /// that one sticks in its place, or breaks away in turn.
    pub(super) fn yield_from(&mut self, joint: usize) -> Result<(), Error> {
        self.break_away(joint)?;
        self.settle_surplus()
    }

    /// Lets a joint break away, those that it would take back sticking in its place as long as they can. Finds accelerations.
    fn break_away(&mut self, joint: usize) -> Result<(), Error> {
        let (mut leaves, mut changes) = (joint, 0);
        while let Some((held, from, joints)) = self.dragged_back(leaves) {
            self.hold_by(held, from, Mode::Sticks)?;
            let Some((mode, rate, told)) = Self::joint(&mut self.next, held) else { break };
            if mode.is_locked() {
                if margin(mode, rate, &told) >= -slack::<RealOf<S>>() {
                    return Ok(());
                }
                self.set_mode(held, Mode::broken_away(told.guard));
                leaves = held;
            }
            changes += 1;
            if changes > CHANGES * joints {
                return Err(inconsistent(held, self.next.time));
            }
        }
        self.is_surplus().map(|_| ())
    }

    /// Has a joint that stands but for rounding stick or rest; where others hold it, which do, its friction acts the other way instead. Finds
    /// accelerations.
    fn hold_by(&mut self, joint: usize, from: Mode, to: Mode) -> Result<(), Error> {
        let next = &mut self.next;
        with_joint(&mut next.position, &mut next.rate, &next.acceleration, joint, &mut |mode, rate, _| {
            (*mode, *rate) = (to, S::Scalar::zero());
        });
        if self.is_surplus()? {
            self.set_mode(joint, from.turned_round());
            if self.is_surplus()? {
                return Err(inconsistent(joint, self.next.time));
            }
        }
        Ok(())
    }

    /// The first joint that stands and would be taken against its slip by the one that breaks away, what it does, and how many joints there are.
    fn dragged_back(&mut self, leaves: usize) -> Option<(usize, Mode, usize)> {
        let (mode, _, told) = Self::joint(&mut self.next, leaves)?;
        let away = touched(mode, &told).map_or(S::Scalar::zero(), |side| S::Scalar::literal(-side));
        let (way, mut motion) = (if mode == Mode::Swings { away } else { mode.sign() }, self.next.clone());
        motion.acceleration = self.response(leaves).ok()?; // it cannot move where others stick still
        let (mut first, mut joints) = (None, 0);
        while let Some((mode, rate, told)) = Self::joint(&mut self.next, joints) {
            let answer = Self::joint(&mut motion, joints).map_or_else(S::Scalar::zero, |(.., told)| told.rate);
            let back = -forward(mode, way * answer) > Mode::reluctance::<RealOf<S>>().as_f64();
            if joints != leaves && first.is_none() && idles(rate, &told) && back {
                first = Some((joints, mode));
            }
            joints += 1;
        }
        first.map(|(joint, mode)| (joint, mode, joints))
    }

    /// The first joint that does what it cannot do, that, and what it does instead. Counts joints.
    fn first_wrong(&mut self, joints: &mut usize) -> Option<(usize, Mode, Mode)> {
        let (mut first, mut count, rounding) = (None, 0, Mode::reluctance::<RealOf<S>>().as_f64());
        let next = &mut self.next;
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            let now = if mode.is_locked() {
                (margin(*mode, told.rate, &told) < -slack::<RealOf<S>>()).then(|| match *mode {
                    Mode::Sticks => Mode::broken_away(told.guard),
                    mode => mode.moving(told.rubs),
                })
            } else if stands(*rate) {
                let pressed = touched(*mode, &told).filter(|side| side * told.rate.real().as_f64() > rounding);
                let back = forward(*mode, told.rate) < -rounding;
                pressed.map(Mode::resting).or(back.then_some(Mode::Sticks))
            } else {
                None
            };
            first = first.or(now.map(|now| (count, *mode, now)));
            count += 1;
        });
        *joints = count;
        first
    }

    /// Finds accelerations; whether there are none, for more joints stick than closures leave free.
    fn is_surplus(&mut self) -> Result<bool, Error> {
        let system = self.plan.system;
        match system.accelerate(&mut self.next, self.plan.loads, &mut Dynamics::<L>::workspace(system)) {
            Err(Error { fault: Fault::RedundantClosures { .. }, .. }) => Ok(true),
            outcome => outcome.map(|()| false),
        }
    }
}

/// Up to so much what holds a joint may be more than can hold it: where others broke away it is at its limit but for rounding, and goes back from
/// there.
fn slack<R: Real>() -> f64 {
    0.0625 * R::EPSILON.sqrt().as_f64()
}
