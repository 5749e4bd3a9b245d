//! What joint coordinates do where only closure forces act.

use crate::element::Posture;
use crate::relation::{AccelerationOf, Closures, Looped, Own};
use crate::shape::{
    AtBody, AtJoint, Body, Joint, Kept, Mut, Of, Outward, OwnOf, Parallel, PerAxes, Rates, Ref, Shape, Slot, Walk, Way,
};
use crate::space::Space;
use num_traits::Zero;

/// What joint coordinates do where only closure forces act: [`recover`](super::recover::recover) through the same gains without
/// velocities, loads and springs. It serves corrections of positions and rates as well as accelerations.
#[cfg_attr(optimised, inline(always))]
pub fn respond<S: Space, E: Shape<S>, C: Closures>(
    chain: &E,
    acceleration: AccelerationOf<S>,
    posture: Posture<'_, S, E>,
    kept: &E::Store<Kept<C>>,
    multipliers: C::Each<S::Scalar>,
    rate: &mut E::Store<Rates>,
) -> AccelerationOf<S> {
    let Posture { x, y, p, q } = posture;
    chain.outward(&mut Respond::<S, C> { multipliers }, acceleration, (x, y, p, q, kept, rate))
}

/// Knows the closure forces.
struct Respond<S: Space, C: Closures> {
    multipliers: C::Each<S::Scalar>,
}

impl<S: Space, C: Closures> Walk<S> for Respond<S, C> {
    type Carried = AccelerationOf<S>;
    type Stores =
        (Ref<PerAxes<S::X>>, Ref<PerAxes<S::Y>>, Ref<PerAxes<S::P>>, Ref<PerAxes<S::Q>>, Ref<Kept<C>>, Mut<Rates>);
}

impl<S: Space, C: Closures> Outward<S> for Respond<S, C> {
    type In<Y: Way> = Respond<S, Y::Forces<C>>;

    /// Into an arm that no closure forces reach.
    #[inline(always)]
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        go(&mut Respond { multipliers: Y::Forces::<C>::each(|_| S::Scalar::zero()) })
    }
    #[cfg_attr(optimised, inline(always))]
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        acceleration: AccelerationOf<S>,
        (x, y, p, q, _, _): AtBody<'_, S, Self, B>,
    ) -> AccelerationOf<S> {
        body.swung(acceleration, (x, y, p, q))
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        acceleration: AccelerationOf<S>,
        (x, y, p, q, kept, rate): AtJoint<'_, S, Self, J>,
    ) -> AccelerationOf<S> {
        joint.respond::<C>(acceleration, (x, y, p, q), kept, &self.multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        acceleration: AccelerationOf<S>,
        stores: Of<'_, S, Self, N>,
    ) -> AccelerationOf<S> {
        let (main, side, (_, _, _, _, (gain, _), _)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let still = OwnOf::<S, N>::each(|_| S::Scalar::zero());
        let forces = OwnOf::<S, N>::forces(gain, |w| w.work(&acceleration), &self.multipliers, &still);
        net.side_arm().outward(&mut Respond::<S, OwnOf<S, N>> { multipliers: forces }, acceleration, side);
        let mut in_main = Respond::<S, Looped<C, OwnOf<S, N>>> { multipliers: (self.multipliers, forces) };
        net.main_arm().outward(&mut in_main, acceleration, main)
    }
}
