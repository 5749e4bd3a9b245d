//! Reading a motion: bodies, stations, energy and momentum. Every reading is a walk of its own and costs a sweep nothing.

mod budget;
mod by_joint;
mod doubts;
mod in_turn;
mod residuals;

pub use crate::state::{StateVector, TransferMatrix};
pub(crate) use budget::budget;
pub(crate) use doubts::doubts;
#[cfg(feature = "alloc")]
pub(crate) use residuals::each_residual;
pub(crate) use residuals::loop_residual;

use crate::counts::HasBody;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
use crate::element::Watch;
use crate::element::{Closed, Coordinates, Element, Gather, Load, Loading, RealOf, Space, Visit};
use crate::relation::{Wrench, WrenchOf};
use crate::shape::{self, PerJoint};
use crate::space::{Balance as _, FrameOf};
use crate::visit::survey;
use crate::walks::entries::{Entry, entries};
use crate::walks::find;
use crate::walks::gather::gather;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
use crate::walks::travel::show;
use crate::walks::travel::travel;
use core::fmt;
use core::marker::PhantomData;
use in_turn::in_turn;

/// Something of every body of a scene, by number.
#[derive(Clone)]
pub struct PerBody<'a, S: Space, E: Element<S>, X: Copy + 'static> {
    chain: &'a E,
    bodies: E::Store<shape::PerBody<Option<X>>>,
}

impl<'a, S: Space, E: Element<S>, X: Copy + 'static> PerBody<'a, S, E, X> {
    /// Walks a motion outward and keeps what `read` says of each body.
    pub(crate) fn of(
        chain: &'a E,
        ground: FrameOf<S>,
        motion: Coordinates<'_, S, E>,
        read: impl FnMut(&S::BodyMotion) -> X,
    ) -> Self {
        let mut bodies = chain.store::<shape::PerBody<_>>(None);
        travel(chain, ground, motion, &mut Collect(read), &mut bodies, &mut chain.store::<PerJoint<()>>(()));
        Self { chain, bodies }
    }

    /// Number of bodies.
    pub fn len(&self) -> usize {
        self.chain.bodies()
    }

    /// Whether there are none (a scene has at least one).
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The reading of body number `k`, counted from 0 at the root.
    pub fn get(&self, k: usize) -> Option<&X> {
        find::body(self.chain, &self.bodies, k)?.as_ref()
    }

    /// The reading of body number `K`; a scene without such a body does not compile.
    ///
    /// ```
    /// # use catena::planar::*;
    /// # let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    /// let start = pendulum.at_rest(&[0.0, 0.5])?;
    /// assert_eq!(pendulum.angles(&start)?.body::<1>(), Some(&0.5));
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn body<const K: usize>(&self) -> Option<&X>
    where
        E: HasBody<K>,
    {
        self.get(K)
    }

    /// The readings of all bodies, root to tip, each met once.
    pub fn iter(&self) -> impl Iterator<Item = &X> {
        in_turn(
            E::BODIES.is_some(),
            self.len(),
            |k| self.get(k),
            |list| {
                entries(self.chain, &self.bodies, &self.chain.store::<PerJoint<()>>(()), &mut |entry| {
                    if let Entry::Body(body) = entry {
                        list(body.as_ref());
                    }
                });
            },
        )
    }
}

impl<S: Space, E: Element<S>, X: Copy + fmt::Debug + 'static> fmt::Debug for PerBody<'_, S, E, X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// Motion, internal force and torque at every station: the root, the inboard end of every element, the tip.
///
/// Where an arm leaves the chain, several elements begin at one place. Each has its own force there, and the body that carries them is
/// loaded by their sum.
#[derive(Clone)]
pub struct Stations<'a, S: Space, E: Element<S>> {
    chain: &'a E,
    bodies: E::Store<shape::PerBody<Option<S::Station>>>,
    joints: E::Store<PerJoint<Option<S::Station>>>,
    root: S::Station,
    tip: S::Station,
}

impl<'a, S: Space, E: Element<S>> Stations<'a, S, E> {
    pub(crate) fn of<L: Loading<S>>(
        chain: &'a E,
        ground: FrameOf<S>,
        gravity: S::Vector,
        motion: Coordinates<'_, S, E>,
        time: RealOf<S>,
        loads: &L,
        tip: WrenchOf<S>,
    ) -> Self {
        let (mut bodies, mut joints) = (chain.store::<shape::PerBody<_>>(None), chain.store::<PerJoint<_>>(None));
        let seen = survey(chain, ground, motion, loads);
        let mut visit = Balance::<S, L> { gravity, loads, seen, time, body: 0 };
        let end = travel(chain, ground, motion, &mut visit, &mut bodies, &mut joints);
        let internal = gather(chain, &mut bodies, &mut joints, tip, &mut Internals::<S>(PhantomData));
        let (root, tip) = (S::Station::at_end(ground, internal), S::Station::at_end(end, tip));
        Self { chain, bodies, joints, root, tip }
    }

