//! Costates of positions, rates and parameters, from the virtual power of each body.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::relation::{Additive, Closures};
use crate::shape::{
    Around, AtClosing, Ends, Mut, PerAxes, PerBody, PerClosure, PerJoint, PerLoop, Positions, Rates, Ref, Selective,
    Walk, Way,
};

/// Carries G and F inward, sets the costates of positions and rates, and adds to those of parameters.
pub struct PullBack {
    /// Whether laws of springs and dampers act here: where springs enter implicitly, they are read elsewhere.
    pub laws: bool,
    /// Whether torques act: in corrections by closures nothing does but inertia.
    pub torques: bool,
    /// Whether the angular momentum of the virtual motion is carried in the plane, too: where joints are driven.
    pub angular: bool,
}

impl<S: Reversed> Walk<S> for PullBack {
    type Carried = S::Pulled;
    /// Posture; positions, rates, accelerations and w; accelerations of the outboard ends of bodies and joints, and what
    /// [`Stir`](super::stir::Stir) and [`Factor`](super::factor::Factor) have kept, −ν and λ of loops and what has been kept of their ends; costates of
    /// parameters, positions and rates.
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
            (Ref<PerClosure>, Ref<PerClosure>, Ref<PerLoop<S::AtEnds>>),
        ),
        (Mut<PerBody<S::OfBody>>, Mut<PerJoint<S::OfJoint>>),
        (Mut<Rates>, Mut<Rates>),
    );
}

impl<S: Reversed> Selective<S> for PullBack {
    const OUTWARD: bool = false;
    type In<Y: Way> = Self;

    #[inline(always)]
    fn branch(&mut self, chain: S::Pulled, go: impl FnOnce(&mut Self, S::Pulled) -> S::Pulled) -> S::Pulled {
        chain + go(self, S::Pulled::null())
    }
}

impl<S: Reversed, K: ReversibleClosing<S>> Around<S, K> for PullBack {
    /// The ends of both arms are weighed by ν in accelerations and by −λ in virtual velocities, one against the other.
    fn around(
        &mut self,
        closing: &K,
        outer: S::Pulled,
        (x, y, p, q, _, (.., pivot, (minus_weights, forces, ends)), (_, sums), _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self, S::Pulled) -> S::Pulled,
        side: impl FnOnce(&mut Self, S::Pulled) -> S::Pulled,
    ) -> S::Pulled {
        let (weights, axes) = (K::Closures::map(minus_weights, |x| -x), Ends { x, y, p, q });
        let [on_side, on_main] = closing.pulled(axes, (&weights, forces), self.torques.then_some(pivot), ends, sums);
        let side = side(self, on_side);
        main(self, outer + on_main) + side
    }
}
