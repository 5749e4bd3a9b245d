//! Accelerations of joint coordinates from that of the root, those of bodies kept.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::relation::{AccelerationOf, Closures, Open, Own};
use crate::shape::{
    Arm, Around, AtClosing, Ends, Kept, Main, Mut, PerAxes, PerBody, PerClosure, PerJoint, Rates, Ref, Selective, Side,
    Walk, Way,
};

/// Recovers accelerations through gains, as [`recover`](super::recover) does, and keeps those of the outboard ends of bodies and of
/// joints that slide, and the forces that close loops.
pub struct Reach<T: Copy, C: Closures = Open> {
    /// The closure forces that act on the chain.
    pub forces: C::Each<T>,
}

impl<S: Reversed, C: Closures> Walk<S> for Reach<S::Scalar, C> {
    type Carried = AccelerationOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<C>>,
        Mut<Rates>,
        (Mut<PerBody<S::Vector>>, Mut<PerJoint<S::Vector>>, Mut<PerClosure>),
    );
}

impl<S: Reversed, C: Closures> Selective<S> for Reach<S::Scalar, C> {
    const OUTWARD: bool = true;
    type In<Y: Way> = Reach<S::Scalar, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        carried: AccelerationOf<S>,
        go: impl FnOnce(&mut Self::In<Arm>, AccelerationOf<S>) -> AccelerationOf<S>,
    ) -> AccelerationOf<S> {
        go(&mut Reach { forces: () }, carried);
        carried
    }
}

impl<S: Reversed, C: Closures, K: ReversibleClosing<S>> Around<S, K> for Reach<S::Scalar, C> {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        inner: AccelerationOf<S>,
        (x, y, p, q, (gain, driven), internal, (_, _, found)): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<K::Closures>>, AccelerationOf<S>) -> AccelerationOf<S>,
        side: impl FnOnce(&mut Self::In<Side<K::Closures>>, AccelerationOf<S>) -> AccelerationOf<S>,
    ) -> AccelerationOf<S> {
        let forces = K::Closures::forces(gain, |w| w.work(&inner), &self.forces, gain.gap());
        *found = forces;
        *internal = S::numbers(*driven + closing.internal(&forces, Ends { x, y, p, q }));
        side(&mut Reach { forces }, inner);
        main(&mut Reach { forces: (self.forces, forces) }, inner)
    }
}
