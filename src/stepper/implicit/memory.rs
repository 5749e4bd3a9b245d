//! What steps of the generalised-α family carry from one to the next.

use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};

/// What [`ImplicitStepper`](super::ImplicitStepper) carries from step to step: traces of the last two motions, and what joints keep from sweep to sweep.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ImplicitMemory<M, G> {
    pub(super) traces: [M; 2],
    pub(super) gains: G,
}

/// A motion, to be recognised by, and how far its auxiliary acceleration A is from the true one; no time before the first step.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Trace<R, P, V> {
    pub(super) time: Option<R>,
    pub(super) position: P,
    pub(super) rate: V,
    /// A − a, and the size (s) of the step that left it: it grows with the size.
    pub(super) offset: V,
    pub(super) size: R,
    /// By how much a changed over that step.
    pub(super) change: V,
}

impl<R: Real, P, V> Trace<R, P, V> {
    /// Keeps a motion, without its accelerations.
    pub(super) fn keep<T: Scalar<Real = R>, C: Closures>(&mut self, motion: &Motion<T, P, C>, size: R, zero: &V)
    where
        P: Position<T, Rate = V>,
        V: Rate<T>,
    {
        self.time = Some(motion.time);
        self.position.drift_0(&motion.position, (R::zero(), zero));
        self.rate.set(&motion.rate);
        self.size = size;
    }
}
