//! Which rod of a double pendulum turns over first, for a grid of starts, on all processes of an MPI job.
//!
//! ```text
//! cargo build --release && mpirun -n 2 target/release/catena-processes 100
//! ```
//!
//! The number is that of starts each way, from 2 to 10 000.

use catena::Error;
use catena::planar::*;
use catena_processes::spread;
use indicatif::ProgressBar;
use mpi::traits::Communicator;
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::time::Instant;

const STEP: f64 = 0.01; // (s)
const END: f64 = 6.0; // (s)

/// The rod that turns over first and when (s), if one does; rods are let go from rest at these angles from hanging (rad).
fn first([inner, outer]: &[f64; 2]) -> Result<Option<(usize, f64)>, Error> {
    let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[inner - FRAC_PI_2, outer - FRAC_PI_2])?;
    let mut run = scene.simulation(Rk4::step(STEP)).begin(start, END, |_| ())?;
    while run.step()? {
        let (inner, ((), outer, ())) = *run.motion().position();
        if let Some(rod) = [inner, outer].iter().position(|angle| (angle + FRAC_PI_2).abs() > PI) {
            return Ok(Some((rod, run.motion().time())));
        }
    }
    Ok(None)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let n = std::env::args().nth(1).map_or(Ok(100), |text| text.parse::<usize>())?;
    if !(2..=10_000).contains(&n) {
        return Err(format!("{n} starts each way: from 2 to 10 000 make a map").into());
    }
    let universe = mpi::initialize().ok_or("MPI runs already")?;
    let world = universe.world();
    let angle = |k: usize| TAU * (k as f64 + 0.5) / n as f64 - PI;
    let mut starts: Vec<[f64; 2]> = (0..n * n).map(|k| [angle(k % n), angle(k / n)]).collect();
    starts.push([f64::NAN, 0.0]); // an error in one run stops no other

    let clock = Instant::now();
    let own = (starts.len() - world.rank() as usize).div_ceil(world.size() as usize);
    let bar = if world.rank() == 0 { ProgressBar::new(own as u64) } else { ProgressBar::hidden() };
    // Errors travel as text: what they name lives in the program that made them.
    let run = |start: &[f64; 2]| first(start).map_err(|error| error.to_string());
    let outcomes = spread(&world, &starts, |done| bar.set_position(done as u64), run)?;
    bar.finish_and_clear();
    let Some(outcomes) = outcomes else { return Ok(()) };

    let (map, wrong) = outcomes.split_at(n * n);
    let of = |rod: Option<usize>| map.iter().flatten().filter(|first| first.map(|(rod, _)| rod) == rod).count();
    println!("processes   starts   inner first   outer first   neither   time (s)");
    let [inner, outer, neither] = [Some(0), Some(1), None].map(of);
    let (size, time) = (world.size(), clock.elapsed().as_secs_f64());
    println!("{size:9}   {:6}   {inner:11}   {outer:11}   {neither:7}   {time:8.2}", map.len());
    println!(
        "Moments of turning over, summed in order (s): {:?}",
        map.iter().flatten().flatten().map(|(_, t)| t).sum::<f64>()
    );
    match wrong {
        [Err(error)] => println!("A start that is no number: {error}"),
        _ => return Err("a start that is no number went through".into()),
    }
    Ok(())
}
