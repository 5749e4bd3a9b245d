//! Motions assembled with some coordinates and rates held: against the closed forms of linkages.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::Holding;
use catena::{Error, Fault, Place};
use catena_oracle::{four_bar, near};
use core::f64::consts::PI;

/// Crank, coupler, rocker, and the distance of their ground pins (m).
const LENGTHS: [f64; 4] = [0.5, 1.2, 0.9, 1.0];
/// The crank: angle (rad) and rate (rad/s).
const CRANK: [f64; 2] = [PI / 3.0, 5.0];

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, length)
}

/// A four-bar linkage, its far end held by the ground: coordinates are angles of crank, coupler, rocker.
macro_rules! held_tip {
    () => {{
        let [a, b, c, d] = LENGTHS;
        System::new(Pinned::origin(), (rod(a), Pin, rod(b), Pin, rod(c)), Pinned::at(d, 0.0))?.with_gravity(9.81)
    }};
}

/// The same as a loop: the rocker stands on the ground, its angle turned by half a turn.
macro_rules! looped {
    ($closing:expr) => {{
        let [a, b, c, d] = LENGTHS;
        let arms = (Pin, rod(a), Pin, rod(b));
        let net = Network::new(arms, (RigidBody::massless([d, 0.0]), Pin, rod(c)), $closing);
        System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?.with_gravity(9.81)
    }};
}

#[test]
fn a_crank_stays_where_it_is_put() -> Result<(), Error> {
    let [[coupler, rocker], [of_coupler, of_rocker]] = four_bar(LENGTHS, CRANK);
    let scene = held_tip!();
    let rough = [CRANK[0], 0.3, -2.0];
    let guess = scene.with_rates(scene.at_rest(&rough)?, &[CRANK[1], 0.0, 0.0])?;
    // Left to itself, the crank moves most: it is the lightest.
    let loose = scene.assembled(guess, &Unloaded)?;
    println!("not held: {:?} {:?}", loose.position(), loose.rate());
    assert!((loose.rate().0 - CRANK[1]).abs() > 0.1);

    let start = scene.assembled_holding(guess, Holding::both(&[0]), &Unloaded)?;
    let (position, rate) = (start.motion.position(), start.motion.rate());
    println!("held: {position:?} {rate:?}, moved by {:?} and {:?}", start.displacements, start.rate_changes);
    let (angles, rates) = (numbers(position), numbers(rate));
    assert_eq!((angles[0], rates[0]), (CRANK[0], CRANK[1]));
    for (found, expected) in [(angles[1], coupler), (angles[2], rocker), (rates[1], of_coupler), (rates[2], of_rocker)]
    {
        near(found, expected, 1e-14);
    }
    // What moved is told.
    for k in 0..3 {
        assert_eq!(start.displacements[k], angles[k] - rough[k]);
        assert_eq!(start.rate_changes[k], rates[k] - [CRANK[1], 0.0, 0.0][k]);
    }
    // Its accelerations belong to it: it runs, and starts as it was put.
    let again = scene.with_accelerations(start.motion, &Unloaded)?;
    assert!(again.acceleration() == start.motion.acceleration());
    let run = scene.simulate(start.motion, Dop853::tolerance(1e-10), 0.5, |_| ())?;
    near(scene.budget(&run.motion)?.energy(), scene.budget(&start.motion)?.energy(), 1e-7);
    Ok(())
}

fn numbers<V: catena::system::Rate<f64>>(rate: &V) -> Vec<f64> {
    let mut numbers = vec![];
    rate.visit(&mut |x| numbers.push(x));
    numbers
}

fn places<P: catena::system::Position<f64>>(position: &P) -> Vec<f64> {
    let mut numbers = vec![];
    position.visit(&mut |x| numbers.push(x));
    numbers
}

