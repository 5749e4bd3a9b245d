//! Which joints stick where closures leave fewer free to move than would.
//!
//! As many stick as closures leave free. The others stand still with them, whichever way their friction acts: of slips one way or the other. Which
//! way, and which stick, is a choice of vertices of a convex program (the acceleration is that of least constraint under dry friction), and
//! is made by least-index pivoting (R. G. Bland, New finite pivoting rules for the simplex method, Math. Oper. Res. 2, 1977).

use super::drive::Running;
use super::margin::{forward, margin, touched};
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Mode, Position, let_last_go};
use crate::scalar::{Real, Scalar};
use crate::stepper::{Stepper, inconsistent};
use crate::system::{Dynamics, Runs, System};
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
            if !let_last_go(&mut next.position, &mut next.rate, &next.acceleration) {
                return Err(error);
            }
        }
        let (mut changes, mut joints) = (0, 0);
        while let Some((joint, from, to)) = self.first_wrong(&mut joints) {
            self.set_mode(joint, to);
            if self.is_surplus()? {
                // It does not move, for others stick; but its friction acts the other way.
                self.set_mode(joint, from.turned_round());
                if self.is_surplus()? {
                    return Err(error);
                }
            }
            changes += 1;
            if changes > CHANGES * joints {
                return Err(inconsistent(joint, self.next.time));
            }
        }
        Ok(())
    }

    /// The first joint that does what it cannot do, that, and what it does instead. Counts joints.
    fn first_wrong(&mut self, joints: &mut usize) -> Option<(usize, Mode, Mode)> {
        let (mut first, mut count, rounding) = (None, 0, Mode::reluctance::<RealOf<S>>().as_f64());
        let next = &mut self.next;
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
            let now = if mode.is_locked() {
                (margin(*mode, told.rate, &told) < 0.0).then(|| match *mode {
                    Mode::Sticks => Mode::broken_away(told.guard),
                    mode => mode.moving(told.rubs),
                })
            } else if rate.real().is_zero() {
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
