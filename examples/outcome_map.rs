//! Which rod of a double pendulum turns over first, for a grid of starts: four scenes in the lanes of a number, on all threads.
//!
//! Both rods are let go from rest, each at any angle from hanging. From some starts neither can turn over, for want of energy; from others the map
//! is smooth at first and then ever finer, which is what chaos looks like.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo run --release --features rayon,simd --example outcome_map -- 400
//! ```
//!
//! The number is that of starts each way, from 8 to 1000.

mod common;
#[path = "pictures/outcome_map.rs"]
mod pictures;

use catena::Error;
use catena::planar::*;
use catena::scalar::{Scalar, WideF64x4};
use catena::simulate::ensemble;
use indicatif::ProgressBar;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::time::Instant;

const STEP: f64 = 0.01; // (s)
const END: f64 = 6.0; // (s)
/// One row of the map in so many is run in each of the ways that are compared, so many times.
const SPARSE: usize = 8;
const REPEATED: usize = 3;

/// Angles of the rods from hanging (rad).
type Start = [f64; 2];

/// Which rod turned over first and when (s), if one did, and for how many steps the scene was run.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Outcome {
    first: Option<(usize, f64)>,
    steps: usize,
}

/// Runs scenes at once, each in its lane, until a rod has turned over in all of them.
fn run<T: Scalar<Real = f64>, const N: usize>(starts: [T; 2], lanes: fn(T) -> [f64; N]) -> Result<[Outcome; N], Error> {
    let rod = Rod::uniform(T::literal(1.0), T::literal(1.0)); // length (m), mass (kg)
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(T::literal(9.81));
    let start = scene.at_rest(&starts.map(|angle| angle - T::literal(FRAC_PI_2)))?;
    let mut run = scene.simulation(Rk4::step(STEP)).begin(start, END, |_| ())?;
    let (mut outcomes, mut left) = ([Outcome { first: None, steps: 0 }; N], N);
    while left > 0 && run.step()? {
        let (inner, ((), outer, ())) = *run.motion().position();
        let angles = [inner, outer].map(|angle| lanes(angle + T::literal(FRAC_PI_2)));
        for (lane, outcome) in outcomes.iter_mut().enumerate() {
            outcome.steps += 1;
            let over = angles.iter().position(|angle| angle[lane].abs() > PI);
            if let (None, Some(rod)) = (outcome.first, over) {
                outcome.first = Some((rod, run.motion().time()));
                left -= 1;
            }
        }
    }
    Ok(outcomes)
}

fn alone(start: &Start) -> Result<Outcome, Error> {
    run(*start, |angle| [angle]).map(|[outcome]| outcome)
}

fn in_lanes(starts: [&Start; 4]) -> Result<[Outcome; 4], Error> {
    run([0, 1].map(|rod| WideF64x4::from(starts.map(|start| start[rod]))), WideF64x4::into_arr)
}

/// Ways to run an ensemble.
#[derive(Clone, Copy)]
enum Way {
    Alone,
    InLanes,
}

/// All outcomes, and how long they took (s).
fn timed(way: Way, threads: &ThreadPool, starts: &[Start], bar: &ProgressBar) -> Result<(Vec<Outcome>, f64), Error> {
    let clock = Instant::now();
    let all = threads.install(|| {
        let ensemble = ensemble(starts).progress(|done| bar.set_position(done as u64));
        match way {
            Way::Alone => ensemble.run(alone),
            Way::InLanes => ensemble.run_in_lanes(in_lanes),
        }
    });
    Ok((all.into_iter().collect::<Result<_, _>>()?, clock.elapsed().as_secs_f64()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let n = std::env::args().nth(1).map_or(Ok(160), |text| text.parse::<usize>())?;
    if !(8..=1000).contains(&n) {
        return Err(format!("{n} starts each way: from 8 to 1000 make a map").into());
    }
    let angle = |k: usize| TAU * (k as f64 + 0.5) / n as f64 - PI;
    let row = |row: usize| (0..n).map(move |column| [angle(column), angle(row)]);
    let starts: Vec<Start> = (0..n).flat_map(row).collect();
    let few: Vec<Start> = (0..n).step_by(SPARSE).flat_map(row).collect();

    let (one, all) = (ThreadPoolBuilder::new().num_threads(1).build()?, ThreadPoolBuilder::new().build()?);
    let count = all.current_num_threads();
    let ways =
        [("f64", Way::Alone, &one, 1), ("f64 x 4", Way::InLanes, &one, 1), ("f64 x 4", Way::InLanes, &all, count)];
    let (mut best, mut found) = ([(f64::INFINITY, 0); 3], vec![]);
    for _ in 0..REPEATED {
        for (best, (_, way, threads, _)) in best.iter_mut().zip(ways) {
            let (outcomes, time) = timed(way, threads, &few, &ProgressBar::hidden())?;
            let steps: usize = outcomes.iter().map(|outcome| outcome.steps).sum();
            *best = (best.0.min(time), steps);
            found.push(outcomes.iter().map(|outcome| outcome.first).collect::<Vec<_>>());
        }
    }

    let bar = ProgressBar::new(starts.len() as u64);
    let (outcomes, time) = timed(Way::InLanes, &all, &starts, &bar)?;
    bar.finish_and_clear();
    println!("scalar       threads   scenes/s   million steps/s   ns/step   share of the first");
    let first = best[0].0;
    for ((name, _, _, threads), (time, steps)) in ways.into_iter().zip(best) {
        let (scenes, rate, each) = (few.len() as f64 / time, 1e-6 * steps as f64 / time, 1e9 * time / steps as f64);
        println!("{name:11}  {threads:7}   {scenes:8.0}   {rate:15.2}   {each:7.1}   {:18.3}", time / first);
    }
    if found.iter().any(|outcomes| *outcomes != found[0]) {
        return Err("lanes, threads and plain numbers differ".into());
    }
    println!(
        "\nAll three find the same outcomes at the same times, from {} starts, the best of {REPEATED}.",
        few.len()
    );
    let firsts: Vec<_> = outcomes.iter().map(|outcome| outcome.first).collect();
    let of = |rod: Option<usize>| firsts.iter().filter(|first| first.map(|(rod, _)| rod) == rod).count();
    let [none, inner, outer] = [None, Some(0), Some(1)].map(of);
    println!("The map, {} starts, took {time:.2} s with lanes and {count} threads.", starts.len());
    println!("First over: the inner rod from {inner}, the outer rod from {outer}, neither within {END} s from {none}.");
    // The start opposite has the same motion, mirrored: rounding and steps must not have grown to be seen.
    let unlike =
        firsts.iter().zip(firsts.iter().rev()).filter(|(a, b)| pictures::shade(**a) != pictures::shade(**b)).count();
    let impossible = starts.iter().zip(&firsts).filter(|(start, first)| margin(start) < 0.0 && first.is_some()).count();
    println!("Starts unlike their mirror image: {unlike}. Over without the energy for it: {impossible}.");
    println!("Picture: {}", pictures::draw(n, &firsts)?.display());
    Ok(())
}

/// Energy of a start beyond that at which a rod can stand on end, the outer one above an inner one that hangs (m g l / 2).
fn margin([inner, outer]: &Start) -> f64 {
    2.0 - 3.0 * inner.cos() - outer.cos()
}

type First = Option<(usize, f64)>;
