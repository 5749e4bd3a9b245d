//! Arms in parallel, between two stations.

use super::{deeper, sum};
use crate::element::{Element, Space};
use crate::lift::lift;
use crate::mirror::{Tied, TiedPosition};
use crate::relation::{Looped, Own};
use crate::shape::{
    Closing, ClosingEntry, Field, Inward, Main, MainStore, Of, Outward, Parallel, PerAxes, Shape, Side, SideStore,
};
use core::ops::Add;
use typenum::{Sum, Unsigned};

/// Two arms in parallel: both begin at this station, and end at the same one, where the chain goes on from the main arm. The side arm
/// is joined to the end of the main arm by a joint of its own, which closes the loop: a `Pin` or `Weld` in the plane, a `Ball`,
/// `Revolute` or `Weld` in space.
///
/// ```
/// use catena::loading::Unloaded;
/// use catena::planar::*;
/// let rod = Rod::uniform(0.5, 1.0); // length (m), mass (kg)
/// // A rod, and from its end two pairs of rods that meet again.
/// let net = System::new(Pinned::origin(), (rod, Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin)), Free)?;
/// let net = net.with_gravity(9.81);
/// let start = net.at_rest(&[-1.5, -1.0, -2.0, -2.0, -1.0])?; // absolute angles (rad): the rod, the main arm, the side arm
/// let start = net.assembled(start, &Unloaded)?; // closes the loop to the last digit, if it is not
/// let run = net.simulate(start, Rk4::step(1e-3), 0.1, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
///
/// Three arms are a network whose main or side arm is a network. Arms may carry branches, loops and springs, and begin with a joint or
/// a body. An arm that comes back to its own body is a `ClosedLoop`. A loop through the ground has its arms begin there: at a
/// root `Clamped` to the ground, with massless bodies ([`RigidBody::massless`](crate::planar::RigidBody::massless)) that reach to where each arm is held.
///
/// The forces that close a loop are eliminated where the loop begins: it costs nothing outside of it. They must be independent of each other
/// *within the loop*; if not, [`Fault::RedundantClosures`](crate::Fault::RedundantClosures) names one, unless the closing joint is a [`LeastNorm`](super::LeastNorm). Forces and station of the closing joint
/// come after those of both arms: bodies, joints, stations and coordinates are numbered main arm, side arm, closing joint, what
/// follows. The force at its station is that which the side arm passes on to the main arm, and positive as in any joint of the side arm.
///
/// Loops in a row, such as the windows of a ladder, nest: `Network::new((Pin, rod), (reach, rest, Pin, rod), Pin)`, where `rest` is the same
/// with one window less, or `Network::new((rest, Pin, rod), (reach, Pin, rod), Pin)`. Into a side arm only the forces of its own loop
/// ride, into a main arm also those of all loops around it: let the *side* arm carry the rest. A run of twelve windows compiles
/// in 8 s so and in 17 s with the rest in main arms (release; 0.3 GB), and steps a tenth faster.
///
/// Motions keep the coordinates of both arms, more than there are freedoms: steps keep them closed by projection of positions and
/// rates through the gains of the sweep. An end of an arm between a joint and the closing joint must have inertia, as
/// everywhere: cut a loop at a smooth joint, and let springs sit elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Network<M, A, K> {
    arms: (M, A),
    pub(super) closing: K,
}

impl<M, A, K> Network<M, A, K> {
    /// A main arm, from whose end the chain goes on, a side arm, and the joint of the latter to the end of the former.
    pub const fn new(main: M, side: A, closing: K) -> Self {
        Self { arms: (main, side), closing }
    }

    /// The main arm.
    pub fn main(&self) -> &M {
        &self.arms.0
    }

    /// The side arm.
    pub fn side(&self) -> &A {
        &self.arms.1
    }
}

/// Closure forces of the loop.
pub(super) type OwnOf<S, K> = <K as Closing<S>>::Closures;
/// Closure forces in the main arm.
pub(super) type Inside<S, C, K> = Looped<C, OwnOf<S, K>>;

impl<S: Space, M: Shape<S>, A: Shape<S>, K: Closing<S>> Shape<S> for Network<M, A, K> {
    type Store<F: Field<S>> =
        Tied<(M::Store<F::In<Main<OwnOf<S, K>>>>, A::Store<F::In<Side<OwnOf<S, K>>>>), F::InClosing<K>>;

    const BODIES: Option<usize> = sum(M::BODIES, A::BODIES);
    const JOINTS: Option<usize> = sum(sum(M::JOINTS, A::JOINTS), Some(1));
    const LOOPS: usize = 1 + deeper(M::LOOPS, A::LOOPS);
    const SHARES: bool = <OwnOf<S, K> as Own>::SHARES || M::SHARES || A::SHARES;
    const LINEAR: bool = M::LINEAR && A::LINEAR;
    const ROTARY: bool = M::ROTARY || A::ROTARY;
    const OWN_AXES: bool = M::OWN_AXES || A::OWN_AXES;
    const SINES: usize = M::SINES.saturating_add(A::SINES);
    const FLANGED: bool = M::FLANGED || A::FLANGED;

