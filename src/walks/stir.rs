//! Virtual velocities: the outward half of M w + Γᵀν = λ, Γ w = 0.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::loading::EffortOf;
use crate::relation::{Closures, Open, Own};
use crate::shape::{
    Arm, Around, AtClosing, Ends, Kept, Main, Mut, PerAxes, PerBody, PerClosure, PerJoint, PerLoop, Positions, Rates,
    Ref, Selective, Side, Walk, Way,
};

/// Carries virtual velocity outward, keeps it for each body, and adds what torques in joints do to the cost.
pub struct Stir<T: Copy, C: Closures = Open> {
    /// The closure forces −ν that act on the chain.
    pub forces: C::Each<T>,
}

impl<S: Reversed, C: Closures> Walk<S> for Stir<S::Scalar, C> {
    type Carried = S::Stirred;
    /// Posture; gains; positions, rates and accelerations of the motion; what [`Meet`](super::meet::Meet) has left, which becomes w and −ν.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<C>>,
        (Ref<Positions>, Ref<Rates>, Ref<Rates>, Mut<Rates>),
        (Mut<PerBody<S::OnBody>>, Mut<PerJoint<S::InJoint>>, (Mut<PerClosure>, Mut<PerLoop<S::AtEnds>>)),
        Mut<PerJoint<EffortOf<S>>>,
    );
}

impl<S: Reversed, C: Closures> Selective<S> for Stir<S::Scalar, C> {
    const OUTWARD: bool = true;
    type In<Y: Way> = Stir<S::Scalar, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        carried: S::Stirred,
        go: impl FnOnce(&mut Self::In<Arm>, S::Stirred) -> S::Stirred,
    ) -> S::Stirred {
        go(&mut Stir { forces: () }, carried);
        carried
    }
}

impl<S: Reversed, C: Closures, K: ReversibleClosing<S>> Around<S, K> for Stir<S::Scalar, C> {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        inner: S::Stirred,
        (x, y, p, q, (gain, _), _, (_, _, (parted, ends)), effort): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<K::Closures>>, S::Stirred) -> S::Stirred,
        side: impl FnOnce(&mut Self::In<Side<K::Closures>>, S::Stirred) -> S::Stirred,
    ) -> S::Stirred {
        let velocity = S::stirred(&inner);
        let forces =
            K::Closures::forces(gain, |w| w.work(&velocity), &self.forces, &K::Closures::reduced(gain, parted));
        *parted = forces;
        let side = side(&mut Stir { forces }, inner);
        let main = main(&mut Stir { forces: (self.forces, forces) }, inner);
        *ends = S::at_ends(&side, &main);
        closing.of_effort(Ends { x, y, p, q }, [&side, &main], effort);
        main
    }
}
