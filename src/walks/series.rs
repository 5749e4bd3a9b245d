//! Coefficients of a motion's Taylor series, order by order: the walks of the [contract](crate::series).

use crate::relation::{AccelerationOf, Part, Wrench, WrenchOf};
use crate::series::{ExpandLoads, Expandable, Order};
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, PerAxes, PerJoint, Positions, Rates, Ref,
    Selective, Walk, Way, alike, alike_in_arms,
};
use crate::space::{RealOf, Space};
use core::marker::PhantomData;

/// What the walks keep.
type Kept<S, const N: usize> =
    (Mut<PerAxes<<S as Expandable>::AxesSeries<N>>>, Mut<PerJoint<<S as Expandable>::JointSeries>>);

/// Keeps the coefficients of order 0, of a posture.
pub struct Begin<const N: usize>;

/// Condenses what lies outboard, and keeps gains.
pub struct Articulate<const N: usize>;

/// Carries inward the force and torque on what lies outboard, as far as coefficients known so far, springs and efforts `Q` cause them.
pub struct Push<S: Expandable, Q, const N: usize>(pub Order<RealOf<S>>, pub PhantomData<Q>);

/// Finds the accelerations of an order from that of the root, and coefficients that follow from them.
pub struct Swing<S: Expandable, const N: usize>(pub Order<RealOf<S>>);

impl<S: Expandable, const N: usize> Walk<S> for Begin<N> {
    type Carried = S::Begun;
    /// Postures but for what velocities cause; positions and rates; what is kept.
    type Stores =
        (Ref<PerAxes<S::X>>, Ref<PerAxes<S::Y>>, Ref<PerAxes<S::P>>, (Ref<Positions>, Ref<Rates>), Kept<S, N>);
}

impl<S: Expandable, const N: usize> Selective<S> for Begin<N> {
    alike_in_arms!();
}

impl<S: Expandable, const N: usize> Walk<S> for Articulate<N> {
    type Carried = S::Articulated;
    type Stores = Kept<S, N>;
}

impl<S: Expandable, const N: usize> Selective<S> for Articulate<N> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Self;

    #[inline(always)]
    fn branch(
        &mut self,
        chain: S::Articulated,
        go: impl FnOnce(&mut Self, S::Articulated) -> S::Articulated,
    ) -> S::Articulated {
        S::join(chain, go(self, S::nothing()))
    }
}

impl<S: Expandable, Q: Part, const N: usize> Walk<S> for Push<S, Q, N> {
    type Carried = WrenchOf<S>;
    /// What is kept; coefficients of efforts.
    type Stores = (Kept<S, N>, Ref<PerJoint<[Q; N]>>);
}

impl<S: Expandable, Q: Part, const N: usize> Selective<S> for Push<S, Q, N> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Self;

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
    alike_in_arms!();
}

/// Finds the coefficients of efforts in all joints, and whether they are those that were there.
pub struct Recite<'l, S: Space, L, const N: usize> {
    /// What acts.
    pub loads: &'l L,
    /// Around which time (s).
    pub time: RealOf<S>,
    /// The number of the next joint.
    pub joint: usize,
    /// Whether those of the joints before were there.
    pub same: bool,
}

impl<S: Space, L: ExpandLoads<S>, const N: usize> Walk<S> for Recite<'_, S, L, N> {
    type Carried = ();
    type Stores = (Mut<PerJoint<[L::InJoint; N]>>,);
}

impl<S: Space, L: ExpandLoads<S>, const N: usize> Recite<'_, S, L, N> {
    fn meet(&mut self, efforts: &mut [L::InJoint; N]) {
        let before = core::mem::replace(efforts, self.loads.in_joint_over_time(self.time, self.joint));
        self.same &= before.iter().zip(&*efforts).all(|(before, now)| before.is_same(*now));
        self.joint += 1;
    }
}

impl<S: Space, L: ExpandLoads<S>, const N: usize> Outward<S> for Recite<'_, S, L, N> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (efforts,): AtJoint<'_, S, Self, J>) {
        self.meet(efforts);
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (efforts,): AtClosing<'_, S, Self, K>) {
        self.meet(efforts);
    }
}
