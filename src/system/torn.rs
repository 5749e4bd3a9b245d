//! Loops that do not close, or come apart, where their forces are shared out.

use crate::element::{Element, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::scalar::Real;
use crate::system::{MotionOf, System, coordinates};
use crate::walks::apart::torn;

/// By what share of its size (the way around it; of turns, in rad) a loop may be left open where it is assembled: numbers of six digits leave a few
/// millionths.
const LEFT: f64 = 1e-5;
/// By what share a loop may be open in runs: one that is left so at the start misses by more where it moves.
const TORN: f64 = 1e-4;
/// The least of these shares for numbers that round coarsely, in roundings.
const ROUNDINGS: f64 = 1024.0;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Refuses a motion that corrections could not close: closures that count as following from others, but do not.
    pub(super) fn closes(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        self.within(motion, LEFT)
    }

    /// Refuses a motion in which a loop has come apart.
    pub(super) fn holds_together(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        self.within(motion, TORN)
    }

    /// Refuses loops that are open by more than this share of their size.
    #[inline(always)]
    fn within(&self, motion: &MotionOf<S, R, C, P>, share: f64) -> Result<(), Error> {
        // A constant, so that a compiler does not even look at what follows where all closures have to hold.
        if const { !Self::SHARES } {
            return Ok(());
        }
        let open = torn(&self.chain, self.root.ground(motion.time), coordinates(motion));
        if open.share <= RealOf::<S>::of(share.max(ROUNDINGS * RealOf::<S>::EPSILON.as_f64())) {
            return Ok(());
        }
        let error = Error::new(Fault::NotClosed { residual: open.residual.as_f64() });
        Err(error.at_station(open.entry).beyond_root().at_time(motion.time.as_f64()))
    }
}