#[test]
fn loops_close_around_a_crank_that_is_held() -> Result<(), Error> {
    let [[coupler, rocker], [of_coupler, of_rocker]] = four_bar(LENGTHS, CRANK);
    macro_rules! check {
        ($scene:expr) => {{
            let scene = $scene;
            let guess = scene.at_rest(&[CRANK[0], 0.1, 0.9])?;
            let guess = scene.with_rates(guess, &[CRANK[1], 1.0, -1.0])?;
            let start = scene.assembled_holding(guess, Holding::both(&[0]), &Unloaded)?;
            let angles: Vec<f64> = scene.angles(&start.motion).unwrap().iter().copied().collect();
            let rates = numbers(start.motion.rate());
            assert_eq!((angles[0], rates[0]), (CRANK[0], CRANK[1]));
            let expected = [coupler, rocker + PI, of_coupler, of_rocker];
            for (found, expected) in [angles[1], angles[3], rates[1], rates[2]].into_iter().zip(expected) {
                near(found, expected, 1e-14);
            }
            assert_eq!((start.displacements[0], start.rate_changes[0]), (0.0, 0.0));
            // The rocker instead: the crank's angle is that of the same linkage.
            let turned = scene.with_rates(scene.at_rest(&[1.2, 0.1, angles[3]])?, &[0.0, 0.0, of_rocker])?;
            let back = scene.assembled_holding(turned, Holding::both(&[2]), &Unloaded)?;
            near(scene.angles(&back.motion).unwrap().get(0).copied().unwrap_or(f64::NAN), CRANK[0], 1e-14);
            near(numbers(back.motion.rate())[0], CRANK[1], 1e-13);
            // Positions alone, rates alone.
            let places = Holding { positions: &[0], rates: &[] };
            let start = scene.assembled_holding(guess, places, &Unloaded)?;
            assert!(start.displacements[0] == 0.0 && start.rate_changes[0] != 0.0);
            let rates = Holding { positions: &[], rates: &[0] };
            let start = scene.assembled_holding(guess, rates, &Unloaded)?;
            assert!(start.displacements[0] != 0.0 && start.rate_changes[0] == 0.0);
        }};
    }
    check!(looped!(Pin));
    check!(looped!(LeastNorm(Pin)));
    Ok(())
}

/// With nothing held it is `assembled`, to the last bit, and tells what moved.
#[test]
fn nothing_held_is_assembled() -> Result<(), Error> {
    let scene = looped!(Pin);
    let guess = scene.with_rates(scene.at_rest(&[1.0, 0.1, 0.9])?, &[5.0, 1.0, -1.0])?;
    let told = scene.assembled_holding(guess, Holding::default(), &Unloaded)?;
    assert_eq!(told.motion, scene.assembled(guess, &Unloaded)?);
    let after = numbers(told.motion.rate());
    assert!(told.rate_changes.iter().zip(after.iter().zip([5.0, 1.0, -1.0])).all(|(d, (a, b))| *d == a - b));
    assert!(told.displacements.iter().any(|x| *x != 0.0));
    // A chain that closes nothing stays.
    let chain = System::new(Pinned::origin(), (rod(1.0), Pin, rod(1.0)), Free)?;
    let told = chain.assembled_holding(chain.at_rest(&[0.3, 0.4])?, Holding::both(&[1]), &Unloaded)?;
    assert_eq!((told.displacements, told.rate_changes), (vec![0.0; 2], vec![0.0; 2]));
    Ok(())
}

