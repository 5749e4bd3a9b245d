//! Names of joints, bodies and ends.

use super::CloseOff;
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Posture, RealOf, Space, Sweep};
use crate::ends::{Resting, Root};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::loading::EffortOf;
use crate::relation::{Closures, WrenchOf};
use crate::scalar::Scalar;
use crate::sensitive::{At, RelationOf, Seeds, Sensitive, Varied};
use crate::shape::{
    Closing, Ends, Field, Inward, Kept, Member, Nth, Of, Outward, PerAxes, PerBody, PerJoint, Shape, Slot,
};
use crate::space::FrameOf;

/// An element, a joint that closes a loop, or the root of a scene, with a name. Sweeps, motions and numbers are those of what is named:
/// a name costs nothing.
///
/// The name is that of all bodies and joints inside which have none of their own: `(Pin, rod).named("forearm")` names a joint and a
/// body. It is read by [`System::joint`](crate::system::System::joint), [`System::body`](crate::system::System::body) and
/// [`System::describe`](crate::system::System::describe). Several may have the same name, as in an array of equal links; they are
/// reached by number.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let arm = (rod.named("upper arm"), Pin.named("elbow"), rod.named("forearm"));
/// let scene = System::new(Pinned::origin().named("shoulder"), arm, Free)?;
/// assert_eq!((scene.joint("shoulder")?.joint, scene.joint("elbow")?.joint, scene.body("forearm")?.body), (0, 1, 1));
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Named<E> {
    /// What is named.
    pub item: E,
    /// Name of the item.
    pub name: &'static str,
}

/// Gives names: to bodies, joints and chains of them, to joints that close loops, to roots.
pub trait Name: Sized {
    /// Gives the item a name.
    fn named(self, name: &'static str) -> Named<Self> {
        Named { item: self, name }
    }
}

impl<E> Name for E {}

impl<S: Space, E: Shape<S>> Shape<S> for Named<E> {
    type Store<F: Field<S>> = E::Store<F>;

    const BODIES: Option<usize> = E::BODIES;
    const JOINTS: Option<usize> = E::JOINTS;
    const LOOPS: usize = E::LOOPS;
    const SHARES: bool = E::SHARES;
    const LINEAR: bool = E::LINEAR;
    const ROTARY: bool = E::ROTARY;
    const OWN_AXES: bool = E::OWN_AXES;
    const SINES: usize = E::SINES;
    const FLANGED: bool = E::FLANGED;

    fn store<F: Field<S>>(&self, fill: F::Fill) -> E::Store<F> {
        self.item.store::<F>(fill)
    }
    #[cfg_attr(optimised, inline(always))]
    fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        let mut stores = stores;
        let stores = W::Stores::member::<Self, _>(&mut stores, Nth::<0>);
        walk.named(self.name, |walk| self.item.outward(walk, carried, stores))
    }
    #[inline(always)]
    fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, stores: Of<'_, S, W, Self>) -> W::Carried {
        let mut stores = stores;
        self.item.inward(walk, carried, W::Stores::member::<Self, _>(&mut stores, Nth::<0>))
    }
}

impl<S: Space, E: Shape<S>> Member<S, Named<E>> for Nth<0> {
    type Item = E;

    #[inline(always)]
    fn get<F: Field<S>>(store: &E::Store<F>) -> &E::Store<F> {
        store
    }
    #[inline(always)]
    fn get_mut<F: Field<S>>(store: &mut E::Store<F>) -> &mut E::Store<F> {
        store
    }
}

impl<S: Space, E: Element<S>> Element<S> for Named<E> {
    type Position = E::Position;
    type Rate = E::Rate;

    const ABSOLUTE: bool = E::ABSOLUTE;
    const TURNS_ANEW: bool = E::TURNS_ANEW;

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.item.lump(mass)
    }
    #[inline(always)]
    fn turned(&self, position: &E::Position, rate: &E::Rate, turn: S::Turn) -> S::Turn {
        self.item.turned(position, rate, turn)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &E::Position,
        rate: &E::Rate,
        turn: S::Turn,
        x: &mut E::Store<PerAxes<S::X>>,
        y: &mut E::Store<PerAxes<S::Y>>,
        p: &mut E::Store<PerAxes<S::P>>,
        q: &mut E::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        self.item.orient(position, rate, turn, x, y, p, q)
    }
    #[cfg_attr(optimised, inline(always))]
    fn resolve(
        sizes: &E::Store<PerAxes<S::Size>>,
        x: &mut E::Store<PerAxes<S::X>>,
        y: &mut E::Store<PerAxes<S::Y>>,
        p: &mut E::Store<PerAxes<S::P>>,
        q: &mut E::Store<PerAxes<S::Q>>,
    ) {
        E::resolve(sizes, x, y, p, q);
    }
    #[cfg_attr(optimised, inline(always))]
    fn pose(
        &self,
        position: &E::Position,
        rate: &E::Rate,
        turn: S::Turn,
        sizes: &E::Store<PerAxes<S::Size>>,
        x: &mut E::Store<PerAxes<S::X>>,
        y: &mut E::Store<PerAxes<S::Y>>,
        p: &mut E::Store<PerAxes<S::P>>,
        q: &mut E::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        self.item.pose(position, rate, turn, sizes, x, y, p, q)
    }
}

