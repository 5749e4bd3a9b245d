//! Costates of accelerations through the gains of a sweep: the inward half of M w + Γᵀν = λ, Γ w = 0.

use crate::adjoint::{Reversed, ReversibleClosing};
use crate::relation::{Closures, LoopGain, Looped, Open, Own, VectorSpace, Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{
    Arm, Around, AtClosing, Kept, Main, Mut, PerAxes, PerClosure, PerJoint, Rates, Ref, Selective, Side, Walk, Way,
};

/// Replaces the costate of each joint's acceleration by what the joint does where its inboard side does not move, and keeps of each loop by
/// what its ends part then.
pub struct Meet<T: Copy, C: Closures = Open> {
    /// By what all that has been met moves where the closure forces `C` act.
    pub gaps: C::Each<T>,
}

impl<T: Scalar, C: Closures> Meet<T, C> {
    /// Nothing has been met.
    #[inline(always)]
    pub fn nothing() -> Self {
        Self { gaps: C::each(|_| T::zero()) }
    }

    /// A joint that moves freely by `left`, a force, over its pivot: `row` is what it does for each closure force.
    #[inline(always)]
    pub fn part(&mut self, row: &C::Each<T>, left: T) {
        self.gaps = C::zip(&self.gaps, row, |gap, row| row.mul_add(left, gap));
    }

    /// A joint that turns freely by `left`, a torque, over its pivot: `rows` are what it does for each closure force.
    #[inline(always)]
    pub fn part_along<V: VectorSpace<Scalar = T>>(&mut self, rows: &C::Each<V>, left: V) {
        self.gaps = C::zip(&self.gaps, rows, |gap, row| gap + V::dot(row, left));
    }

    /// What goes on inward where both arms of a loop begin, and by what its ends part, also as the elimination of its forces meets it.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn settle<S: Reversed<Scalar = T>, O: Own>(
        &mut self,
        gain: &LoopGain<WrenchOf<S>, T, C, O>,
        outer: WrenchOf<S>,
        main: impl FnOnce(&mut Meet<T, Looped<C, O>>, WrenchOf<S>) -> WrenchOf<S>,
        side: impl FnOnce(&mut Meet<T, O>, WrenchOf<S>) -> WrenchOf<S>,
    ) -> (WrenchOf<S>, [O::Each<T>; 2]) {
        let (mut in_side, mut in_main) = (Meet::nothing(), Meet::nothing());
        let mut wrench = side(&mut in_side, Wrench::none());
        wrench = main(&mut in_main, outer) + wrench;
        let (riding, own) = in_main.gaps;
        let own = O::zip(&own, &in_side.gaps, |a, b| a + b);
        let (reduced, riding) =
            gain.absorbed(&own, riding, |w, share| wrench = WrenchOf::<S>::plus_scaled(wrench, -share, w));
        self.gaps = C::zip(&self.gaps, &riding, |a, b| a + b);
        (wrench, [own, reduced])
    }
}

impl<S: Reversed, C: Closures> Walk<S> for Meet<S::Scalar, C> {
    /// The force that what lies outboard misses.
    type Carried = WrenchOf<S>;
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<Kept<C>>,
        Ref<PerJoint<S::Pivot>>,
        Mut<Rates>,
        Mut<PerClosure>,
    );
}

impl<S: Reversed, C: Closures> Selective<S> for Meet<S::Scalar, C> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Meet<S::Scalar, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        chain: WrenchOf<S>,
        go: impl FnOnce(&mut Self::In<Arm>, WrenchOf<S>) -> WrenchOf<S>,
    ) -> WrenchOf<S> {
        chain + go(&mut Meet::nothing(), Wrench::none())
    }
}

impl<S: Reversed, C: Closures, K: ReversibleClosing<S>> Around<S, K> for Meet<S::Scalar, C> {
    #[cfg_attr(optimised, inline(always))]
    fn around(
        &mut self,
        _: &K,
        outer: WrenchOf<S>,
        (.., (gain, _), _, _, parted): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<K::Closures>>, WrenchOf<S>) -> WrenchOf<S>,
        side: impl FnOnce(&mut Self::In<Side<K::Closures>>, WrenchOf<S>) -> WrenchOf<S>,
    ) -> WrenchOf<S> {
        let (wrench, [own, _]) = self.settle::<S, K::Closures>(gain, outer, main, side);
        *parted = own;
        wrench
    }
}
