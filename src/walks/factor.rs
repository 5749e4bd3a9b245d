//! The elimination of a sweep with what a second right-hand side needs: gains, and the inverse of each pivot.

use crate::adjoint::{Outboard, Reversed, ReversibleClosing};
use crate::element::{Explicit, Springs};
use crate::loading::EffortOf;
use crate::relation::{Closures, Open};
use crate::shape::{
    Arm, Around, AtClosing, CarriedIn, Ends, Kept, Main, Mut, PerAxes, PerJoint, Positions, Rates, Ref, Selective,
    Side, Walk, Way,
};
use core::marker::PhantomData;

/// Condenses what lies outboard, under torques in joints, and keeps gains and inverse pivots, where the closure forces `C` act and springs
/// enter by `By`.
pub struct Factor<C = Open, By = Explicit> {
    /// How springs enter.
    pub springs: By,
    closures: PhantomData<C>,
}

impl<C, By> Factor<C, By> {
    /// The walk.
    #[inline(always)]
    pub fn by(springs: By) -> Self {
        Self { springs, closures: PhantomData }
    }
}

impl<S: Reversed, C: Closures, By: Springs<S::Scalar>> Walk<S> for Factor<C, By> {
    type Carried = Outboard<S, C>;
    /// Posture; positions and rates of joints for springs, and where the last sweep has led, by which acceleration; torques; what is kept.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>, (Ref<Positions>, Ref<Rates>, Ref<Rates>)),
        Ref<PerJoint<EffortOf<S>>>,
        Mut<Kept<C>>,
        Mut<PerJoint<S::Pivot>>,
    );
}

impl<S: Reversed, C: Closures, By: Springs<S::Scalar>> Selective<S> for Factor<C, By> {
    const OUTWARD: bool = false;
    const LAST_APART: bool = true;
    type In<Y: Way> = Factor<Y::Forces<C>, By>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        chain: Outboard<S, C>,
        go: impl FnOnce(&mut Self::In<Arm>, Outboard<S, Open>) -> Outboard<S, Open>,
    ) -> Outboard<S, C> {
        chain.join(go(&mut Factor::by(self.springs), Outboard::nothing()))
    }
}

impl<S, C, K, By> Around<S, K> for Factor<C, By>
where
    S: Reversed,
    C: Closures,
    K: ReversibleClosing<S>,
    By: Springs<S::Scalar>,
{
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        closing: &K,
        outer: Outboard<S, C>,
        (x, y, p, q, _, effort, kept, pivot): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(
            &mut Self::In<Main<K::Closures>>,
            CarriedIn<S, Self, Main<K::Closures>>,
        ) -> CarriedIn<S, Self, Main<K::Closures>>,
        side: impl FnOnce(
            &mut Self::In<Side<K::Closures>>,
            CarriedIn<S, Self, Side<K::Closures>>,
        ) -> CarriedIn<S, Self, Side<K::Closures>>,
    ) -> Outboard<S, C> {
        let (onto_main, into_side, passed) = closing.close_off(outer, effort, Ends { x, y, p, q }, pivot);
        let side = side(&mut Factor::by(self.springs), into_side);
        let main = main(&mut Factor::by(self.springs), onto_main);
        let (relation, gain) = main.settle(side, kept.0.measure());
        *kept = (gain, passed);
        relation
    }
}
