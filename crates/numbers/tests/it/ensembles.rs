//! Ensembles against a serial loop, bit for bit: order, errors in place, progress, lanes inside.

use catena::planar::*;
use catena::scalar::{Scalar, WideF64x4};
use catena::simulate::{EnergyDrift, Trace, ensemble};
use catena::{Error, Fault};
use rayon::prelude::*;
use rayon::{ThreadPoolBuildError, ThreadPoolBuilder};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Length of a rod (m) and angle at which it is let go (rad).
type Start = [f64; 2];

/// Under error control, a tolerance.
const TOLERANCE: f64 = 1e-8;

/// Where a pendulum is after some steps (rad), fixed ones or not.
fn ended<T: Scalar<Real = f64>>([length, angle]: [T; 2], fixed: bool) -> Result<T, Error> {
    let pendulum = System::new(Pinned::origin(), Rod::uniform(length, T::literal(1.0)), Free)?;
    let pendulum = pendulum.with_gravity(T::literal(9.81));
    let start = pendulum.at_rest(&[angle])?;
    let run = match fixed {
        true => pendulum.simulate(start, Rk4::step(0.01), 0.2, |_| ())?,
        false => pendulum.simulate(start, Dopri5::tolerance(TOLERANCE), 0.2, |_| ())?,
    };
    let end = run.motion;
    let [angle] = end.coordinates_of(pendulum.joint(0)?)?;
    Ok(angle)
}

fn swung(start: &Start) -> Result<f64, Error> {
    ended(*start, true)
}

/// Four at once.
fn ended_in_lanes(starts: [&Start; 4], fixed: bool) -> Result<[f64; 4], Error> {
    let lanes = [0, 1].map(|k| WideF64x4::from(starts.map(|start| start[k])));
    ended(lanes, fixed).map(WideF64x4::into_arr)
}

fn swung_in_lanes(starts: [&Start; 4]) -> Result<[f64; 4], Error> {
    ended_in_lanes(starts, true)
}

/// Starts of which every seventh has a length that no rod has.
fn starts(count: usize) -> Vec<Start> {
    let start = |k: usize| [if k % 7 == 5 { -9.0 } else { 1.0 + 0.03 * k as f64 }, 0.1 * k as f64 - 2.0];
    (0..count).map(start).collect()
}

fn bits(results: Vec<Result<f64, Error>>) -> Vec<Result<u64, Fault>> {
    let bits = |result: Result<f64, Error>| result.map(f64::to_bits).map_err(|error| error.fault);
    results.into_iter().map(bits).collect()
}

/// What another number of threads makes of something.
fn on_threads<T: Send>(threads: usize, make: impl FnOnce() -> T + Send) -> Result<T, ThreadPoolBuildError> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?.install(make))
}

#[test]
fn results_and_errors_are_those_of_a_serial_loop_on_any_number_of_threads() -> Result<(), ThreadPoolBuildError> {
    let starts = starts(46);
    let serial = bits(starts.iter().map(swung).collect());
    let wrong: Vec<usize> = (0..46).filter(|k| serial[*k].is_err()).collect();
    assert_eq!(wrong, [5, 12, 19, 26, 33, 40]);
    assert!(serial[0] != serial[1]);
    for threads in [1, 2, 5] {
        let all = on_threads(threads, || ensemble(&starts).run(swung))?;
        assert_eq!(bits(all), serial, "{threads} threads");
        // Batches with a wrong length in a lane, and a last one that is not full.
        let all = on_threads(threads, || ensemble(&starts).run_in_lanes(swung_in_lanes))?;
        assert_eq!(bits(all), serial, "{threads} threads, in lanes");
    }
    Ok(())
}

#[test]
fn under_error_control_lanes_share_their_steps_and_threads_change_nothing() -> Result<(), ThreadPoolBuildError> {
    let starts = starts(46);
    let alone: Vec<_> = starts.iter().map(|start| ended(*start, false)).collect();
    let run = |threads| {
        on_threads(threads, || ensemble(&starts).run_in_lanes(|starts: [&Start; 4]| ended_in_lanes(starts, false)))
    };
    let lanes = run(1)?;
    for threads in [2, 5] {
        assert_eq!(bits(run(threads)?), bits(lanes.clone()), "{threads} threads");
    }
    let pairs: Vec<_> =
        alone.iter().zip(&lanes).filter_map(|pair| Some((*pair.0.as_ref().ok()?, *pair.1.as_ref().ok()?))).collect();
    assert_eq!(pairs.len(), 40);
    let most = pairs.iter().map(|(alone, lane)| (alone - lane).abs()).fold(0.0, f64::max);
    println!("{most:.1e} rad from plain numbers");
    assert!(most > 0.0 && most < 10.0 * TOLERANCE, "{most:e}");
    Ok(())
}

#[test]
fn every_run_is_counted_once_and_in_order() -> Result<(), ThreadPoolBuildError> {
    for (count, threads) in [(0, 2), (1, 2), (46, 1), (46, 5)] {
        let (starts, mut alone, mut lanes) = (starts(count), vec![], vec![]);
        on_threads(threads, || {
            ensemble(&starts).progress(|done| alone.push(done)).run(swung);
            ensemble(&starts).progress(|done| lanes.push(done)).run_in_lanes(swung_in_lanes);
        })?;
        let each: Vec<usize> = (1..=count).collect();
        assert_eq!((&alone, &lanes), (&each, &each));
    }
    Ok(())
}

