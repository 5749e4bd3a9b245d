//! Coefficients of a motion's Taylor series, order by order: the walks of the [contract](crate::series).

use crate::relation::{AccelerationOf, Wrench, WrenchOf};
use crate::series::{Expandable, Order};
use crate::shape::{Mut, PerAxes, PerJoint, Positions, Rates, Ref, Selective, Walk};
use crate::space::RealOf;

/// What the walks keep.
type Kept<S, const N: usize> =
    (Mut<PerAxes<<S as Expandable>::AxesSeries<N>>>, Mut<PerJoint<<S as Expandable>::JointSeries>>);

/// Keeps the coefficients of order 0, of a posture.
pub struct Begin<const N: usize>;

/// Condenses what lies outboard, and keeps gains.
pub struct Articulate<const N: usize>;

/// Carries inward the force and torque on what lies outboard, as far as coefficients known so far and springs cause them.
pub struct Push<S: Expandable, const N: usize>(pub Order<RealOf<S>>);

/// Finds the accelerations of an order from that of the root, and coefficients that follow from them.
pub struct Swing<S: Expandable, const N: usize>(pub Order<RealOf<S>>);

impl<S: Expandable, const N: usize> Walk<S> for Begin<N> {
    type Carried = S::Turn;
    /// Sine and cosine of all axes; positions and rates; what is kept.
    type Stores = (Ref<PerAxes<S::X>>, Ref<PerAxes<S::Y>>, (Ref<Positions>, Ref<Rates>), Kept<S, N>);
}

impl<S: Expandable, const N: usize> Selective<S> for Begin<N> {
    const OUTWARD: bool = true;

    #[inline(always)]
    fn branch(&mut self, chain: S::Turn, go: impl FnOnce(&mut Self, S::Turn) -> S::Turn) -> S::Turn {
        go(self, chain);
        chain
    }
}

impl<S: Expandable, const N: usize> Walk<S> for Articulate<N> {
    type Carried = S::Articulated;
    type Stores = Kept<S, N>;
}

impl<S: Expandable, const N: usize> Selective<S> for Articulate<N> {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(
        &mut self,
        chain: S::Articulated,
        go: impl FnOnce(&mut Self, S::Articulated) -> S::Articulated,
    ) -> S::Articulated {
        S::join(chain, go(self, S::nothing()))
    }
}

impl<S: Expandable, const N: usize> Walk<S> for Push<S, N> {
    type Carried = WrenchOf<S>;
    type Stores = Kept<S, N>;
}

impl<S: Expandable, const N: usize> Selective<S> for Push<S, N> {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(&mut self, chain: WrenchOf<S>, go: impl FnOnce(&mut Self, WrenchOf<S>) -> WrenchOf<S>) -> WrenchOf<S> {
        chain + go(self, Wrench::none())
    }
}

impl<S: Expandable, const N: usize> Walk<S> for Swing<S, N> {
    type Carried = AccelerationOf<S>;
    /// What is kept; accelerations.
    type Stores = (Kept<S, N>, Mut<Rates>);
}

impl<S: Expandable, const N: usize> Selective<S> for Swing<S, N> {
    const OUTWARD: bool = true;

    #[inline(always)]
    fn branch(
        &mut self,
        chain: AccelerationOf<S>,
        go: impl FnOnce(&mut Self, AccelerationOf<S>) -> AccelerationOf<S>,
    ) -> AccelerationOf<S> {
        go(self, chain);
        chain
    }
}
