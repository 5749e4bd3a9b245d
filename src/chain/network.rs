//! Arms in parallel, between two stations.

use super::closing::{Closing, Ends};
use super::{deeper, entries, sum};
use crate::element::{Closed, Coordinates, Element, Entry, Gather, Level, Posture, Space, Springs, Visit, look};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::mirror::{Rate, Tied, TiedPosition};
use crate::relation::{Closures, LoopGain, Looped, Own, Solvable};
use crate::scalar::Scalar;
use crate::visit::take_first;
use core::ops::Add;
use typenum::{Sum, Unsigned};

/// Two arms in parallel: both begin at this station, and end at the same one, where the chain goes on from the main arm. The side arm
/// is joined to the end of the main arm by a joint of its own, which closes the loop: a `Pin` or `Weld` in the plane, a `Ball`,
/// `Revolute` or `Weld` in space.
///
/// ```
/// use catena::element::Unloaded;
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
/// *within the loop*; if not, [`Fault::RedundantClosures`] names one, unless the closing joint is a [`LeastNorm`](super::LeastNorm). Forces and station of the closing joint
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
/// Gains of the loop, whose columns are those of the space.
type Gains<S, C, K> = LoopGain<<S as Space>::Column, <S as Space>::Scalar, C, OwnOf<S, K>>;

impl<S: Space, M: Element<S>, A: Element<S>, K: Closing<S>> Element<S> for Network<M, A, K> {
    type Position = TiedPosition<(M::Position, A::Position), S::Numbers>;
    type Rate = Tied<(M::Rate, A::Rate), S::Numbers>;
    type Kept<C: Closures> = (M::Kept<Inside<S, C, K>>, A::Kept<OwnOf<S, K>>, Gains<S, C, K>, S::Internal);
    type PerBody<X: Copy> = (M::PerBody<X>, A::PerBody<X>);
    type PerJoint<X: Copy> = (M::PerJoint<X>, A::PerJoint<X>, X);
    type PerAxes<X: Copy> = (M::PerAxes<X>, A::PerAxes<X>, K::PerAxes<X>);

    const BODIES: Option<usize> = sum(M::BODIES, A::BODIES);
    const JOINTS: Option<usize> = sum(sum(M::JOINTS, A::JOINTS), Some(1));
    const ABSOLUTE: bool = M::ABSOLUTE && A::ABSOLUTE;
    const LOOPS: usize = 1 + deeper(M::LOOPS, A::LOOPS);
    const LINEAR: bool = M::LINEAR && A::LINEAR;

