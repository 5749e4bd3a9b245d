//! Sound closures are not refused, whatever the size of lengths and masses, and however different they are.

use super::redundant::{chain, fault};
use catena::Error;
use catena::planar::*;
use catena::scalar::Scalar;

/// Angles (rad) of a bent chain.
fn angles(n: usize) -> Vec<f64> {
    (0..n).map(|k| 0.4 + 1.1 * (1.7 * k as f64).sin()).collect()
}

/// The faults of a chain of n elements between pins, between clamps, and between a clamp and a guide.
macro_rules! faults {
    ($T:ident, $n:expr, $chain:expr) => {{
        let angles = angles($n);
        let number = |x: f64| $T::literal(x);
        let clamp = |k: usize| Clamped::at(number(0.0), number(0.0), number(angles[k]));
        let pin = || Pinned::at(number(0.0), number(0.0));
        let guide = || Guided::on(clamp($n - 1), number(0.7));
        [
            fault(System::new(pin(), $chain, pin()), &angles)?,
            fault(System::new(clamp(0), $chain, clamp($n - 1)), &angles[1..])?,
            fault(System::new(clamp(0), $chain, guide()), &angles[1..])?,
        ]
    }};
}

fn none_of_any_size<T: Scalar>() -> Result<(), Error> {
    for n in [4, 10, 100] {
        for length in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
            for mass in [1e-6, 1.0, 1e6] {
                let found = faults!(T, n, chain::<T>(n, length, mass));
                assert_eq!(found, [None; 3], "{n} rods of {length} m and {mass} kg");
            }
        }
    }
    Ok(())
}

#[test]
fn closures_of_any_size_are_independent() -> Result<(), Error> {
    none_of_any_size::<f64>()?;
    none_of_any_size::<f32>()
}

/// Chains of rods of which some have `share` of the others' mass, or length.
fn mixed<T: Scalar>(
    n: usize,
    by_mass: bool,
    share: f64,
    is_other: impl Fn(usize) -> bool,
) -> (Rod<T>, Vec<(Pin, Rod<T>)>) {
    let rod = |k: usize| {
        let share = if is_other(k) { share } else { 1.0 };
        let [length, mass] = if by_mass { [1.0, share] } else { [share, 1.0] };
        Rod::uniform(T::literal(length), T::literal(mass))
    };
    (rod(0), (1..n).map(|k| (Pin, rod(k))).collect())
}

/// The most extreme shares, below and above one, with which no chain is refused.
fn extremes<T: Scalar>(by_mass: bool, is_other: impl Fn(usize, usize) -> bool) -> Result<[f64; 2], Error> {
    let mut extremes = [1.0; 2];
    for (side, extreme) in [-1, 1].into_iter().zip(&mut extremes) {
        for power in 1..=12 {
            let share = 10.0_f64.powi(side * power);
            let mut faults = vec![];
            for n in [4, 10] {
                faults.extend(faults!(T, n, mixed::<T>(n, by_mass, share, |k| is_other(k, n))));
            }
            if faults.iter().any(Option::is_some) {
                break;
            }
            *extreme = share;
        }
    }
    Ok(extremes)
}

#[test]
fn closures_of_very_different_bodies_are_independent() -> Result<(), Error> {
    let last = |k: usize, n: usize| k + 1 == n;
    let first = |k: usize, _: usize| k == 0;
    let every_other = |k: usize, _: usize| k % 2 == 1;
    for by_mass in [true, false] {
        let what = if by_mass { "mass" } else { "length" };
        for (which, [double, single]) in [
            ("the last", [extremes::<f64>(by_mass, last)?, extremes::<f32>(by_mass, last)?]),
            ("the first", [extremes::<f64>(by_mass, first)?, extremes::<f32>(by_mass, first)?]),
            ("every other", [extremes::<f64>(by_mass, every_other)?, extremes::<f32>(by_mass, every_other)?]),
        ] {
            println!("{what} of {which}: {double:?}, in single precision {single:?}");
            // A light last body makes the others look fixed: the measure is what it would yield alone.
            assert!(double[0] < 2e-9 && single[0] < 2e-5 && double[1] > 1e11 && single[1] > 1e11);
        }
    }
    Ok(())
}

/// Point masses have no moment of inertia of their own; links between them may have no mass.
fn none_with_point_masses<T: Scalar>() -> Result<(), Error> {
    let number = T::literal;
    let rod = || Rod::uniform(number(1.0), number(1.0));
    let point = |mass: f64| PointMass::new(number(1.0), number(mass));
    assert_eq!(faults!(T, 5, (rod(), Pin, rod(), Pin, rod(), Pin, rod(), Pin, point(1.0))), [None; 3]);
    assert_eq!(faults!(T, 5, (point(1.0), vec![(Pin, point(1.0)); 4])), [None; 3]);
    assert_eq!(faults!(T, 5, (rod(), Pin, point(0.0), Pin, point(0.0), Pin, rod(), Pin, point(1e-3))), [None; 3]);
    Ok(())
}

#[test]
fn closures_that_hold_point_masses_are_independent() -> Result<(), Error> {
    none_with_point_masses::<f64>()?;
    none_with_point_masses::<f32>()
}
