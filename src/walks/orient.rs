//! Postures, where costates read more of them than sweeps do.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::shape::{Around, AtClosing, Mut, PerAxes, Positions, Rates, Ref, Selective, Walk, alike_in_arms};

/// Carries the orientation outward, and stores what all other walks read.
pub struct Orient;

impl<S: Reversed> Walk<S> for Orient {
    type Carried = S::Turn;
    /// Positions and rates; the posture.
    type Stores =
        (Ref<Positions>, Ref<Rates>, Mut<PerAxes<S::X>>, Mut<PerAxes<S::Y>>, Mut<PerAxes<S::P>>, Mut<PerAxes<S::Q>>);
}

impl<S: Reversed> Selective<S> for Orient {
    alike_in_arms!();
}

impl<S: Reversed, K: ReversibleClosing<S>> Around<S, K> for Orient {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        turn: S::Turn,
        (_, _, x, y, p, q): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self, S::Turn) -> S::Turn,
        side: impl FnOnce(&mut Self, S::Turn) -> S::Turn,
    ) -> S::Turn {
        let (side, main) = (side(self, turn), main(self, turn));
        closing.pose(side, main, x, y, p, q);
        main
    }
}