    fn bodies(&self) -> usize {
        self.arms.bodies()
    }
    fn joints(&self) -> usize {
        self.arms.joints() + 1
    }
    fn check(&self, station: usize) -> Result<(), Error> {
        self.arms.check(station)?;
        let closing = station + self.arms.bodies() + self.arms.joints();
        self.closing.check().map_err(|fault| Error::new(fault).at_station(closing))
    }
    fn fits(&self, position: &Self::Position, rate: &Self::Rate) -> bool {
        self.arms.fits(&position.arms, &rate.arms)
    }
    fn position(&self) -> Self::Position {
        TiedPosition::of(self.arms.position())
    }
    fn rate(&self) -> Self::Rate {
        Tied { arms: self.arms.rate(), closing: S::numbers(S::no_force()) }
    }
    fn kept<C: Closures>(&self) -> Self::Kept<C> {
        // A measure need not know where bodies are: as they are turned, each yields by a factor of a few at most.
        let measure = OwnOf::<S, K>::measure(|| {
            let ((p, q), (v, w)) = (self.arms.position(), self.arms.rate());
            let in_main = Coordinates { position: &p, rate: &v, acceleration: &v };
            self.yields(S::resting(), in_main, Coordinates { position: &q, rate: &w, acceleration: &w })
        });
        (self.main().kept(), self.side().kept(), LoopGain::blank(S::no_column(), measure), S::no_force())
    }
    fn per_body<X: Copy>(&self, fill: X) -> Self::PerBody<X> {
        self.arms.per_body(fill)
    }
    fn per_joint<X: Copy>(&self, fill: X) -> Self::PerJoint<X> {
        (self.main().per_joint(fill), self.side().per_joint(fill), fill)
    }
    fn per_axes<X: Copy>(&self, fill: X) -> Self::PerAxes<X> {
        (self.main().per_axes(fill), self.side().per_axes(fill), K::per_axes(fill))
    }
    fn body_entry<'a, X: Copy>(&self, bodies: &'a Self::PerBody<X>, k: usize) -> Option<&'a X> {
        self.arms.body_entry(bodies, k)
    }
    fn entry<'a, X: Copy>(
        &self,
        bodies: &'a Self::PerBody<X>,
        joints: &'a Self::PerJoint<X>,
        k: usize,
    ) -> Option<&'a X> {
        let in_main = entries(self.main());
        let Some(k) = k.checked_sub(in_main) else {
            return self.main().entry(&bodies.0, &joints.0, k);
        };
        let in_side = entries(self.side());
        let Some(k) = k.checked_sub(in_side) else {
            return self.side().entry(&bodies.1, &joints.1, k);
        };
        (k == 0).then_some(&joints.2)
    }
    fn each_entry<'a, 'b, X: Copy + 'a, Y: Copy + 'b>(
        bodies: &'a Self::PerBody<X>,
        joints: &'b Self::PerJoint<Y>,
        note: &mut impl FnMut(Entry<&'a X, &'b Y>),
    ) {
        M::each_entry(&bodies.0, &joints.0, note);
        A::each_entry(&bodies.1, &joints.1, note);
        note(Entry::Joint(&joints.2));
    }
    fn aim(
        &self,
        position: &mut Self::Position,
        turn: S::Turn,
        next: &mut impl FnMut(S::Turn) -> S::Scalar,
    ) -> S::Turn {
        let outboard = self.main().aim(&mut position.arms.0, turn, next);
        self.side().aim(&mut position.arms.1, turn, next);
        outboard
    }
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.arms.0.lump(mass) + self.arms.1.lump(num_traits::Zero::zero())
    }
    #[inline(always)]
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        self.main().turned(&position.arms.0, &rate.arms.0, turn)
    }
    #[inline(always)]
    fn orient(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    ) -> S::Turn {
        let (position, rate) = (&position.arms, &rate.arms);
        let side = self.side().orient(&position.1, &rate.1, turn, &mut x.1, &mut y.1, &mut p.1, &mut q.1);
        let main = self.main().orient(&position.0, &rate.0, turn, &mut x.0, &mut y.0, &mut p.0, &mut q.0);
        self.closing.orient(side, main, &mut x.2, &mut y.2, &mut p.2, &mut q.2);
        main
    }
    fn size(&self, sizes: &mut Self::PerAxes<S::Size>) {
        self.main().size(&mut sizes.0);
        self.side().size(&mut sizes.1);
    }
    #[inline(always)]
    fn resolve(
        sizes: &Self::PerAxes<S::Size>,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    ) {
        M::resolve(&sizes.0, &mut x.0, &mut y.0, &mut p.0, &mut q.0);
        A::resolve(&sizes.1, &mut x.1, &mut y.1, &mut p.1, &mut q.1);
    }
    #[inline(always)]
    fn pose(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        sizes: &Self::PerAxes<S::Size>,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    ) -> S::Turn {
        let (position, rate) = (&position.arms, &rate.arms);
        let side = self.side().pose(&position.1, &rate.1, turn, &sizes.1, &mut x.1, &mut y.1, &mut p.1, &mut q.1);
        let main = self.main().pose(&position.0, &rate.0, turn, &sizes.0, &mut x.0, &mut y.0, &mut p.0, &mut q.0);
        self.closing.orient(side, main, &mut x.2, &mut y.2, &mut p.2, &mut q.2);
        main
    }
    #[inline(always)]
    fn recover<C: Closures, By: Springs<S::Scalar>>(
        &self,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        (main, side, gain, driven): &mut Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> S::Acceleration {
        let forces = OwnOf::<S, K>::forces(gain, |w| S::work(w, &acceleration), multipliers, gain.gap());
        let ends = Ends { x: &x.2, y: &y.2, p: &p.2, q: &q.2 };
        rate.closing = S::numbers(S::together(*driven, self.closing.internal(&forces, ends)));
        let posture = Posture { x: &x.1, y: &y.1, p: &p.1, q: &q.1 };
        self.side().recover::<OwnOf<S, K>, By>(acceleration, posture, side, &forces, &mut rate.arms.1);
        let (posture, all) = (Posture { x: &x.0, y: &y.0, p: &p.0, q: &q.0 }, (*multipliers, forces));
        self.main().recover::<Inside<S, C, K>, By>(acceleration, posture, main, &all, &mut rate.arms.0)
    }
    #[inline(always)]
    fn respond<C: Closures>(
        &self,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        (main, side, gain, _): &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> S::Acceleration {
        let still = OwnOf::<S, K>::each(|_| num_traits::Zero::zero());
        let forces = OwnOf::<S, K>::forces(gain, |w| S::work(w, &acceleration), multipliers, &still);
        let posture = Posture { x: &x.1, y: &y.1, p: &p.1, q: &q.1 };
        self.side().respond::<OwnOf<S, K>>(acceleration, posture, side, &forces, &mut rate.arms.1);
        let (posture, all) = (Posture { x: &x.0, y: &y.0, p: &p.0, q: &q.0 }, (*multipliers, forces));
        self.main().respond::<Inside<S, C, K>>(acceleration, posture, main, &all, &mut rate.arms.0)
    }
    fn restore<C: Closures>(
        &self,
        frame: S::Frame,
        motion: Coordinates<'_, S, Self>,
        level: Level,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        (main, side, gain, _): &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> (S::Frame, S::Acceleration) {
        let (in_main, in_side) = arms(motion);
        let (main_end, side_end) = (look(self.main(), frame, in_main), look(self.side(), frame, in_side));
        let [place, velocity] = self.closing.miss(&side_end, &main_end);
        let miss = match level {
            Level::Place => place,
            Level::Velocity => velocity,
        };
        let gap = OwnOf::<S, K>::reduced(gain, &miss);
        let forces = OwnOf::<S, K>::forces(gain, |w| S::work(w, &acceleration), multipliers, &gap);
        let posture = Posture { x: &x.1, y: &y.1, p: &p.1, q: &q.1 };
        let step = &mut rate.arms.1;
        self.side().restore::<OwnOf<S, K>>(frame, in_side, level, acceleration, posture, side, &forces, step);
        let (posture, all) = (Posture { x: &x.0, y: &y.0, p: &p.0, q: &q.0 }, (*multipliers, forces));
        let step = &mut rate.arms.0;
        self.main().restore::<Inside<S, C, K>>(frame, in_main, level, acceleration, posture, main, &all, step)
    }
    fn independent<C: Closures>(
        &self,
        frame: S::Frame,
        motion: Coordinates<'_, S, Self>,
        (main, side, gain, _): &Self::Kept<C>,
        station: usize,
        tell: &mut impl FnMut(usize, &'static str),
    ) -> Result<S::Frame, Error> {
        let (in_main, in_side) = arms(motion);
        let end = self.main().independent::<Inside<S, C, K>>(frame, in_main, main, station, tell)?;
        let station = station + self.main().bodies() + self.main().joints();
        self.side().independent::<OwnOf<S, K>>(frame, in_side, side, station, tell)?;
        let station = station + self.side().bodies() + self.side().joints();
        OwnOf::<S, K>::zip(&OwnOf::<S, K>::undetermined(gain), &self.closing.names(), |open, name| {
            if open {
                tell(station, name);
            }
        });
        let measure = self.yields(frame, in_main, in_side);
        let Some((row, independent)) = OwnOf::<S, K>::dependent(gain.compliance(), &measure) else {
            return Ok(end);
        };
        let (mut closure, mut number) = ("", 0);
        OwnOf::<S, K>::map(&self.closing.names(), |name| {
            if number == row {
                closure = name;
            }
            number += 1;
        });
        let of = OwnOf::<S, K>::COUNT;
        Err(Error::new(Fault::RedundantClosures { closure, independent, of }).at_station(station))
    }
    #[inline(always)]
    fn spread_bodies<'v, X: Copy>(&self, values: &'v [X], bodies: &mut Self::PerBody<X>) -> &'v [X] {
        let values = self.main().spread_bodies(values, &mut bodies.0);
        self.side().spread_bodies(values, &mut bodies.1)
    }
    #[inline(always)]
    fn spread_joints<'v, X: Copy>(&self, values: &'v [X], joints: &mut Self::PerJoint<X>) -> &'v [X] {
        let values = self.main().spread_joints(values, &mut joints.0);
        let values = self.side().spread_joints(values, &mut joints.1);
        take_first(values, &mut joints.2)
    }
    #[inline(always)]
    fn travel<V: Visit<S>>(
        &self,
        frame: S::Frame,
        motion: Coordinates<'_, S, Self>,
        visit: &mut V,
        on_bodies: &mut Self::PerBody<V::OnBody>,
        in_joints: &mut Self::PerJoint<V::InJoint>,
    ) -> S::Frame {
        let (in_main, in_side) = arms(motion);
        let main = self.main().travel(frame, in_main, visit, &mut on_bodies.0, &mut in_joints.0);
        visit.enter_arm();
        let side = self.side().travel(frame, in_side, visit, &mut on_bodies.1, &mut in_joints.1);
        in_joints.2 = visit.closing(&Closed {
            joint: self.closing.joint(&side, &main),
            internal: S::internal(motion.acceleration.closing),
            conditions: OwnOf::<S, K>::COUNT,
            miss: self.closing.miss(&side, &main).map(|miss| {
                let (mut numbers, mut k) = (S::numbers(S::no_force()), 0);
                OwnOf::<S, K>::map(&miss, |x| {
                    let mut at = 0;
                    numbers.replace(&mut |old| {
                        at += 1;
                        if at == k + 1 { x } else { old }
                    });
                    k += 1;
                });
                numbers
            }),
        });
        visit.leave_arm();
        main
    }
    fn inward<G: Gather>(
        &self,
        bodies: &mut Self::PerBody<G::Entry>,
        joints: &mut Self::PerJoint<G::Entry>,
        outer: G::Carried,
        gather: &mut G,
    ) -> G::Carried {
        let beyond = gather.beyond_arm();
        let closing = gather.meet(&mut joints.2, beyond);
        let side = self.side().inward(&mut bodies.1, &mut joints.1, closing, gather);
        let opposite = gather.opposite(closing);
        let outer = gather.join(outer, opposite);
        let main = self.main().inward(&mut bodies.0, &mut joints.0, outer, gather);
        gather.join(main, side)
    }
    fn broken<C: Closures>(&self, (main, side, gain, _): &Self::Kept<C>, station: usize) -> Option<usize> {
        let after_main = station + self.main().bodies() + self.main().joints();
        let closing = after_main + self.side().bodies() + self.side().joints();
        let in_arms = self.side().broken(side, after_main).or_else(|| self.main().broken(main, station));
        in_arms.or_else(|| (!gain.is_finite()).then_some(closing))
    }
}

