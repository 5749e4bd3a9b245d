//! Reading a motion: bodies, stations, energy and momentum. Every reading is a walk of its own and costs a sweep nothing.

use crate::counts::HasBody;
use crate::element::{Budget, Closed, Coordinates, Element, Gather, Load, Loading, RealOf, Space, Visit};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::shape::{self, PerJoint};
use crate::visit::survey;
use crate::walks::find;
use crate::walks::gather::gather;
use crate::walks::travel::travel;
use core::fmt;
use core::marker::PhantomData;
use num_traits::Zero;

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
        ground: S::Frame,
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

    /// That of body number `k`, counted from 0 at the root.
    pub fn get(&self, k: usize) -> Option<&X> {
        find::body(self.chain, &self.bodies, k)?.as_ref()
    }

    /// That of body number `K`; a scene without such a body does not compile.
    ///
    /// ```
    /// # use catena::planar::*;
    /// # let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    /// let start = pendulum.at_rest(&[0.0, 0.5])?;
    /// assert_eq!(pendulum.angles(&start).body::<1>(), Some(&0.5));
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn body<const K: usize>(&self) -> Option<&X>
    where
        E: HasBody<K>,
    {
        self.get(K)
    }

    /// Those of all bodies, root to tip.
    pub fn iter(&self) -> impl Iterator<Item = &X> {
        (0..self.len()).filter_map(|k| self.get(k))
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
        ground: S::Frame,
        gravity: S::Vector,
        motion: Coordinates<'_, S, E>,
        time: RealOf<S>,
        loads: &L,
        tip: S::Internal,
    ) -> Self {
        let (mut bodies, mut joints) = (chain.store::<shape::PerBody<_>>(None), chain.store::<PerJoint<_>>(None));
        let seen = survey(chain, ground, motion, loads);
        let mut visit = Balance::<S, L> { gravity, loads, seen, time, body: 0 };
        let end = travel(chain, ground, motion, &mut visit, &mut bodies, &mut joints);
        let internal = gather(chain, &mut bodies, &mut joints, tip, &mut Internals::<S>(PhantomData));
        let (root, tip) = (S::end_station(&ground, internal), S::end_station(&end, tip));
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

    /// All stations, root to tip.
    pub fn iter(&self) -> impl Iterator<Item = &S::Station> {
        (0..=self.elements()).filter_map(|k| self.get(k))
    }
}

/// Internal forces from the tips inward, and the balance of each station closed.
struct Internals<S>(PhantomData<S>);

impl<S: Space> Gather for Internals<S> {
    type Entry = Option<S::Station>;
    type Carried = S::Internal;