/// Largest drift of energy (J) of pendulums let go at some angles (rad), and what a trace of them writes.
fn watched<T: Scalar<Real = f64>>(angle: T) -> Result<(f64, std::io::Result<Vec<u8>>), Error> {
    let pendulum = System::new(Pinned::origin(), Rod::uniform(T::literal(1.0), T::literal(1.0)), Free)?;
    let pendulum = pendulum.with_gravity(T::literal(9.81));
    let (mut drift, mut trace) = (EnergyDrift::default(), Trace::new(vec![]));
    pendulum.simulate(pendulum.at_rest(&[angle])?, Rk4::step(0.05), 1.0, |now| {
        drift.observe(now);
        trace.observe(now);
    })?;
    Ok((drift.largest(), trace.finish()))
}

#[test]
fn what_is_read_of_lanes_is_that_of_each_or_refused() -> Result<(), Error> {
    let angles = [-0.5, 0.5, 0.0, 0.3]; // of energies of either sign
    let mut largest = 0.0_f64;
    for angle in angles {
        let (drift, trace) = watched(angle)?;
        largest = largest.max(drift);
        assert!(drift > 0.0 && trace.is_ok());
    }
    let (drift, trace) = watched(WideF64x4::from(angles))?;
    assert_eq!(drift, largest);
    assert!(trace.is_err());

    let one = WideF64x4::literal(1.0);
    let pendulum = System::new(Pinned::origin(), Rod::uniform(one, one), Free)?;
    let start = pendulum.at_rest(&[WideF64x4::from(angles)])?;
    let run = pendulum.simulation(Rk4::step(0.05)).event(|now| now.motion().coordinates()[0]);
    let refused = run.run(start, 1.0, |_| ()).map(|_| ()).unwrap_err().error.fault;
    assert!(matches!(refused, Fault::Unsupported { .. }), "{refused:?}");
    Ok(())
}

#[test]
fn energies_that_are_no_numbers_are_no_small_drift() -> Result<(), Error> {
    let pendulum = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(1e308);
    let (mut drift, mut seen) = (EnergyDrift::default(), vec![]);
    let start = pendulum.with_rates(pendulum.at_rest(&[1.0])?, &[1e160])?;
    let _ = pendulum.simulate(start, Rk4::step(1e-300), 2e-300, |now| {
        drift.observe(now);
        seen.push(now.energy());
    });
    assert!(seen.iter().any(|energy| !energy.is_finite()), "{seen:?}");
    assert!(drift.largest().is_nan(), "{seen:?}");
    Ok(())
}

#[test]
fn nothing_comes_of_no_parameters() {
    assert_eq!(ensemble(&[]).run(swung), []);
    assert_eq!(ensemble(&[]).run_in_lanes(swung_in_lanes), []);
}

/// Who counts may hand work to the threads that are counted: no run waits for another to be counted.
#[test]
fn progress_may_use_the_threads() -> Result<(), ThreadPoolBuildError> {
    let (starts, mut counted) = (starts(30), 0);
    let sums = on_threads(2, || {
        let sum = |done: usize| (0..done).into_par_iter().with_max_len(1).sum::<usize>();
        ensemble(&starts).progress(|done| counted += sum(done)).run(|start| start[0])
    })?;
    assert_eq!((sums.len(), counted), (30, (1..=30).map(|n| n * (n - 1) / 2).sum()));
    Ok(())
}

#[test]
fn a_panic_of_the_closure_is_the_callers() {
    let starts = starts(20);
    let run = |start: &Start| assert!(start[1] < -0.5, "too high");
    assert!(catch_unwind(AssertUnwindSafe(|| ensemble(&starts[..15]).run(run))).is_ok());
    assert!(catch_unwind(AssertUnwindSafe(|| ensemble(&starts).run(run))).is_err());
}

#[test]
fn parameters_are_checked_in_each_lane() {
    let built = |lengths: [f64; 4], masses: [f64; 4]| {
        let rod = Rod::uniform(WideF64x4::from(lengths), masses.into());
        System::new(Pinned::origin(), rod, Free).map(|_| ()).map_err(|error| error.fault)
    };
    let (large, none) = ([5.0, -0.1, 7.0, 6.0], [5.0, 0.1, 0.0, 6.0]);
    assert_eq!(built([1.0, 2.0, 3.0, 4.0], [5.0, 0.1, 7.0, 6.0]), Ok(()));
    assert_eq!(built([1.0; 4], large), Err(Fault::NotPositive { parameter: "mass", value: -0.1 }));
    assert!(matches!(
        built(large, [1.0; 4]),
        Err(Fault::NotPositive { value: -0.1, .. } | Fault::Negative { value: -0.1, .. })
    ));
    assert_eq!(built([1.0; 4], none), Err(Fault::NotPositive { parameter: "mass", value: 0.0 }));
}
