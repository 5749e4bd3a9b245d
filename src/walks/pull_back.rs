//! Costates of positions, rates and parameters, from the virtual power of each body.

use crate::adjoint::Reversed;
use crate::relation::Additive;
use crate::shape::{Mut, PerAxes, PerBody, PerJoint, Positions, Rates, Ref, Selective, Walk};

/// Carries G and F inward, sets the costates of positions and rates, and adds to those of parameters.
pub struct PullBack {
    /// Whether laws of springs and dampers act: in corrections by closures nothing does but inertia.
    pub laws: bool,
}

impl<S: Reversed> Walk<S> for PullBack {
    type Carried = S::Pulled;
    /// Posture; positions, rates, accelerations and w; accelerations of the outboard ends of bodies and joints, and what
    /// [`Stir`](super::stir::Stir) and [`Factor`](super::factor::Factor) have kept; costates of parameters, positions and rates.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>, Ref<Rates>, Ref<Rates>),
        (
            Ref<PerBody<S::Vector>>,
            Ref<PerJoint<S::Vector>>,
            Ref<PerBody<S::OnBody>>,
            Ref<PerJoint<S::InJoint>>,
            Ref<PerJoint<S::Pivot>>,
        ),
        (Mut<PerBody<S::OfBody>>, Mut<PerJoint<S::OfJoint>>),
        (Mut<Rates>, Mut<Rates>),
    );
}

impl<S: Reversed> Selective<S> for PullBack {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(&mut self, chain: S::Pulled, go: impl FnOnce(&mut Self, S::Pulled) -> S::Pulled) -> S::Pulled {
        chain + go(self, S::Pulled::null())
    }
}