    fn store<F: Field<S>>(&self, fill: F::Fill) -> Self::Store<F> {
        let main = self.main().store::<F::In<Main<OwnOf<S, K>>>>(F::fill_in::<Main<OwnOf<S, K>>>(fill));
        let side = self.side().store::<F::In<Side<OwnOf<S, K>>>>(F::fill_in::<Side<OwnOf<S, K>>>(fill));
        Tied { arms: (main, side), closing: F::in_closing(&self.closing, fill) }
    }
    #[inline(always)]
    fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        walk.parallel(self, carried, stores)
    }
    #[inline(always)]
    fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        walk.parallel(self, carried, stores)
    }
}

impl<S: Space, M: Shape<S>, A: Shape<S>, K: Closing<S>> Parallel<S> for Network<M, A, K> {
    type Main = M;
    type Side = A;
    type Closing = K;

    fn main_arm(&self) -> &M {
        &self.arms.0
    }
    fn side_arm(&self) -> &A {
        &self.arms.1
    }
    fn closing_joint(&self) -> &K {
        &self.closing
    }
    #[cfg_attr(optimised, inline(always))]
    fn fork<F: Field<S>>(
        store: &Self::Store<F>,
    ) -> (&MainStore<S, Self, F>, &SideStore<S, Self, F>, &ClosingEntry<S, Self, F>) {
        (&store.arms.0, &store.arms.1, &store.closing)
    }
    #[cfg_attr(optimised, inline(always))]
    fn fork_mut<F: Field<S>>(
        store: &mut Self::Store<F>,
    ) -> (&mut MainStore<S, Self, F>, &mut SideStore<S, Self, F>, &mut ClosingEntry<S, Self, F>) {
        (&mut store.arms.0, &mut store.arms.1, &mut store.closing)
    }
}

impl<S: Space, M: Element<S>, A: Element<S>, K: Closing<S>> Element<S> for Network<M, A, K> {
    type Position = TiedPosition<(M::Position, A::Position), S::Numbers>;
    type Rate = Tied<(M::Rate, A::Rate), S::Numbers>;

    const ABSOLUTE: bool = M::ABSOLUTE && A::ABSOLUTE;
    const TURNS_ANEW: bool = M::TURNS_ANEW;

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.arms.0.lump(mass) + self.arms.1.lump(num_traits::Zero::zero())
    }
    #[inline(always)]
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        self.main().turned(&position.arms.0, &rate.arms.0, turn)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        let (position, rate) = (&position.arms, &rate.arms);
        let side =
            self.side().orient(&position.1, &rate.1, turn, &mut x.arms.1, &mut y.arms.1, &mut p.arms.1, &mut q.arms.1);
        let main =
            self.main().orient(&position.0, &rate.0, turn, &mut x.arms.0, &mut y.arms.0, &mut p.arms.0, &mut q.arms.0);
        self.closing.orient(side, main, &mut x.closing, &mut y.closing, &mut p.closing, &mut q.closing);
        main
    }
    #[cfg_attr(optimised, inline(always))]
    fn resolve(
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) {
        M::resolve(&sizes.arms.0, &mut x.arms.0, &mut y.arms.0, &mut p.arms.0, &mut q.arms.0);
        A::resolve(&sizes.arms.1, &mut x.arms.1, &mut y.arms.1, &mut p.arms.1, &mut q.arms.1);
    }
    #[cfg_attr(optimised, inline(always))]
    fn pose(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        let (position, rate) = (&position.arms, &rate.arms);
        let side = self.side().pose(
            &position.1,
            &rate.1,
            turn,
            &sizes.arms.1,
            &mut x.arms.1,
            &mut y.arms.1,
            &mut p.arms.1,
            &mut q.arms.1,
        );
        let main = self.main().pose(
            &position.0,
            &rate.0,
            turn,
            &sizes.arms.0,
            &mut x.arms.0,
            &mut y.arms.0,
            &mut p.arms.0,
            &mut q.arms.0,
        );
        self.closing.orient(side, main, &mut x.closing, &mut y.closing, &mut p.closing, &mut q.closing);
        main
    }
}

impl<M, A, K> crate::counts::Counted for Network<M, A, K>
where
    M: crate::counts::Counted<Bodies: Add<A::Bodies, Output: Unsigned>, Freedoms: Add<A::Freedoms, Output: Unsigned>>,
    A: crate::counts::Counted,
{
    type Bodies = Sum<M::Bodies, A::Bodies>;
    type Freedoms = Sum<M::Freedoms, A::Freedoms>;
}

lift!(Network<M, A, K> { arms, closing });
