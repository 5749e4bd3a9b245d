//! Tips held twice in the same way are refused, with what is held twice; those that are nearly so are not.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::scalar::{Real, Scalar};
use catena::simulate::Interrupted;
use catena::system::Element;
use catena::system::{Dynamics, MotionOf, Runs};
use catena::system::{Position, Rate};
use catena::system::{Root, Tip};
use catena::{Error, Fault, Place};
use core::f64::consts::{FRAC_PI_2, PI};

const X: &str = "x of the tip";
const Y: &str = "y of the tip";
const ACROSS: &str = "place of the tip across its line";

/// Rods of a length and mass, joined by pins, and every third one longer and lighter.
pub fn chain<T: Scalar>(n: usize, length: f64, mass: f64) -> (Rod<T>, Vec<(Pin, Rod<T>)>) {
    let rod = |k: usize| {
        let other = (k % 3) as f64;
        Rod::uniform(T::literal(length * (1.0 + 0.3 * other)), T::literal(mass * (1.0 - 0.2 * other)))
    };
    (rod(0), (1..n).map(|k| (Pin, rod(k))).collect())
}

/// The fault of a scene at rest at these angles, if there is one. Positions, rates and time are as before.
pub fn fault<T: Scalar, R, C, P>(
    system: Result<System<T, R, C, P>, Error>,
    angles: &[f64],
) -> Result<Option<Fault>, Error>
where
    R: Root<Planar<T>>,
    C: Element<Planar<T>>,
    P: Tip<Planar<T>>,
    System<T, R, C, P>: Runs<Unloaded, Planar<T>, R, C, P>,
{
    let system = system?.with_gravity(T::literal(9.81));
    let time = T::Real::of(0.25);
    let start = system.at_rest(&angles.iter().map(|x| T::literal(*x)).collect::<Vec<_>>())?.at_time(time);
    let mut motion = start.clone();
    let found = system.accelerate(&mut motion, &Unloaded, &mut Dynamics::<Unloaded>::workspace(&system)).err();
    let untouched = |motion: &MotionOf<Planar<T>, R, C, P>| {
        let (mut same, mut equal) = (motion.time() == time, |a: T, b: T| a.real() == b.real());
        same &= motion.position().all(start.position(), &mut equal);
        same && motion.rate().all(start.rate(), &mut equal)
    };
    assert!(untouched(&motion));
    let run = system.simulate(start.clone(), Rk4::step(T::Real::of(1e-9)), T::Real::of(0.25 + 1e-9), |_| ());
    if let Some(found) = found {
        assert_eq!((found.place, found.time), (Some(Place::Tip), Some(0.25)));
        let Err(Interrupted { error, last }) = run else { panic!("the run went on") };
        assert_eq!(error, found);
        assert!(untouched(&last));
    }
    Ok(found.map(|error| error.fault))
}

fn redundant(closure: &'static str, independent: usize, of: usize) -> Option<Fault> {
    Some(Fault::RedundantClosures { closure, independent, of })
}

/// Too many closures for the chain: some of them follow from the others, wherever it is.
fn too_many_are_named<T: Scalar>() -> Result<(), Error> {
    let angles = [0.3, -0.8, 1.1];
    let number = T::literal;
    let origin = || Pinned::at(number(0.0), number(0.0));
    let clamp = |angle| Clamped::at(number(0.0), number(0.0), number(angle));
    // Clamps at both ends hold two angles of the middle rods in three ways.
    let three = System::new(clamp(angles[0]), chain::<T>(3, 1.0, 1.0), clamp(angles[2]));
    let found = fault(three, &angles[1..])?;
    println!("clamped twice: {found:?}");
    assert!(matches!(found, Some(Fault::RedundantClosures { independent: 2, of: 3, .. })));
    let two = System::new(clamp(angles[0]), chain::<T>(2, 1.0, 1.0), clamp(angles[1]));
    assert!(matches!(fault(two, &angles[1..2])?, Some(Fault::RedundantClosures { independent: 1, of: 3, .. })));
    let one = System::new(clamp(angles[0]), chain::<T>(1, 1.0, 1.0), clamp(angles[0]));
    assert!(matches!(fault(one, &[])?, Some(Fault::RedundantClosures { independent: 0, of: 3, .. })));
    // A pin and a clamp at two rods, pins at one.
    let two = System::new(origin(), chain::<T>(2, 1.0, 1.0), clamp(angles[1]));
    assert!(matches!(fault(two, &angles[..2])?, Some(Fault::RedundantClosures { independent: 2, of: 3, .. })));
    let one = System::new(origin(), chain::<T>(1, 1.0, 1.0), Pinned::at(number(1.0), number(0.0)));
    assert_eq!(fault(one, &[0.0])?, redundant(X, 1, 2));
    // A guide at the end of a rod that a clamp holds.
    let guided = System::new(clamp(0.3), chain::<T>(2, 1.0, 1.0), Guided::on(clamp(-0.8), number(0.2)));
    assert!(matches!(fault(guided, &[-0.8])?, Some(Fault::RedundantClosures { independent: 1, of: 2, .. })));
    Ok(())
}