#[test]
fn holds_that_nothing_closes_with_are_refused() -> Result<(), Error> {
    let scene = looped!(Pin);
    let closing = Some(Place::Station(7));
    let refused = |angles: [f64; 3], rates: [f64; 3], holding: Holding<'_>| -> Result<Error, Error> {
        let guess = scene.with_rates(scene.at_rest(&angles)?, &rates)?.at_time(0.5);
        let error = scene.assembled_holding(guess, holding, &Unloaded).map(|_| ()).expect_err("it cannot close");
        println!("{error}");
        Ok(error)
    };
    // Crank and rocker point away from each other: 1.2 m do not reach.
    let error = refused([PI, 0.1, 0.0], [0.0; 3], Holding::both(&[0, 2]))?;
    let Fault::ImpossibleHold { what: "coordinates", residual } = error.fault else { panic!("{error}") };
    // Along one line 0.5 + 1.0 + 0.9 m less 1.2 m are missing, whichever way the coupler turns at least so much in x or y.
    assert!(residual > 1.2 / 2.0_f64.sqrt() - 1e-9 && residual <= 3.6, "{residual}");
    assert_eq!((error.place, error.time), (closing, Some(0.5)));
    // Two rates of a linkage with one freedom.
    let [[coupler, rocker], [_, of_rocker]] = four_bar(LENGTHS, CRANK);
    let closed = [CRANK[0], coupler, rocker + PI];
    let error = refused(closed, [CRANK[1], 0.0, of_rocker + 0.5], Holding { positions: &[0], rates: &[0, 2] })?;
    assert!(matches!(error.fault, Fault::ImpossibleHold { what: "rates", residual } if residual > 1e-3), "{error}");
    assert_eq!(error.place, closing);
    // The same rates that fit are no contradiction.
    let guess = scene.with_rates(scene.at_rest(&closed)?, &[CRANK[1], 0.0, of_rocker])?;
    scene.assembled_holding(guess, Holding { positions: &[0], rates: &[0, 2] }, &Unloaded)?;
    // Coordinates that there are none.
    let error = refused(closed, [0.0; 3], Holding::both(&[3]))?;
    assert!(matches!(error.fault, Fault::OutOfRange { value: 3.0, most: 2.0, .. }), "{error}");
    // A tip that is held.
    let chain = held_tip!();
    let guess = chain.at_rest(&[PI, 0.1, PI])?;
    let error = chain.assembled_holding(guess, Holding::both(&[0, 2]), &Unloaded).map(|_| ()).expect_err("too far");
    assert!(matches!(error.fault, Fault::ImpossibleHold { what: "coordinates", .. }), "{error}");
    assert_eq!(error.place, Some(Place::Tip));
    // A motion of another shape.
    let rods = |n: usize| System::new(Pinned::origin(), (rod(1.0), vec![(Pin, rod(1.0)); n]), Pinned::at(1.0, 0.0));
    let (three, other) = (rods(3)?, rods(2)?);
    let stale = other.at_rest(&[0.1, 0.2, 0.3])?;
    let error = three.assembled_holding(stale, Holding::both(&[0]), &Unloaded).map(|_| ()).expect_err("another shape");
    assert_eq!(error.fault, Fault::Shape);
    Ok(())
}

/// Three parallel cranks of which one is redundant: all turn as the one that is held.
#[test]
fn redundant_loops_follow_what_is_held() -> Result<(), Error> {
    let reach = |x| RigidBody::massless([x, 0.0]);
    let inner = Network::new((Pin, rod(1.0), Pin, rod(1.0)), (reach(1.0), Pin, rod(1.0)), Pin);
    let net = Network::new((inner, rod(1.0)), (reach(2.0), Pin, rod(1.0)), LeastNorm(Pin));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?;
    // Crank, platform, second crank, third crank.
    let guess = scene.with_rates(scene.at_rest(&[1.0, 0.05, 1.2, 1.1])?, &[0.0, 0.3, 2.0, 0.0])?;
    let start = scene.assembled_holding(guess, Holding { positions: &[2], rates: &[2] }, &Unloaded)?;
    let (angles, rates) = (places(start.motion.position()), numbers(start.motion.rate()));
    for (found, expected) in angles.iter().zip([1.2, 0.0, 1.2, 1.2]).chain(rates.iter().zip([2.0, 0.0, 2.0, 2.0])) {
        near(*found, expected, 1e-13);
    }
    Ok(())
}

