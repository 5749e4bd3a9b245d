//! By what closures of a loop are measured, to tell those that follow from others.

use crate::element::Coordinates;
use crate::relation::{Additive, Closures, Own};
use crate::scalar::Scalar;
use crate::shape::{
    AtBody, AtJoint, Body, Closing, Joint, Kept, Main, Mut, Of, Outward, OwnOf, Parallel, Positions, Rates, Ref, Shape,
    Side, Slot, Walk, Way,
};
use crate::space::{Frame, FrameOf, Space};
use crate::visit::last_body;
use core::marker::PhantomData;
use num_traits::Zero;

/// Room for the gains of a chain, in which loops know by what their closures are measured.
pub fn gains<S: Space, E: Shape<S>, C: Closures>(chain: &E) -> E::Store<Kept<C>> {
    let mut kept = chain.store::<Kept<C>>(());
    if const { E::LOOPS > 0 } {
        let (position, rate) = (chain.store::<Positions>(()), chain.store::<Rates>(()));
        chain.outward(&mut Measure::<C>(PhantomData), (), (&position, &rate, &mut kept));
    }
    kept
}

/// What the last bodies of both arms of a loop would yield to the forces that close it if they were free.
pub(super) fn yields<S: Space, N: Parallel<S>>(
    net: &N,
    frame: FrameOf<S>,
    main: Coordinates<'_, S, N::Main>,
    side: Coordinates<'_, S, N::Side>,
) -> <OwnOf<S, N> as Closures>::Each<S::Scalar> {
    let none = OwnOf::<S, N>::each(|_| Zero::zero());
    let bodies = [last_body(net.main_arm(), frame, main), last_body(net.side_arm(), frame, side)];
    // A body without extent does not say how it would turn.
    let add = |a: S::Scalar, b: S::Scalar| if b.is_finite() { a + b } else { a };
    bodies
        .iter()
        .flatten()
        .fold(none, |sum, body| OwnOf::<S, N>::zip(&sum, &net.closing_joint().free_compliance(body), add))
}

/// Measures loops where `C` act on the chain.
struct Measure<C>(PhantomData<C>);

impl<S: Space, C: Closures> Walk<S> for Measure<C> {
    type Carried = ();
    type Stores = (Ref<Positions>, Ref<Rates>, Mut<Kept<C>>);
}

impl<S: Space, C: Closures> Outward<S> for Measure<C> {
    type In<Y: Way> = Measure<Y::Forces<C>>;

    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self::In<Y>) -> X) -> X {
        go(&mut Measure(PhantomData))
    }
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
    /// A measure need not know where bodies are: as they are turned, each yields by a factor of a few at most.
    fn parallel<N: Parallel<S>>(&mut self, net: &N, (): (), stores: Of<'_, S, Self, N>) {
        let (main, side, (_, _, (gain, _))) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let in_main = Coordinates::<S, N::Main> { position: main.0, rate: main.1, acceleration: main.1 };
        let in_side = Coordinates::<S, N::Side> { position: side.0, rate: side.1, acceleration: side.1 };
        *gain =
            gain.measured(OwnOf::<S, N>::measure(|| yields(net, Frame::resting(Additive::null()), in_main, in_side)));
        Outward::<S>::enter::<Main<OwnOf<S, N>>, _>(self, |walk| net.main_arm().outward(walk, (), main));
        Outward::<S>::enter::<Side<OwnOf<S, N>>, _>(self, |walk| net.side_arm().outward(walk, (), side));
    }
}