    fn meet(&mut self, station: &mut Option<S::Station>, outer: S::Internal) -> S::Internal {
        station.as_mut().map_or(outer, |station| S::balance(station, outer))
    }
    fn beyond_arm(&mut self) -> S::Internal {
        S::no_force()
    }
    fn opposite(&mut self, closing: S::Internal) -> S::Internal {
        S::opposite(closing)
    }
    fn join(&mut self, chain: S::Internal, arm: S::Internal) -> S::Internal {
        S::together(chain, arm)
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
#[cfg(feature = "alloc")]
pub(crate) fn each_body<S: Space, E: Element<S>>(
    chain: &E,
    ground: S::Frame,
    motion: Coordinates<'_, S, E>,
    read: impl FnMut(&S::BodyMotion),
) {
    travel(
        chain,
        ground,
        motion,
        &mut Show(read),
        &mut chain.store::<shape::PerBody<()>>(()),
        &mut chain.store::<PerJoint<()>>(()),
    );
}

/// Shows each body.
#[cfg(feature = "alloc")]
struct Show<F>(F);

#[cfg(feature = "alloc")]
impl<S: Space, F: FnMut(&S::BodyMotion)> Visit<S> for Show<F> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, body: &S::BodyMotion) {
        (self.0)(body);
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}

/// By how much the ends of a loop miss each other: the largest (m, rad), and the station of the joint that should close it.
pub(crate) fn loops_miss<S: Space, E: Element<S>>(
    chain: &E,
    ground: S::Frame,
    motion: Coordinates<'_, S, E>,
) -> (RealOf<S>, usize) {
    let mut open = OpenLoop::<S> { entries: 0, worst: (Zero::zero(), 0) };
    travel(
        chain,
        ground,
        motion,
        &mut open,
        &mut chain.store::<shape::PerBody<()>>(()),
        &mut chain.store::<PerJoint<()>>(()),
    );
    open.worst
}

/// Calls `note` with what each condition that closes a loop is missed by: in place (m, rad) and in velocity.
#[cfg(feature = "alloc")] // for statics
pub(crate) fn each_miss<S: Space, E: Element<S>>(
    chain: &E,
    ground: S::Frame,
    motion: Coordinates<'_, S, E>,
    note: impl FnMut([S::Scalar; 2]),
) {
    travel(
        chain,
        ground,
        motion,
        &mut Misses(note),
        &mut chain.store::<shape::PerBody<()>>(()),
        &mut chain.store::<PerJoint<()>>(()),
    );
}

/// Shows by how much loops miss.
#[cfg(feature = "alloc")]
struct Misses<F>(F);

#[cfg(feature = "alloc")]
impl<S: Space, F: FnMut([S::Scalar; 2])> Visit<S> for Misses<F> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, _: &S::BodyMotion) {}
    fn joint(&mut self, _: &S::JointMotion) {}
    fn closing(&mut self, closed: &Closed<S>) {
        let [place, velocity] = &closed.miss;
        let mut count = 0;
        place.all(velocity, &mut |place, velocity| {
            if count < closed.conditions {
                (self.0)([place, velocity]);
            }
            count += 1;
            true
        });
    }
}

/// Keeps the loop that misses most.
struct OpenLoop<S: Space> {
    /// Bodies and joints met; the first is the root's joint.
    entries: usize,
    worst: (RealOf<S>, usize),
}

impl<S: Space> Visit<S> for OpenLoop<S> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, _: &S::BodyMotion) {
        self.entries += 1;
    }
    fn joint(&mut self, _: &S::JointMotion) {
        self.entries += 1;
    }
    fn closing(&mut self, closed: &Closed<S>) {
        self.entries += 1;
        closed.miss[0].visit(&mut |x| {
            if x.real().abs() > self.worst.0 {
                self.worst = (x.real().abs(), self.entries - 2);
            }
        });
    }
}

/// Energy and momentum of a motion.
pub(crate) fn budget<S: Space, E: Element<S>>(
    chain: &E,
    ground: S::Frame,
    gravity: S::Vector,
    motion: Coordinates<'_, S, E>,
) -> Budget<S> {
    let mut audit = Audit { gravity, sum: S::no_budget() };
    travel(
        chain,
        ground,
        motion,
        &mut audit,
        &mut chain.store::<shape::PerBody<()>>(()),
        &mut chain.store::<PerJoint<()>>(()),
    );
    audit.sum
}

/// Adds up energy and momentum.
struct Audit<S: Space> {
    gravity: S::Vector,
    sum: Budget<S>,
}

impl<S: Space> Visit<S> for Audit<S> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, body: &S::BodyMotion) {
        self.sum = S::sum(self.sum, S::budget(body, self.gravity));
    }
    fn joint(&mut self, joint: &S::JointMotion) {
        let potential = self.sum.potential + S::stored(joint);
        self.sum = Budget { potential, ..self.sum };
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
        let mut station = S::body_station(body, self.gravity);
        self.loads.on_body(&self.seen, self.time, self.body, body).act(&mut station);
        self.body += 1;
        Some(station)
    }
    fn joint(&mut self, joint: &S::JointMotion) -> Option<S::Station> {
        Some(S::joint_station(joint))
    }
    fn closing(&mut self, closed: &Closed<S>) -> Option<S::Station> {
        Some(S::closing_station(&closed.joint, closed.internal))
    }
}