/// In space: crank and rocker on axes that are askew, a rod on balls between them, the crank held.
#[test]
fn loops_in_space_close_around_a_crank_that_is_held() -> Result<(), Error> {
    use catena::spatial::{Ball, Clamped, Free, Network, Pinned, Revolute, RigidBody, Rod, System};
    use nalgebra::{Rotation3, Unit, Vector3};
    let (far, axis) = (Vector3::new(0.7, 0.1, 0.3), Unit::new_normalize(Vector3::new(0.3, 1.0, 0.2)));
    let (crank, coupler, rocker) = (0.3, 0.75, 0.8);
    let rod = |length: f64| Rod::uniform(length, 0.05, length);
    let main = (Revolute::about([0.0, 0.0, 1.0]), rod(crank), Ball, rod(coupler));
    let side = (RigidBody::massless(far.into()), Revolute::about((*axis).into()), rod(rocker));
    let scene = System::new(Clamped::origin(), Network::new(main, side, Ball), Free)?;
    let (angle, rate) = (0.4_f64, 3.0);
    let guess = scene.at_rest(&[angle, 0.1, 0.3, 0.5, -1.1])?;
    let guess = scene.with_rates(guess, &[rate, 0.0, 0.0, 0.0, 0.0])?;
    let loose = scene.assembled(guess, &Unloaded)?;
    println!("not held: {:?}", loose.rate());
    let start = scene.assembled_holding(guess, Holding::both(&[0]), &Unloaded)?;
    println!("moved by {:?} and {:?}", start.displacements, start.rate_changes);
    let bodies: Vec<_> = scene.body_motions(&start.motion)?.iter().copied().collect();
    // |p(ψ) − q| = l with p = far + R(ψ) e_x c and q at the end of the crank, by bisection from what was found.
    let q = Vector3::new(crank * angle.cos(), crank * angle.sin(), 0.0);
    let p = |psi: f64| far + Rotation3::from_axis_angle(&axis, psi) * Vector3::new(rocker, 0.0, 0.0);
    let found = bodies[3].outboard().place;
    let miss = |psi: f64| (p(psi) - q).norm() - coupler;
    let nearest = (-300..300)
        .map(|k| f64::from(k) * 0.01)
        .min_by(|a, b| (p(*a) - found).norm().total_cmp(&(p(*b) - found).norm()));
    let middle = nearest.unwrap_or(f64::NAN);
    let (mut low, mut high) = (middle - 0.02, middle + 0.02);
    assert!(miss(low) * miss(high) < 0.0);
    for _ in 0..60 {
        let half = 0.5 * (low + high);
        if miss(low) * miss(half) <= 0.0 { high = half } else { low = half }
    }
    near((p(low) - found).norm(), 0.0, 1e-14);
    near((bodies[0].outboard().place - q).norm(), 0.0, 1e-15);
    // d/dt: (p − q) · (ψ' a × (p − far) − ω z × q) = 0.
    let (between, z) = (p(low) - q, Vector3::z());
    let of_rocker = rate * between.dot(&z.cross(&q)) / between.dot(&axis.cross(&(p(low) - far)));
    near(numbers(start.motion.rate())[4], of_rocker, 1e-13);
    assert_eq!(numbers(start.motion.rate())[0], rate);
    assert_eq!((start.displacements[0], start.rate_changes[0]), (0.0, 0.0));

    // A tip that is held: a ball keeps its attitude, the others reach.
    let chain = (rod(0.5), Ball, rod(0.6), Ball, rod(0.7));
    let scene = System::new(Pinned::<[f64; 3]>::origin(), chain, Pinned::at([0.9, 0.4, -0.3]))?;
    let guess = scene.at_rest(&[0.1, -0.6, 0.8, 0.0, 0.2, -0.3, 0.0, 0.3, 0.1])?;
    let guess = scene.with_rates(guess, &[1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
    let before = scene.body_motions(&guess)?.get(0).map(|body| body.outboard());
    let start = scene.assembled_holding(guess, Holding::both(&[0, 1, 2]), &Unloaded)?;
    let (Some(before), Some(after)) = (before, scene.body_motions(&start.motion)?.get(0).map(|body| body.outboard()))
    else {
        panic!("no body")
    };
    near((before.place - after.place).norm(), 0.0, 1e-15);
    near((before.velocity - after.velocity).norm(), 0.0, 1e-15);
    let tip = scene.stations(&start.motion, &Unloaded)?.tip().frame;
    near((tip.place - Vector3::new(0.9, 0.4, -0.3)).norm(), 0.0, 1e-15);
    near(tip.velocity.norm(), 0.0, 1e-14);
    Ok(())
}
