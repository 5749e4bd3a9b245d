//! A shock that goes on and on: joints that touch their stops, brought to rest at once.
//!
//! Blows one after another converge as slowly as the rates of two joints depend on each other. Their end, where stops give nothing back, is the
//! motion next to that before the shock, by its kinetic energy, in which no joint moves into its stop: joints are held or leave, such that
//! stops push. Which are held is found by least-index pivoting (K. G. Murty, Linear and Combinatorial Optimization 1, 1974): the first joint
//! that is held and would leave, or is not and moves into its stop, changes; that ends, for the matrix of the problem is that of an energy.

use super::drive::Running;
use super::strike::Blow;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mirror::margin::touched;
use crate::mirror::{Mode, Rate, let_all_go};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{RateOf, Runs, System};
use num_traits::Zero;

/// Changes of what is held before it is clear that numbers are too ill to tell.
const CHANGES: usize = 10_000;

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
    /// Changes rates until no joint that touches its stop moves into it by more than what is `still`, by stops that give nothing back; gives whether
    /// such rates have been found. Joints have been let go, and their accelerations been found.
    pub(super) fn hold_back(&mut self, still: f64) -> Result<bool, Error> {
        let before = self.next.rate.clone();
        for _ in 0..CHANGES {
            self.hold(&before)?;
            if !self.changes(&before, still)? {
                let next = &mut self.next;
                let_all_go(&mut next.position, &mut next.rate, &next.acceleration);
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Brings the joints that are held to rest, all others moving as that makes them. One that is at rest is locked while the next is brought there.
    fn hold(&mut self, before: &RateOf<S, R, C>) -> Result<(), Error> {
        self.next.rate.set(before);
        let mut joint = 0;
        while let Some((mode, rate, _)) = Self::joint(&mut self.next, joint) {
            if mode.stop().is_some() && !rate.real().is_zero() {
                self.give(&Blow { joint, rate, restitution: S::Scalar::zero() })?;
            }
            joint += 1;
        }
        Ok(())
    }

    /// Changes the first joint that is held and would leave its stop, or is not and moves into it; gives whether there is one.
    fn changes(&mut self, before: &RateOf<S, R, C>, still: f64) -> Result<bool, Error> {
        let mut joint = 0;
        while let Some((mode, rate, told)) = Self::joint(&mut self.next, joint) {
            let moving = mode.moving(told.rubs);
            if let Some(side) = touched(moving, &told) {
                if mode.stop().is_some() {
                    self.set_mode(joint, moving);
                    self.hold(before)?;
                    let loose = Self::joint(&mut self.next, joint);
                    if loose.is_some_and(|(_, rate, _)| side * rate.real().as_f64() < -still) {
                        return Ok(true);
                    }
                    self.set_mode(joint, Mode::resting(side));
                    self.hold(before)?;
                } else if side * rate.real().as_f64() > still {
                    self.set_mode(joint, Mode::resting(side));
                    return Ok(true);
                }
            }
            joint += 1;
        }
        Ok(false)
    }
}
