//! What loads on bodies add to the gains of joints.

use crate::adjoint::Reversed;
use crate::relation::{Open, Wrench, WrenchOf};
use crate::shape::{Kept, Mut, PerAxes, PerBody, PerJoint, Ref, Selective, Walk};
use crate::space::FrameOf;

/// Adds loads on bodies to gains that were found without: as [`Meet`](super::meet::Meet), which solves for other right-hand sides.
pub struct Burden;

impl<S: Reversed> Walk<S> for Burden {
    /// The force that what lies outboard misses.
    type Carried = WrenchOf<S>;
    /// Posture; loads; gains and pivots.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<PerBody<(FrameOf<S>, WrenchOf<S>)>>,
        Mut<Kept<Open>>,
        Ref<PerJoint<S::Pivot>>,
    );
}

impl<S: Reversed> Selective<S> for Burden {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(&mut self, chain: WrenchOf<S>, go: impl FnOnce(&mut Self, WrenchOf<S>) -> WrenchOf<S>) -> WrenchOf<S> {
        chain + go(self, Wrench::none())
    }
}
