//! Coefficients of a motion's Taylor series, order by order: the walks of the [contract](crate::series).

mod loads;
mod loops;

pub use loads::{SetOut, Weigh};

use crate::relation::{Closures, Cuts, Open, Part, WrenchOf};
use crate::series::{BorneOf, ExpandLoads, Expandable, Order};
use crate::shape::{
    Arm, AtBody, AtClosing, AtJoint, Body, Closing, Columns, Joint, Mut, Outward, PerAxes, PerBody, PerJoint,
    Positions, Rates, Ref, Selective, Walk, Way, alike, alike_in_arms,
};
use crate::space::{RealOf, Space};
use core::marker::PhantomData;

/// What the walks keep of axes and joints.
type Room<S, const N: usize> =
    (Mut<PerAxes<<S as Expandable>::AxesSeries<N>>>, Mut<PerJoint<<S as Expandable>::JointSeries<N>>>);
/// What the walks keep, where the closure forces `C` act: of these what they do to a body or a joint.
type Kept<S, C, const N: usize> =
    (Mut<PerAxes<<S as Expandable>::AxesSeries<N>>>, Mut<PerJoint<<S as Expandable>::JointSeries<N>>>, Mut<Columns<C>>);

/// Keeps the coefficients of order 0, of a posture.
pub struct Begin<const N: usize>;

/// Condenses what lies outboard, and keeps gains.
pub struct Articulate<S: Expandable, const N: usize, C: Closures = Open> {
    /// W and Λ of all that has been met.
    pub cuts: Cuts<WrenchOf<S>, S::Scalar, C>,
}

/// Carries inward the force and torque on what lies outboard, as far as coefficients known so far, springs and loads `L` cause them.
pub struct Push<S: Expandable, L, const N: usize, C: Closures = Open> {
    /// Of which order.
    pub order: Order<RealOf<S>>,
    /// y: by what all that has been met moves where the closure forces act.
    pub gaps: C::Each<S::Scalar>,
    /// Under loads of which type.
    pub loads: PhantomData<L>,
}

/// Finds the accelerations of an order from that of the root, and coefficients that follow from them.
pub struct Swing<S: Expandable, L, const N: usize, C: Closures = Open> {
    /// Of which order.
    pub order: Order<RealOf<S>>,
    /// λ of that order.
    pub forces: C::Each<S::Scalar>,
    /// Under loads of which type.
    pub loads: PhantomData<L>,
}

impl<S: Expandable, const N: usize> Walk<S> for Begin<N> {
    type Carried = S::Begun;
    /// Postures but for what velocities cause; positions and rates; what is kept.
    type Stores =
        (Ref<PerAxes<S::X>>, Ref<PerAxes<S::Y>>, Ref<PerAxes<S::P>>, (Ref<Positions>, Ref<Rates>), Room<S, N>);
}

impl<S: Expandable, const N: usize> Selective<S> for Begin<N> {
    alike_in_arms!();
}

impl<S: Expandable, C: Closures, const N: usize> Walk<S> for Articulate<S, N, C> {
    type Carried = S::Articulated;
    type Stores = Kept<S, C, N>;
}

impl<S: Expandable, C: Closures, const N: usize> Selective<S> for Articulate<S, N, C> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Articulate<S, N, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(
        &mut self,
        chain: S::Articulated,
        go: impl FnOnce(&mut Self::In<Arm>, S::Articulated) -> S::Articulated,
    ) -> S::Articulated {
        S::join(chain, go(&mut Articulate { cuts: Cuts::none() }, S::nothing()))
    }
}

impl<S: Expandable, L: ExpandLoads<S, N>, C: Closures, const N: usize> Walk<S> for Push<S, L, N, C> {
    type Carried = S::Pushed;
    /// What is kept; coefficients of efforts; loads on bodies.
    type Stores = (Kept<S, C, N>, Ref<PerJoint<[L::InJoint; N]>>, Ref<PerBody<BorneOf<S, L, N>>>);
}

impl<S: Expandable, L: ExpandLoads<S, N>, C: Closures, const N: usize> Selective<S> for Push<S, L, N, C> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Push<S, L, N, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(&mut self, chain: S::Pushed, go: impl FnOnce(&mut Self::In<Arm>, S::Pushed) -> S::Pushed) -> S::Pushed {
        let arm = go(&mut Push { order: self.order, gaps: (), loads: PhantomData }, S::unpushed());
        S::pushed(S::felt(chain) + S::felt(arm))
    }
}

impl<S: Expandable, L: ExpandLoads<S, N>, C: Closures, const N: usize> Walk<S> for Swing<S, L, N, C> {
    type Carried = S::Swung;
    /// What is kept; accelerations; loads on bodies.
    type Stores = (Kept<S, C, N>, Mut<Rates>, Mut<PerBody<BorneOf<S, L, N>>>);
}

impl<S: Expandable, L: ExpandLoads<S, N>, C: Closures, const N: usize> Selective<S> for Swing<S, L, N, C> {
    const OUTWARD: bool = true;
    type In<Y: Way> = Swing<S, L, N, Y::Forces<C>>;

    #[cfg_attr(optimised, inline(always))]
    fn branch(&mut self, carried: S::Swung, go: impl FnOnce(&mut Self::In<Arm>, S::Swung) -> S::Swung) -> S::Swung {
        // Whatever is known of one body beyond here is not of the other.
        let carried = S::accelerated(S::acceleration(carried));
        go(&mut Swing { order: self.order, forces: (), loads: PhantomData }, carried);
        carried
    }
}

/// Finds the coefficients of efforts in all joints, and whether they are those that were there.
pub struct Recite<'l, S: Space, L, const N: usize> {
    /// What acts.
    pub loads: &'l L,
    /// Around which time (s).
    pub time: RealOf<S>,
    /// How many coefficients are asked for.
    pub asked: usize,
    /// The number of the next joint.
    pub joint: usize,
    /// Whether those of the joints before were there.
    pub same: bool,
}

impl<S: Expandable, L: ExpandLoads<S, N>, const N: usize> Walk<S> for Recite<'_, S, L, N> {
    type Carried = ();
    type Stores = (Mut<PerJoint<[L::InJoint; N]>>,);
}

impl<S: Expandable, L: ExpandLoads<S, N>, const N: usize> Recite<'_, S, L, N> {
    fn meet(&mut self, efforts: &mut [L::InJoint; N]) {
        let now = self.loads.in_joint_over_time(self.time, self.joint, self.asked);
        let before = core::mem::replace(efforts, now);
        self.same &= before.iter().zip(&*efforts).all(|(before, now)| before.is_same(*now));
        self.joint += 1;
    }
}

impl<S: Expandable, L: ExpandLoads<S, N>, const N: usize> Outward<S> for Recite<'_, S, L, N> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), (efforts,): AtJoint<'_, S, Self, J>) {
        self.meet(efforts);
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [(); 2], (efforts,): AtClosing<'_, S, Self, K>) {
        self.meet(efforts);
    }
}