    /// Number of elements of the chain: stations are numbered from 0 (the inboard end of the first element) to this (the
    /// tip).
    pub fn elements(&self) -> usize {
        self.chain.bodies() + self.chain.joints() - 1
    }

    /// Station `k`: the inboard end of the chain's k-th element, or the tip.
    pub fn get(&self, k: usize) -> Option<&S::Station> {
        if k == self.elements() {
            return Some(&self.tip);
        }
        // Entry 0 is the root's joint.
        find::entry(self.chain, &self.bodies, &self.joints, k + 1)?.as_ref()
    }

    /// The ground's side of the root's joint: its force is that of the ground on the chain.
    pub fn root(&self) -> &S::Station {
        &self.root
    }

    /// The outboard end of the last element.
    pub fn tip(&self) -> &S::Station {
        &self.tip
    }

    /// All stations, root to tip, each met once.
    pub fn iter(&self) -> impl Iterator<Item = &S::Station> {
        // Entry 0 is the root's joint, and the tip comes last.
        let get = |k| find::entry(self.chain, &self.bodies, &self.joints, k).and_then(Option::as_ref);
        let stations = in_turn(E::BODIES.is_some() && E::JOINTS.is_some(), self.elements() + 1, get, |list| {
            entries(self.chain, &self.bodies, &self.joints, &mut |entry| match entry {
                Entry::Body(station) | Entry::Joint(station) => list(station.as_ref()),
            });
        });
        stations.skip(1).chain(core::iter::once(&self.tip))
    }
}

/// Internal forces from the tips inward, and the balance of each station closed.
struct Internals<S>(PhantomData<S>);

impl<S: Space> Gather for Internals<S> {
    type Entry = Option<S::Station>;
    type Carried = WrenchOf<S>;

    fn meet(&mut self, station: &mut Option<S::Station>, outer: WrenchOf<S>) -> WrenchOf<S> {
        station.as_mut().map_or(outer, |station| station.close(outer))
    }
    fn beyond_arm(&mut self) -> WrenchOf<S> {
        Wrench::none()
    }
    fn opposite(&mut self, closing: WrenchOf<S>) -> WrenchOf<S> {
        -closing
    }
    fn join(&mut self, chain: WrenchOf<S>, arm: WrenchOf<S>) -> WrenchOf<S> {
        chain + arm
    }
}

/// Keeps something of each body.
struct Collect<F>(F);

impl<S: Space, X: Copy + 'static, F: FnMut(&S::BodyMotion) -> X> Visit<S> for Collect<F> {
    type OnBody = Option<X>;
    type InJoint = ();

    fn body(&mut self, body: &S::BodyMotion) -> Option<X> {
        Some((self.0)(body))
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}

/// Walks outward and shows each body; keeps nothing.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) fn each_body<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    read: impl FnMut(&S::BodyMotion),
) {
    show(chain, ground, motion, &mut Show(read));
}

/// Walks outward and shows each joint; keeps nothing.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) fn each_joint<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    read: impl FnMut(&S::JointMotion),
) {
    show(chain, ground, motion, &mut ShowJoints(read));
}

/// Shows each joint.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
struct ShowJoints<F>(F);

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
impl<S: Space, F: FnMut(&S::JointMotion)> Watch<S> for ShowJoints<F> {
    fn joint(&mut self, joint: &S::JointMotion) {
        (self.0)(joint);
    }
}

/// Shows each body.
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
struct Show<F>(F);

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
impl<S: Space, F: FnMut(&S::BodyMotion)> Watch<S> for Show<F> {
    fn body(&mut self, body: &S::BodyMotion) {
        (self.0)(body);
    }
}

/// Sets up the balance of forces at each station.
struct Balance<'a, S: Space, L: Loading<S>> {
    gravity: S::Vector,
    loads: &'a L,
    seen: L::Seen,
    time: RealOf<S>,
    body: usize,
}

impl<S: Space, L: Loading<S>> Visit<S> for Balance<'_, S, L> {
    type OnBody = Option<S::Station>;
    type InJoint = Option<S::Station>;

    fn body(&mut self, body: &S::BodyMotion) -> Option<S::Station> {
        let mut station = S::Station::of_body(body, self.gravity);
        station.relieve(self.loads.on_body(&self.seen, self.time, self.body, body).wrench());
        self.body += 1;
        Some(station)
    }
    fn joint(&mut self, joint: &S::JointMotion) -> Option<S::Station> {
        Some(S::Station::of_joint(joint))
    }
    fn closing(&mut self, closed: &Closed<S>) -> Option<S::Station> {
        Some(S::Station::of_closing(&closed.joint, closed.internal))
    }
}
