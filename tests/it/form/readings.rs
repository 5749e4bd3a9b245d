//! Readings of all bodies and stations of a scene meet each element a bounded number of times, however many there are.

use catena::element::{
    Condense, Coordinates, Element, Entry, Gather, Given, Level, Posture, Space, Springs, Sweep, Unloaded, Visit,
};
use catena::planar::*;
use catena::relation::Closures;
use catena::{Error, mirror};
use std::cell::Cell;

thread_local! {
    /// How often elements were asked what they hold.
    static VISITS: Cell<usize> = const { Cell::new(0) };
}

fn visits(read: impl FnOnce()) -> usize {
    VISITS.set(0);
    read();
    VISITS.get()
}

/// An element that counts how often it is asked for its numbers or its entries, and is that element otherwise.
#[derive(Clone)]
struct Counting<E>(E);

impl<S: Space, E: Element<S>> Element<S> for Counting<E> {
    type Position = E::Position;
    type Rate = E::Rate;
    type Kept<C: Closures> = E::Kept<C>;
    type PerBody<X: Copy> = E::PerBody<X>;
    type PerJoint<X: Copy> = E::PerJoint<X>;
    type PerAxes<X: Copy> = E::PerAxes<X>;
    const BODIES: Option<usize> = E::BODIES;
    const JOINTS: Option<usize> = E::JOINTS;
    const ABSOLUTE: bool = E::ABSOLUTE;

