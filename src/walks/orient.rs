//! Postures, where costates read more of them than sweeps do.

use crate::adjoint::Reversed;
use crate::shape::{Mut, PerAxes, Positions, Rates, Ref, Selective, Walk, alike_in_arms};

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