/// The coordinates of both arms.
fn arms<S: Space, M: Element<S>, A: Element<S>, K: Closing<S>>(
    motion: Coordinates<'_, S, Network<M, A, K>>,
) -> (Coordinates<'_, S, M>, Coordinates<'_, S, A>) {
    let Coordinates { position, rate, acceleration } = motion;
    let ((p, q), (r, s), (a, b)) = (&position.arms, &rate.arms, &acceleration.arms);
    (Coordinates { position: p, rate: r, acceleration: a }, Coordinates { position: q, rate: s, acceleration: b })
}

impl<M, A, K> crate::counts::Counted for Network<M, A, K>
where
    M: crate::counts::Counted<Bodies: Add<A::Bodies, Output: Unsigned>, Freedoms: Add<A::Freedoms, Output: Unsigned>>,
    A: crate::counts::Counted,
{
    type Bodies = Sum<M::Bodies, A::Bodies>;
    type Freedoms = Sum<M::Freedoms, A::Freedoms>;
}

impl<T: Scalar, U: Scalar, M: Lift<T, U>, A: Lift<T, U>, K: Lift<T, U>> Lift<T, U> for Network<M, A, K> {
    type Over = Network<M::Over, A::Over, K::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Network { arms: self.arms.lift(number), closing: self.closing.lift(number) }
    }
}
