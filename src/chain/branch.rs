//! Arms that leave a chain.

use crate::counts::Counted;
use crate::element::{Carrying, Condense, Element, Given, Posture, Space, Sweep};
use crate::lift::lift;
use crate::relation::{Join, Open};
use crate::shape::{Arm, Aside, Field, Inward, Kept, Of, Outward, PerAxes, Shape, arm_inward, arm_outward};
use num_traits::Zero;

/// An arm that leaves the chain where this stands in it: a chain of its own with a free tip, that begins at this station. The chain
/// goes on from the same station with what follows.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
/// // Two rods hang by pins of their own from the end of a third.
/// let y = System::new(Pinned::origin(), (rod, Branch((Pin, rod)), Pin, rod), Free)?.with_gravity(9.81);
/// let start = y.at_rest(&[-1.0, -0.5, -2.0])?; // absolute angles (rad): of the third, of the arm, of the one that goes on
/// assert_eq!(y.angles(&start)?.body::<1>(), Some(&-0.5));
/// # Ok::<(), catena::Error>(())
/// ```
///
/// An arm begins with its own joint, or with a body that is then fixed to the body inboard of the station. It may carry
/// arms. Several arms at a station are several branches, one after the other, in an array or in a vector: `[Branch((Pin, rod)); 3]`. Where
/// they end the chain, all of them are equal: `(rod, Branch((Pin, rod)), Branch((Pin, rod)))` is the scene above.
///
/// Bodies, joints, stations and coordinates are numbered as they are written: the chain up to the arm, the arm, what follows. The tip
/// of the scene is that of the chain; it alone may be held. The forces inside the elements that meet at a station are those at
/// *their* inboard ends, and that at the outboard end of the body which carries them is their sum.
///
/// Forces that hold the tip do not reach into an arm but through the motion of its station, so its gains know nothing of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Branch<A>(pub A);

impl<S: Space, A: Shape<S>> Shape<S> for Branch<A> {
    type Store<F: Field<S>> = A::Store<F::In<Arm>>;

    const BODIES: Option<usize> = A::BODIES;
    const JOINTS: Option<usize> = A::JOINTS;
    const LOOPS: usize = A::LOOPS;
    const SHARES: bool = A::SHARES;
    const LINEAR: bool = A::LINEAR;
    const ROTARY: bool = A::ROTARY;
    const OWN_AXES: bool = A::OWN_AXES;
    const SINES: usize = A::SINES;
    const FLANGED: bool = A::FLANGED;

    fn store<F: Field<S>>(&self, fill: F::Fill) -> Self::Store<F> {
        self.0.store::<F::In<Arm>>(F::fill_in::<Arm>(fill))
    }
    #[inline(always)]
    fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        arm_outward::<S, W, Self>(walk, &self.0, carried, stores)
    }
    #[inline(always)]
    fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        arm_inward::<S, W, Self>(walk, &self.0, carried, stores)
    }
}

impl<S: Space, A: Shape<S>> Aside<S> for Branch<A> {
    type Arm = A;

    #[inline(always)]
    fn arm<F: Field<S>>(store: &A::Store<F::In<Arm>>) -> &A::Store<F::In<Arm>> {
        store
    }
    #[inline(always)]
    fn arm_mut<F: Field<S>>(store: &mut A::Store<F::In<Arm>>) -> &mut A::Store<F::In<Arm>> {
        store
    }
}

impl<S: Space, A: Element<S>> Element<S> for Branch<A> {
    type Position = A::Position;
    type Rate = A::Rate;

    const ABSOLUTE: bool = A::ABSOLUTE; // and what follows is turned from where the arm begins

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        mass + self.0.lump(S::Scalar::zero())
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
        self.0.orient(position, rate, turn, x, y, p, q);
        turn
    }
    #[cfg_attr(optimised, inline(always))]
    fn resolve(
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) {
        A::resolve(sizes, x, y, p, q);
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
        self.0.pose(position, rate, turn, sizes, x, y, p, q);
        turn
    }
}

/// What a sweep carries into an arm: no closure forces.
type InArm<S, W> = Carrying<<W as Sweep<S>>::Loads, <W as Sweep<S>>::Springs>;

impl<S, R, W, A> Condense<S, R, W> for Branch<A>
where
    S: Space,
    W: Sweep<S>,
    A: Condense<S, S::Nothing, InArm<S, W>>,
    R: Join<A::Out>,
{
    type Out = R::Out;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut A::Store<Kept<Open>>,
    ) -> R::Out {
        let given = Given { on_bodies, in_joints, position, rate, reading, springs };
        outer.join(self.0.condense(S::Nothing::default(), Posture { x, y, p, q }, given, kept))
    }
}

impl<A: Counted> Counted for Branch<A> {
    type Bodies = A::Bodies;
    type Freedoms = A::Freedoms;
}

lift!(Branch<A> { 0 });
