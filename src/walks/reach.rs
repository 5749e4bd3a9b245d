//! Accelerations of joint coordinates from that of the root, those of bodies kept.

use crate::adjoint::Reversed;
use crate::relation::{AccelerationOf, Open};
use crate::shape::{Kept, Mut, PerAxes, PerBody, PerJoint, Rates, Ref, Selective, Walk};

/// Recovers accelerations through gains, as [`recover`](super::recover) does, and keeps those of the outboard ends of bodies and of
/// joints that slide.
pub struct Reach;

impl<S: Reversed> Walk<S> for Reach {
    type Carried = AccelerationOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<Open>>,
        Mut<Rates>,
        (Mut<PerBody<S::Vector>>, Mut<PerJoint<S::Vector>>),
    );
}

impl<S: Reversed> Selective<S> for Reach {
    const OUTWARD: bool = true;
}