    fn bodies(&self) -> usize {
        VISITS.set(VISITS.get() + 1);
        self.0.bodies()
    }
    fn joints(&self) -> usize {
        VISITS.set(VISITS.get() + 1);
        self.0.joints()
    }
    fn body_entry<'a, X: Copy>(&self, bodies: &'a Self::PerBody<X>, k: usize) -> Option<&'a X> {
        VISITS.set(VISITS.get() + 1);
        self.0.body_entry(bodies, k)
    }
    fn entry<'a, X: Copy>(
        &self,
        bodies: &'a Self::PerBody<X>,
        joints: &'a Self::PerJoint<X>,
        k: usize,
    ) -> Option<&'a X> {
        VISITS.set(VISITS.get() + 1);
        self.0.entry(bodies, joints, k)
    }
    fn each_entry<'a, 'b, X: Copy + 'a, Y: Copy + 'b>(
        bodies: &'a Self::PerBody<X>,
        joints: &'b Self::PerJoint<Y>,
        note: &mut impl FnMut(Entry<&'a X, &'b Y>),
    ) {
        VISITS.set(VISITS.get() + 1);
        E::each_entry(bodies, joints, note);
    }

    fn spread_bodies<'v, X: Copy>(&self, values: &'v [X], bodies: &mut Self::PerBody<X>) -> &'v [X] {
        self.0.spread_bodies(values, bodies)
    }
    fn spread_joints<'v, X: Copy>(&self, values: &'v [X], joints: &mut Self::PerJoint<X>) -> &'v [X] {
        self.0.spread_joints(values, joints)
    }
    fn check(&self, station: usize) -> Result<(), Error> {
        self.0.check(station)
    }
    fn position(&self) -> Self::Position {
        self.0.position()
    }
    fn rate(&self) -> Self::Rate {
        self.0.rate()
    }
    fn kept<C: Closures>(&self) -> Self::Kept<C> {
        self.0.kept()
    }
    fn per_body<X: Copy>(&self, fill: X) -> Self::PerBody<X> {
        self.0.per_body(fill)
    }
    fn per_joint<X: Copy>(&self, fill: X) -> Self::PerJoint<X> {
        self.0.per_joint(fill)
    }
    fn per_axes<X: Copy>(&self, fill: X) -> Self::PerAxes<X> {
        self.0.per_axes(fill)
    }
    fn aim(
        &self,
        position: &mut Self::Position,
        turn: S::Turn,
        next: &mut impl FnMut(S::Turn) -> S::Scalar,
    ) -> S::Turn {
        self.0.aim(position, turn, next)
    }
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.0.lump(mass)
    }
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        self.0.turned(position, rate, turn)
    }
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
        self.0.orient(position, rate, turn, x, y, p, q)
    }
    fn size(&self, sizes: &mut Self::PerAxes<S::Size>) {
        self.0.size(sizes);
    }
    fn resolve(
        sizes: &Self::PerAxes<S::Size>,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    ) {
        E::resolve(sizes, x, y, p, q);
    }
    fn recover<C: Closures, By: Springs<S::Scalar>>(
        &self,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        kept: &mut Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> S::Acceleration {
        self.0.recover::<C, By>(acceleration, Posture { x, y, p, q }, kept, multipliers, rate)
    }
    fn respond<C: Closures>(
        &self,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        kept: &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> S::Acceleration {
        self.0.respond::<C>(acceleration, Posture { x, y, p, q }, kept, multipliers, rate)
    }
    fn restore<C: Closures>(
        &self,
        frame: S::Frame,
        Coordinates { position, rate: own, acceleration: at }: Coordinates<'_, S, Self>,
        level: Level,
        acceleration: S::Acceleration,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        kept: &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> (S::Frame, S::Acceleration) {
        let motion = Coordinates { position, rate: own, acceleration: at };
        self.0.restore::<C>(frame, motion, level, acceleration, Posture { x, y, p, q }, kept, multipliers, rate)
    }
    fn travel<V: Visit<S>>(
        &self,
        frame: S::Frame,
        Coordinates { position, rate, acceleration }: Coordinates<'_, S, Self>,
        visit: &mut V,
        on_bodies: &mut Self::PerBody<V::OnBody>,
        in_joints: &mut Self::PerJoint<V::InJoint>,
    ) -> S::Frame {
        self.0.travel(frame, Coordinates { position, rate, acceleration }, visit, on_bodies, in_joints)
    }
    fn inward<G: Gather>(
        &self,
        bodies: &mut Self::PerBody<G::Entry>,
        joints: &mut Self::PerJoint<G::Entry>,
        outer: G::Carried,
        gather: &mut G,
    ) -> G::Carried {
        self.0.inward(bodies, joints, outer, gather)
    }
    fn broken<C: Closures>(&self, kept: &Self::Kept<C>, station: usize) -> Option<usize> {
        self.0.broken::<C>(kept, station)
    }
}

impl<S: Space, R, W: Sweep<S>, E: Condense<S, R, W>> Condense<S, R, W> for Counting<E> {
    type Out = E::Out;
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut Self::Kept<W::Closures>,
    ) -> Self::Out {
        let given = Given { on_bodies, in_joints, position, rate, reading, springs };
        self.0.condense(outer, Posture { x, y, p, q }, given, kept)
    }
}

type Links = Vec<Counting<(Pin, Rod<f64>)>>;

/// Rods on pins: every item of the outer vector has two of them, which its type does not say.
fn chain(items: usize) -> Vec<Counting<Links>> {
    let link = Counting((Pin, Rod::uniform(0.1, 1.0)));
    vec![Counting(vec![link; 2]); items]
}

/// Visits that a reading of all bodies takes, and one of all stations.
fn readings(items: usize) -> Result<[usize; 2], Error> {
    let rod = Rod::uniform(0.1, 1.0);
    let scene = System::new(Pinned::origin(), (rod, chain(items)), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..=2 * items).map(|k| 0.01 * k as f64).collect();
    let start = scene.with_accelerations(scene.at_rest(&angles)?, &Unloaded)?;
    let (read, stations) = (scene.angles(&start), scene.stations(&start, &Unloaded));
    let of_bodies = visits(|| {
        // Each in its place.
        assert!(read.iter().copied().eq(angles.iter().copied()));
    });
    let of_stations = visits(|| {
        let places: Vec<f64> = stations.iter().map(|station| station.frame.place.x).collect();
        assert_eq!(places.len(), 4 * items + 2); // a body, a pin and a body for each rod, and the tip
        let mut x = 0.0;
        for (k, place) in places.into_iter().enumerate() {
            assert!((place - x).abs() < 1e-12, "station {k}: {place} {x}");
            // A body reaches from its own station to the next one.
            x += if k % 2 == 0 { 0.1 * angles.get(k / 2).map_or(0.0, |angle| angle.cos()) } else { 0.0 };
        }
    });
    // What is looked up by number is the same.
    for (k, station) in stations.iter().enumerate() {
        assert_eq!(stations.get(k), Some(station));
    }
    Ok([of_bodies, of_stations])
}

#[test]
fn all_stations_are_read_in_one_walk() -> Result<(), Error> {
    let mut last = None;
    for items in [10, 100, 1000] {
        let found = readings(items)?;
        println!("{items} items: {found:?} visits");
        for count in found {
            assert!(count <= 10 * items, "{count} visits of {items} items");
        }
        last = Some(found);
    }
    assert!(last.is_some_and(|found| found.iter().all(|count| *count > 0)));
    Ok(())
}

/// Where types decide how many there are, numbers are found by them.
#[test]
fn arms_and_loops_are_read_in_order() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let net = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
    let fixed = (rod, Branch((Pin, rod)), net, [(Pin, rod); 2]);
    let grown = (rod, Branch(vec![(Pin, rod)]), net, vec![(Pin, rod); 2]);
    let fixed = System::new(Pinned::origin(), fixed, Free)?.with_gravity(9.81);
    let grown = System::new(Pinned::origin(), grown, Free)?.with_gravity(9.81);
    let angles = [0.1, 2.0, 0.3, 1.4, 1.4, 0.3, -0.2, -0.4];
    let (one, two) = (fixed.at_rest(&angles)?, grown.at_rest(&angles)?);
    let (one, two) = (fixed.with_accelerations(one, &Unloaded)?, grown.with_accelerations(two, &Unloaded)?);
    let (these, those) = (fixed.stations(&one, &Unloaded), grown.stations(&two, &Unloaded));
    assert_eq!(these.iter().count(), 17);
    assert!(these.iter().eq(those.iter()));
    assert!(fixed.angles(&one).iter().eq(grown.angles(&two).iter()));
    let mut count = 0;
    mirror::Position::visit(one.position(), &mut |_: f64| count += 1);
    assert_eq!(count, 8);
    Ok(())
}
