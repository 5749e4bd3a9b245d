//! The elimination of a sweep with what a second right-hand side needs: gains, and the inverse of each pivot.

use crate::adjoint::Reversed;
use crate::loading::EffortOf;
use crate::relation::Open;
use crate::shape::{Kept, Mut, PerAxes, PerJoint, Positions, Rates, Ref, Selective, Walk};

/// Condenses what lies outboard, under torques in joints, and keeps gains and inverse pivots.
pub struct Factor;

impl<S: Reversed> Walk<S> for Factor {
    type Carried = S::Outboard;
    /// Posture; positions and rates; torques; what is kept.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>),
        Ref<PerJoint<EffortOf<S>>>,
        Mut<Kept<Open>>,
        Mut<PerJoint<S::Pivot>>,
    );
}

impl<S: Reversed> Selective<S> for Factor {
    const OUTWARD: bool = false;
    const LAST_APART: bool = true;

    #[inline(always)]
    fn branch(&mut self, chain: S::Outboard, go: impl FnOnce(&mut Self, S::Outboard) -> S::Outboard) -> S::Outboard {
        S::join(chain, go(self, S::nothing()))
    }
}
