//! What loads on bodies add to the gains of joints.

use super::meet::Meet;
use crate::adjoint::{Reversed, ReversibleClosing};
use crate::relation::{Closures, Open, Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{
    Arm, Around, AtClosing, Kept, Main, Mut, PerAxes, PerBody, PerJoint, Ref, Selective, Side, Walk, Way,
};
use crate::space::FrameOf;

/// Adds loads on bodies to gains that were found without: as [`Meet`], which solves for other right-hand sides.
pub struct Burden<T: Copy, C: Closures = Open>(pub Meet<T, C>);

impl<S: Reversed, C: Closures> Walk<S> for Burden<S::Scalar, C> {
    /// The force that what lies outboard misses.
    type Carried = WrenchOf<S>;
    /// Posture; loads; gains and pivots.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        Ref<PerBody<(FrameOf<S>, WrenchOf<S>)>>,
        Mut<Kept<C>>,
        Ref<PerJoint<S::Pivot>>,
    );
}

impl<S: Reversed, C: Closures> Selective<S> for Burden<S::Scalar, C> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Burden<S::Scalar, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        chain: WrenchOf<S>,
        go: impl FnOnce(&mut Self::In<Arm>, WrenchOf<S>) -> WrenchOf<S>,
    ) -> WrenchOf<S> {
        chain + go(&mut Burden(Meet::nothing()), Wrench::none())
    }
}

impl<S: Reversed, C: Closures, K: ReversibleClosing<S>> Around<S, K> for Burden<S::Scalar, C> {
    fn around(
        &mut self,
        _: &K,
        outer: WrenchOf<S>,
        (.., (gain, _), _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self::In<Main<K::Closures>>, WrenchOf<S>) -> WrenchOf<S>,
        side: impl FnOnce(&mut Self::In<Side<K::Closures>>, WrenchOf<S>) -> WrenchOf<S>,
    ) -> WrenchOf<S> {
        let (wrench, [_, reduced]) = self.0.settle::<S, K::Closures>(gain, outer, wrapped(main), wrapped(side));
        gain.burden(&reduced);
        wrench
    }
}

/// An arm that is met under loads, as if it were met without.
fn wrapped<T: Scalar, C: Closures, W>(
    arm: impl FnOnce(&mut Burden<T, C>, W) -> W,
) -> impl FnOnce(&mut Meet<T, C>, W) -> W {
    |walk, outer| {
        let mut burden = Burden(core::mem::replace(walk, Meet::nothing()));
        let inner = arm(&mut burden, outer);
        *walk = burden.0;
        inner
    }
}