#[test]
fn closures_that_are_too_many_are_named() -> Result<(), Error> {
    too_many_are_named::<f64>()?;
    too_many_are_named::<f32>()
}

/// A straight chain cannot move along itself: what holds it there depends on the rest.
fn straight_chains_are_named<T: Scalar>() -> Result<(), Error> {
    let number = T::literal;
    let origin = || Pinned::at(number(0.0), number(0.0));
    let clamp = |angle| Clamped::at(number(0.0), number(0.0), number(angle));
    for n in [2, 3, 20, 300, 1000] {
        for (angle, named) in
            [(0.0, Some(X)), (FRAC_PI_2, Some(Y)), (0.7, None), (-2.2, None), (0.1, None), (3.0, None)]
        {
            for fold in [0.0, PI] {
                let angles: Vec<f64> = (0..n).map(|k| angle + fold * (k % 2) as f64).collect();
                let found = fault(System::new(origin(), chain::<T>(n, 1.0, 1.0), origin()), &angles)?;
                match named {
                    Some(name) => assert_eq!(found, redundant(name, 1, 2), "{n} rods at {angle}"),
                    None => assert!(found == redundant(X, 1, 2) || found == redundant(Y, 1, 2), "{n} rods: {found:?}"),
                }
            }
            // A line across the chain holds it along itself, one along the chain does not.
            let guide = |line: f64| Guided::on(clamp(angle), number(line));
            let across = System::new(origin(), chain::<T>(n, 1.0, 1.0), guide(FRAC_PI_2));
            assert_eq!(fault(across, &vec![angle; n])?, redundant(ACROSS, 1, 2), "{n} rods at {angle}");
            let along = System::new(origin(), chain::<T>(n, 1.0, 1.0), guide(0.0));
            assert_eq!(fault(along, &vec![angle; n])?, None, "{n} rods at {angle}");
        }
        if n > 3 {
            let clamped = System::new(clamp(0.0), chain::<T>(n, 1.0, 1.0), clamp(0.0));
            assert_eq!(fault(clamped, &vec![0.0; n - 1])?, redundant(X, 2, 3), "{n} rods");
        }
    }
    Ok(())
}

#[test]
fn straight_chains_held_at_both_ends_are_named() -> Result<(), Error> {
    straight_chains_are_named::<f64>()?;
    straight_chains_are_named::<f32>()
}

/// The smallest bend (rad) of zigzag chains of these numbers of rods that is told from a straight one.
fn smallest_bend<T: Scalar>(n: usize, angle: f64) -> Result<f64, Error> {
    let number = T::literal;
    let mut smallest = f64::NAN;
    for bend in [1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5] {
        let angles: Vec<f64> = (0..n).map(|k| angle + if k % 2 == 0 { bend } else { -bend }).collect();
        let place = || Pinned::at(number(0.0), number(0.0));
        if fault(System::new(place(), chain::<T>(n, 1.0, 1.0), place()), &angles)?.is_some() {
            break;
        }
        smallest = bend;
    }
    Ok(smallest)
}

#[test]
fn chains_that_are_almost_straight_are_not_refused() -> Result<(), Error> {
    for n in [2, 3, 20, 300] {
        for angle in [0.0, FRAC_PI_2, 0.7] {
            let (double, single) = (smallest_bend::<f64>(n, angle)?, smallest_bend::<f32>(n, angle)?);
            println!("{n} rods at {angle:.1}: bends down to {double:.0e} rad, in single precision {single:.0e} rad");
            assert!(double < 2e-5 && single < 2e-3);
        }
    }
    Ok(())
}