impl<S: Space, R, W: Sweep<S>, E: Condense<S, R, W>> Condense<S, R, W> for Named<E> {
    type Out = E::Out;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut E::Store<Kept<W::Closures>>,
    ) -> E::Out {
        let given = Given { on_bodies, in_joints, position, rate, reading, springs };
        self.item.condense(outer, Posture { x, y, p, q }, given, kept)
    }
}

impl<E: Counted> Counted for Named<E> {
    type Bodies = E::Bodies;
    type Freedoms = E::Freedoms;
}

impl<T: Scalar, U: Scalar, E: Lift<T, U>> Lift<T, U> for Named<E> {
    type Over = Named<E::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Named { item: self.item.lift(number), name: self.name }
    }
}

impl<S: Space, R: Root<S>> Root<S> for Named<R> {
    type Pairs = R::Pairs;
    type Joint = Named<R::Joint>;

    const RESTS: bool = R::RESTS;

    fn joint(&self) -> Named<R::Joint> {
        self.item.joint().named(self.name)
    }
    fn ground(&self, time: RealOf<S>) -> FrameOf<S> {
        self.item.ground(time)
    }
    fn check(&self) -> Result<(), Error> {
        self.item.check()
    }
}

impl<S: Space, R: Resting<S>> Resting<S> for Named<R> {}

impl<S: Space, K: Closing<S>> Closing<S> for Named<K> {
    type Closures = K::Closures;
    type PerAxes<X: Copy> = K::PerAxes<X>;

    fn per_axes<X: Copy>(fill: X) -> K::PerAxes<X> {
        K::per_axes(fill)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        side: S::Turn,
        main: S::Turn,
        x: &mut K::PerAxes<S::X>,
        y: &mut K::PerAxes<S::Y>,
        p: &mut K::PerAxes<S::P>,
        q: &mut K::PerAxes<S::Q>,
    ) {
        self.item.orient(side, main, x, y, p, q);
    }
    fn joint(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> S::JointMotion {
        self.item.joint(side, main)
    }
    fn internal(&self, forces: &<K::Closures as Closures>::Each<S::Scalar>, axes: Ends<'_, S, Self>) -> WrenchOf<S> {
        self.item.internal(forces, axes.of_item())
    }
    fn residual(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> [<K::Closures as Closures>::Each<S::Scalar>; 2] {
        self.item.residual(side, main)
    }
    fn free_compliance(&self, body: &S::BodyMotion) -> <K::Closures as Closures>::Each<S::Scalar> {
        self.item.free_compliance(body)
    }
    fn names(&self) -> <K::Closures as Closures>::Each<&'static str> {
        self.item.names()
    }
    fn check(&self) -> Result<(), Fault> {
        self.item.check()
    }
    fn label(&self) -> (&'static str, Option<&'static str>) {
        let (kind, own) = self.item.label();
        (kind, own.or(Some(self.name)))
    }
}

impl<S: Space, R, Q, K: CloseOff<S, R, Q>> CloseOff<S, R, Q> for Named<K> {
    type Main = K::Main;
    type Side = K::Side;

    #[inline(always)]
    fn close_off(&self, outer: R, torque: Q, axes: Ends<'_, S, Self>) -> (K::Main, K::Side, WrenchOf<S>) {
        self.item.close_off(outer, torque, axes.of_item())
    }
}

impl<'a, S: Space, K: Closing<S>> Ends<'a, S, Named<K>> {
    /// What the joint itself has kept.
    #[inline(always)]
    pub fn of_item(self) -> Ends<'a, S, K> {
        Ends { x: self.x, y: self.y, p: self.p, q: self.q }
    }
}

impl<S: Varied, E: Sensitive<S>> Sensitive<S> for Named<E> {
    type Plain = Named<E::Plain>;
    type Room = E::Room;

    fn room(&self) -> E::Room {
        self.item.room()
    }
    #[inline]
    fn read(
        position: &E::Position,
        rate: &E::Rate,
        plain_position: &mut <E::Plain as Element<S::Plain>>::Position,
        plain_rate: &mut <E::Plain as Element<S::Plain>>::Rate,
    ) {
        E::read(position, rate, plain_position, plain_rate);
    }
    fn load(
        &self,
        on_bodies: &E::Store<PerBody<WrenchOf<S>>>,
        in_joints: &E::Store<PerJoint<EffortOf<S>>>,
        store: &mut E::Room,
    ) {
        self.item.load(on_bodies, in_joints, store);
    }
    #[inline]
    fn factor<N: Seeds>(&self, at: At<'_, S, Self>, outer: RelationOf<S>, store: &mut E::Room) -> RelationOf<S> {
        self.item.factor::<N>(inside(at), outer, store)
    }
    #[inline]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Outward,
        store: &mut E::Room,
        acceleration: &mut E::Rate,
    ) {
        self.item.vary::<N>(inside(at), carried, store, acceleration);
    }
    #[inline]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Inward,
        store: &mut E::Room,
        acceleration: &mut E::Rate,
    ) {
        self.item.gather::<N>(inside(at), carried, store, acceleration);
    }
    #[inline]
    fn answer(&self, at: At<'_, S, Self>, carried: &mut S::Response, store: &E::Room, acceleration: &mut E::Rate) {
        self.item.answer(inside(at), carried, store, acceleration);
    }
}

/// Where what is named is.
#[inline(always)]
fn inside<'a, S: Varied, E: Sensitive<S>>(at: At<'a, S, Named<E>>) -> At<'a, S, E> {
    let Posture { x, y, p, q } = at.posture;
    At { plain: &at.plain.item, posture: Posture { x, y, p, q }, position: at.position, rate: at.rate }
}
