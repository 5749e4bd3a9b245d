//! Costates of accelerations through the gains of a sweep: the inward half of M w = λ.

use crate::adjoint::Reversed;
use crate::relation::{Open, Wrench, WrenchOf};
use crate::shape::{Kept, Mut, PerAxes, PerJoint, Rates, Ref, Selective, Walk};

/// Replaces the costate of each joint's acceleration by what the joint does where its inboard side does not move.
pub struct Meet;

impl<S: Reversed> Walk<S> for Meet {
    /// The force that what lies outboard misses.
    type Carried = WrenchOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<Open>>,
        Ref<PerJoint<S::Pivot>>,
        Mut<Rates>,
    );
}

impl<S: Reversed> Selective<S> for Meet {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(&mut self, chain: WrenchOf<S>, go: impl FnOnce(&mut Self, WrenchOf<S>) -> WrenchOf<S>) -> WrenchOf<S> {
        chain + go(self, Wrench::none())
    }
}
