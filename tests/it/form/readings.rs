//! Readings of all bodies and stations of a scene meet each element a bounded number of times, however many there are.

use catena::internals::element::{Condense, Given, Posture, Sweep};
use catena::internals::shape::{Field, Inward, Kept, Member, Of, Outward, PerAxes, Shape, Slot};
use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::{Element, Space};
use catena::{Error, system};
use std::cell::Cell;

thread_local! {
    /// How often walks came by.
    static VISITS: Cell<usize> = const { Cell::new(0) };
}

fn visits(read: impl FnOnce()) -> usize {
    VISITS.set(0);
    read();
    VISITS.get()
}

/// An element that counts how often a walk comes by, and is that element otherwise.
#[derive(Clone)]
struct Counting<E>(E);

/// Where it is in itself.
#[derive(Clone, Copy)]
struct Counted;

impl<S: Space, E: Shape<S>> Member<S, Counting<E>> for Counted {
    type Item = E;
    fn get<F: Field<S>>(store: &E::Store<F>) -> &E::Store<F> {
        store
    }
    fn get_mut<F: Field<S>>(store: &mut E::Store<F>) -> &mut E::Store<F> {
        store
    }
}

impl<S: Space, E: Shape<S>> Shape<S> for Counting<E> {
    type Store<F: Field<S>> = E::Store<F>;
    const BODIES: Option<usize> = E::BODIES;
    const JOINTS: Option<usize> = E::JOINTS;
    const LOOPS: usize = E::LOOPS;
    const LINEAR: bool = E::LINEAR;

    fn store<F: Field<S>>(&self, fill: F::Fill) -> E::Store<F> {
        self.0.store::<F>(fill)
    }
    fn outward<W: Outward<S>>(&self, walk: &mut W, carried: W::Carried, mut stores: Of<'_, S, W, Self>) -> W::Carried {
        VISITS.set(VISITS.get() + 1);
        self.0.outward(walk, carried, W::Stores::member::<Self, _>(&mut stores, Counted))
    }
    fn inward<W: Inward<S>>(&self, walk: &mut W, carried: W::Carried, mut stores: Of<'_, S, W, Self>) -> W::Carried {
        VISITS.set(VISITS.get() + 1);
        self.0.inward(walk, carried, W::Stores::member::<Self, _>(&mut stores, Counted))
    }
}

impl<S: Space, E: Element<S>> Element<S> for Counting<E> {
    type Position = E::Position;
    type Rate = E::Rate;
    const ABSOLUTE: bool = E::ABSOLUTE;
    const TURNS_ANEW: bool = E::TURNS_ANEW;

    fn bodies(&self) -> usize {
        VISITS.set(VISITS.get() + 1);
        self.0.bodies()
    }
    fn joints(&self) -> usize {
        VISITS.set(VISITS.get() + 1);
        self.0.joints()
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
        x: &mut E::Store<PerAxes<S::X>>,
        y: &mut E::Store<PerAxes<S::Y>>,
        p: &mut E::Store<PerAxes<S::P>>,
        q: &mut E::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        self.0.orient(position, rate, turn, x, y, p, q)
    }
    fn resolve(
        sizes: &E::Store<PerAxes<S::Size>>,
        x: &mut E::Store<PerAxes<S::X>>,
        y: &mut E::Store<PerAxes<S::Y>>,
        p: &mut E::Store<PerAxes<S::P>>,
        q: &mut E::Store<PerAxes<S::Q>>,
    ) {
        E::resolve(sizes, x, y, p, q);
    }
}

impl<S: Space, R, W: Sweep<S>, E: Condense<S, R, W>> Condense<S, R, W> for Counting<E> {
    type Out = E::Out;
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut E::Store<Kept<W::Closures>>,
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
    let (read, stations) = (scene.angles(&start)?, scene.stations(&start, &Unloaded)?);
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
    let (these, those) = (fixed.stations(&one, &Unloaded)?, grown.stations(&two, &Unloaded)?);
    assert_eq!(these.iter().count(), 17);
    assert!(these.iter().eq(those.iter()));
    assert!(fixed.angles(&one)?.iter().eq(grown.angles(&two)?.iter()));
    let mut count = 0;
    system::Position::visit(one.position(), &mut |_: f64| count += 1);
    assert_eq!(count, 8);
    Ok(())
}
