//! Virtual velocities: the outward half of M w = λ.

use crate::adjoint::Reversed;
use crate::loading::EffortOf;
use crate::relation::Open;
use crate::shape::{Kept, Mut, PerAxes, PerBody, PerJoint, Rates, Ref, Selective, Walk};

/// Carries virtual velocity outward, keeps it for each body, and adds what torques in joints do to the cost.
pub struct Stir;

impl<S: Reversed> Walk<S> for Stir {
    type Carried = S::Stirred;
    /// Posture; gains; rates and accelerations of the motion; what [`Meet`](super::meet::Meet) has left, which becomes w.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<Open>>,
        (Ref<Rates>, Ref<Rates>, Mut<Rates>),
        (Mut<PerBody<S::OnBody>>, Mut<PerJoint<S::InJoint>>),
        Mut<PerJoint<EffortOf<S>>>,
    );
}

impl<S: Reversed> Selective<S> for Stir {
    const OUTWARD: bool = true;
}
