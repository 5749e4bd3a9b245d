//! Coefficients around loops: the forces that close a loop have the gains of every order, those of its elimination.

use super::{Articulate, Begin, Push, Swing};
use crate::relation::{Closures, Cuts, Own, Wrench, WrenchOf};
use crate::series::{ExertClosing, ExpandClosing, ExpandLoads, Expandable};
use crate::shape::{Around, AtClosing, CarriedIn, Closing, Main, Side};
use core::marker::PhantomData;
use num_traits::Zero;

/// The closure forces of a loop.
type OwnOf<S, K> = <K as Closing<S>>::Closures;

/// One number for each of these, none yet.
fn zeros<S: Expandable, C: Closures>() -> C::Each<S::Scalar> {
    C::each(|_| S::Scalar::zero())
}

impl<S: Expandable, K: ExpandClosing<S>, const N: usize> Around<S, K> for Begin<N> {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        _: &K,
        carried: S::Begun,
        _: AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self, S::Begun) -> S::Begun,
        side: impl FnOnce(&mut Self, S::Begun) -> S::Begun,
    ) -> S::Begun {
        side(self, carried);
        main(self, carried)
    }
}

impl<S: Expandable, K: ExpandClosing<S>, C: Closures, const N: usize> Around<S, K> for Articulate<S, N, C> {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        outer: S::Articulated,
        (_, _, (gain, _)): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<OwnOf<S, K>>>, S::Articulated) -> S::Articulated,
        side: impl FnOnce(&mut Self::In<Side<OwnOf<S, K>>>, S::Articulated) -> S::Articulated,
    ) -> S::Articulated {
        let columns = closing.columns();
        let mut in_side = Articulate { cuts: Cuts::at_tip(columns, zeros::<S, OwnOf<S, K>>()) };
        let mut in_main = Articulate { cuts: self.cuts.around(OwnOf::<S, K>::map(&columns, |w| -w)) };
        let side = side(&mut in_side, S::nothing());
        let mut both = S::join(main(&mut in_main, outer), side);
        (self.cuts, *gain) = OwnOf::<S, K>::eliminate(
            in_main.cuts.joined(&in_side.cuts, |a, b| a + b),
            gain.measure(),
            WrenchOf::<S>::plus_scaled,
            |w, inverse, _| both = S::closed(both, w, inverse),
        );
        both
    }
}

impl<S, K, L, C, const N: usize> Around<S, K> for Push<S, L, N, C>
where
    S: Expandable,
    K: ExertClosing<S, L::InJoint>,
    L: ExpandLoads<S, N>,
    C: Closures,
{
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        outer: S::Pushed,
        ((_, _, (gain, through)), efforts, _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<OwnOf<S, K>>>, S::Pushed) -> S::Pushed,
        side: impl FnOnce(&mut Self::In<Side<OwnOf<S, K>>>, S::Pushed) -> S::Pushed,
    ) -> S::Pushed {
        let (order, none) = (self.order, zeros::<S, OwnOf<S, K>>());
        *through = closing.exerted(order.among(efforts));
        let mut in_side = Push { order, gaps: none, loads: PhantomData };
        let mut in_main = Push { order, gaps: (zeros::<S, C>(), none), loads: PhantomData };
        let side = S::felt(side(&mut in_side, S::pushed(*through)));
        let mut both = S::felt(main(&mut in_main, S::pushed(S::felt(outer) - *through))) + side;
        let (riding, own) = in_main.gaps;
        let own = OwnOf::<S, K>::zip(&own, &in_side.gaps, |a, b| a + b);
        let (own, riding) = gain.absorbed(&own, riding, |w, share| both = WrenchOf::<S>::plus_scaled(both, -share, w));
        gain.meet(own);
        self.gaps = C::zip(&self.gaps, &riding, |a, b| a + b);
        S::pushed(both)
    }
}

impl<S, K, L, C, const N: usize> Around<S, K> for Swing<S, L, N, C>
where
    S: Expandable,
    K: ExpandClosing<S>,
    L: ExpandLoads<S, N>,
    C: Closures,
{
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        inboard: S::Swung,
        ((_, _, (gain, through)), internal, _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<OwnOf<S, K>>>, S::Swung) -> S::Swung,
        side: impl FnOnce(&mut Self::In<Side<OwnOf<S, K>>>, S::Swung) -> CarriedIn<S, Self, Side<OwnOf<S, K>>>,
    ) -> S::Swung {
        let (order, acceleration) = (self.order, S::acceleration(inboard));
        let forces = OwnOf::<S, K>::forces(gain, |w| w.work(&acceleration), &self.forces, gain.gap());
        let mut passed = *through;
        OwnOf::<S, K>::zip(&closing.columns(), &forces, |w, by| passed = WrenchOf::<S>::plus_scaled(passed, by, w));
        // Internal torques are those on the inboard side.
        *internal = S::numbers(Wrench { torque: -passed.torque, ..passed });
        side(&mut Swing { order, forces, loads: PhantomData }, S::accelerated(acceleration));
        main(&mut Swing { order, forces: (self.forces, forces), loads: PhantomData }, S::accelerated(acceleration))
    }
}
