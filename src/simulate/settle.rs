//! Modes that belong together where several joints change theirs at one instant.

use super::drive::Running;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::margin::{forward, margin, rests, rounded, stands, touched};
use crate::mirror::{Mode, Position};
use crate::scalar::{Real, Scalar};
use crate::stepper::{Stepper, inconsistent};
use crate::system::{Dynamics, Runs, System};
use num_traits::Zero;

/// Changes of mode at one instant, besides one of each joint, before it is clear that none are consistent.
pub(super) const CHANGES: usize = 64;
/// What is pushed back by no more than this share of what moves a joint at all may as well not be.
const FAINT: f64 = 1e-3;

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
    /// Finds modes that belong together where the next step begins, and the accelerations there: what friction does not hold breaks away,
    /// the joint first that it holds least; what leaves its stop does so, and what does not stays. One joint may have just changed its mode.
    pub(super) fn settle_modes(&mut self, changed: Option<usize>) -> Result<(), Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let (mut workspace, mut least, mut changes) = (Dynamics::<L>::workspace(system), 0, CHANGES);
        let mut prescribed = false;
        let next = &mut self.next;
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |_, _, _| changes += 1);
        for _ in 0..changes {
            if let Err(error) = system.accelerate(&mut self.next, loads, &mut workspace) {
                if !matches!(error.fault, Fault::RedundantClosures { .. }) {
                    return Err(error);
                }
                if self.slip_as_prescribed() {
                    prescribed = true;
                    continue;
                }
                return self.accelerated().map(|_| ());
            }
            let next = &mut self.next;
            // Held least, or pushed back where it is about to move: by rounding alone, if another joint that breaks away too takes it along.
            let (mut worst, mut faint, mut count) = ((0.0, None), None, 0);
            let rounding = -Mode::reluctance::<RealOf<S>>().as_f64();
            let pushed = if Self::HELD_BY_OTHERS { 0.0 } else { FAINT * rounding };
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
                // What has just changed its mode does not take that back for rounding.
                let (just, side) = (changed == Some(count), touched(*mode, &told));
                let pressed = side.is_some_and(|side| side * told.rate.real().as_f64() > -rounding);
                let resting = rests(*mode, *rate, &told).filter(|_| pressed || !just);
                let second = if mode.slips() && stands(*rate) { forward(*mode, told.rate) } else { 0.0 };
                let back = second < rounding;
                // What all others hold does not move but for rounding, whichever way.
                if second < pushed && !just && !prescribed {
                    faint = Some(count);
                }
                if let Some(now) = if back { Some(Mode::Sticks) } else { resting } {
                    if back {
                        rest(rate);
                    }
                    *mode = now;
                    (worst, least) = ((f64::INFINITY, Some(usize::MAX)), count);
                } else if mode.is_locked() {
                    let over = -margin(*mode, told.rate, &told) - rounded::<RealOf<S>>();
                    if over > worst.0 {
                        worst = (over, Some(count));
                    }
                }
                count += 1;
            });
            let Some(worst) = worst.1.or(faint) else { return Ok(()) };
            if worst < usize::MAX {
                least = worst;
            }
            let mut count = 0;
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
                if count == worst {
                    *mode = match *mode {
                        Mode::Sticks => Mode::broken_away(told.guard),
                        Mode::SlipsForward | Mode::SlipsBack => {
                            rest(rate);
                            Mode::Sticks
                        }
                        _ => mode.moving(told.rubs),
                    };
                }
                count += 1;
            });
        }
        Err(inconsistent(least, self.next.time))
    }
}

/// Takes a rate that is none but for rounding for none, with the derivatives that one of zero has.
fn rest<T: Scalar>(rate: &mut T) {
    if !rate.real().is_zero() {
        *rate = T::zero();
    }
}
