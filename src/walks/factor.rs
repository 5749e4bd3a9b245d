//! The elimination of a sweep with what a second right-hand side needs: gains, and the inverse of each pivot.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::loading::EffortOf;
use crate::relation::{Closures, Open};
use crate::shape::{
    Around, AtClosing, CarriedIn, Kept, Main, Mut, PerAxes, PerJoint, Positions, Rates, Ref, Selective, Side, Walk, Way,
};
use core::marker::PhantomData;

/// Condenses what lies outboard, under torques in joints, and keeps gains and inverse pivots, where the closure forces `C` act.
pub struct Factor<C = Open>(PhantomData<C>);

impl<C> Factor<C> {
    /// The walk.
    #[inline(always)]
    pub fn new() -> Self {
        Self(PhantomData)
    }
}

impl<S: Reversed, C: Closures> Walk<S> for Factor<C> {
    type Carried = S::Outboard<C>;
    /// Posture; positions and rates; torques; what is kept.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>),
        Ref<PerJoint<EffortOf<S>>>,
        Mut<Kept<C>>,
        Mut<PerJoint<S::Pivot>>,
    );
}

impl<S: Reversed, C: Closures> Selective<S> for Factor<C> {
    const OUTWARD: bool = false;
    const LAST_APART: bool = true;
    type In<Y: Way> = Factor<Y::Forces<C>>;

    #[inline(always)]
    fn branch(
        &mut self,
        chain: S::Outboard<C>,
        go: impl FnOnce(&mut Factor, S::Outboard<Open>) -> S::Outboard<Open>,
    ) -> S::Outboard<C> {
        S::join(chain, go(&mut Factor::new(), S::nothing()))
    }
}

impl<S: Reversed, C: Closures, K: ReversibleClosing<S>> Around<S, K> for Factor<C> {
    #[inline(always)]
    fn around(
        &mut self,
        closing: &K,
        outer: S::Outboard<C>,
        (.., effort, kept, _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(
            &mut Self::In<Main<K::Closures>>,
            CarriedIn<S, Self, Main<K::Closures>>,
        ) -> CarriedIn<S, Self, Main<K::Closures>>,
        side: impl FnOnce(
            &mut Self::In<Side<K::Closures>>,
            CarriedIn<S, Self, Side<K::Closures>>,
        ) -> CarriedIn<S, Self, Side<K::Closures>>,
    ) -> S::Outboard<C> {
        let (onto_main, into_side, passed) = closing.close_off(outer, effort);
        let side = side(&mut Factor::new(), into_side);
        let main = main(&mut Factor::new(), onto_main);
        let (relation, gain) = S::settle(main, side, kept.0.measure());
        *kept = (gain, passed);
        relation
    }
}
