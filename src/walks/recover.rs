//! Accelerations of joint coordinates from that of the root: the last walk of a sweep.

use crate::element::Posture;
use crate::relation::{AccelerationOf, Closures, Looped, Own};
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Ends, Joint, Kept, Mut, Of, Outward, OwnOf, Parallel, PerAxes, Rates, Ref, Shape,
    Slot, Walk, Way,
};
use crate::space::Space;
use crate::sweep::Springs;
use core::marker::PhantomData;
use num_traits::Zero;

/// Recovers the accelerations of joint coordinates from that of the inboard station, after a sweep in which springs entered by `By`.
#[cfg_attr(optimised, inline(always))]
pub fn recover<S: Space, E: Shape<S>, C: Closures, By: Springs<S::Scalar>>(
    chain: &E,
    acceleration: AccelerationOf<S>,
    posture: Posture<'_, S, E>,
    kept: &mut E::Store<Kept<C>>,
    multipliers: C::Each<S::Scalar>,
    rate: &mut E::Store<Rates>,
) -> AccelerationOf<S> {
    let Posture { x, y, p, q } = posture;
    chain.outward(&mut Recover::<S, C, By>::by(multipliers), acceleration, (x, y, p, q, kept, rate))
}

/// Knows the closure forces.
struct Recover<S: Space, C: Closures, By> {
    multipliers: C::Each<S::Scalar>,
    by: PhantomData<By>,
}

impl<S: Space, C: Closures, By> Recover<S, C, By> {
    #[inline(always)]
    fn by(multipliers: C::Each<S::Scalar>) -> Self {
        Self { multipliers, by: PhantomData }
    }
}

impl<S: Space, C: Closures, By: Springs<S::Scalar>> Walk<S> for Recover<S, C, By> {
    type Carried = AccelerationOf<S>;
    type Stores =
        (Ref<PerAxes<S::X>>, Ref<PerAxes<S::Y>>, Ref<PerAxes<S::P>>, Ref<PerAxes<S::Q>>, Mut<Kept<C>>, Mut<Rates>);
}

impl<S: Space, C: Closures, By: Springs<S::Scalar>> Outward<S> for Recover<S, C, By> {
    type In<Y: Way> = Recover<S, Y::Forces<C>, By>;

    /// Into an arm that no closure forces reach.
    #[inline(always)]
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        go(&mut Recover::by(Y::Forces::<C>::each(|_| S::Scalar::zero())))
    }
    #[cfg_attr(optimised, inline(always))]
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        acceleration: AccelerationOf<S>,
        (x, y, p, q, _, _): AtBody<'_, S, Self, B>,
    ) -> AccelerationOf<S> {
        body.shifted(acceleration, (x, y, p, q))
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        acceleration: AccelerationOf<S>,
        (x, y, p, q, kept, rate): AtJoint<'_, S, Self, J>,
    ) -> AccelerationOf<S> {
        joint.recover::<C, By>(acceleration, (x, y, p, q), kept, &self.multipliers, rate)
    }
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(
        &mut self,
        net: &N,
        acceleration: AccelerationOf<S>,
        stores: Of<'_, S, Self, N>,
    ) -> AccelerationOf<S> {
        let (main, side, (x, y, p, q, (gain, driven), internal)) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let forces = OwnOf::<S, N>::forces(gain, |w| w.work(&acceleration), &self.multipliers, gain.gap());
        let passed = net.closing_joint().internal(&forces, Ends { x, y, p, q });
        *internal = S::numbers(*driven + passed);
        net.side_arm().outward(&mut Recover::<S, OwnOf<S, N>, By>::by(forces), acceleration, side);
        let mut in_main = Recover::<S, Looped<C, OwnOf<S, N>>, By>::by((self.multipliers, forces));
        net.main_arm().outward(&mut in_main, acceleration, main)
    }
}
