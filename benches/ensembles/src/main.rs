//! What a scene costs in an ensemble: one alone, several in the lanes of a number, on one thread and on all.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p catena-ensembles
//! ```
//!
//! RK4 at fixed steps, a thousand a run; all ways take turns, and each round gives a share of plain numbers on one thread. Prints lines of
//! CSV: scene, scalar, lanes, threads, nanoseconds of a scene and step (median), share (median of rounds). `benches/rivals/ensembles.py`
//! puts MuJoCo's `rollout` beside these.

#[path = "../../parts/clock.rs"]
mod clock;
mod scenes;

use catena::scalar::{WideF32x8, WideF32x16, WideF64x4, WideF64x8};
use catena::simulate::ensemble;
use clock::{median, progress};
use rayon::{ThreadPool, ThreadPoolBuilder};
use scenes::{Run, STEPS, balls, chain, four_bar, pendulum};
use std::error::Error;
use std::time::Instant;

const ROUNDS: usize = 11;

/// Seconds that an ensemble takes.
type Timed = Box<dyn Fn(&[f64]) -> Result<f64, catena::Error>>;

/// A way to run an ensemble.
struct Way {
    scene: &'static str,
    scalar: &'static str,
    lanes: usize,
    threads: usize,
    run: Timed,
    seconds: Vec<f64>,
}

fn timed<const N: usize>(run: Run<N>, starts: &[f64]) -> Result<f64, catena::Error> {
    let clock = Instant::now();
    let ends: Result<Vec<f64>, _> = ensemble(starts).run_in_lanes(run).into_iter().collect();
    std::hint::black_box(ends?);
    Ok(clock.elapsed().as_secs_f64())
}

fn pool(threads: usize) -> Result<ThreadPool, Box<dyn Error>> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let word = std::env::args().nth(1).unwrap_or_default();
    let cores = std::thread::available_parallelism()?.get();
    let mut ways = Vec::new();
    macro_rules! add {
        ($name:literal, $run:ident, $($T:ty, $scalar:literal, $n:literal;)*) => {$(
            for threads in [1, cores] {
                let pool = pool(threads)?;
                let run = Box::new(move |starts: &[f64]| pool.install(|| timed::<$n>($run::<$T, $n>, starts)));
                ways.push(Way { scene: $name, scalar: $scalar, lanes: $n, threads, run, seconds: vec![] });
            }
        )*};
        ($name:literal, $run:ident) => {
            if $name.contains(&word) {
                add!($name, $run, f64, "f64", 1; WideF64x4, "f64", 4; WideF64x8, "f64", 8; f32, "f32", 1; WideF32x8, "f32", 8; WideF32x16, "f32", 16;);
            }
        };
    }
    add!("2 rods on pins", pendulum);
    add!("20 rods on pins", chain);
    add!("four-bar", four_bar);
    add!("3 rods on balls", balls);

    for round in 0..ROUNDS {
        for way in &mut ways {
            progress(&format!("round {} of {ROUNDS}: {}", round + 1, way.scene));
            // So many that lanes on two threads take tens of milliseconds, too.
            let scenes = if way.scene.starts_with("20") { 512 } else { 4096 };
            let starts: Vec<f64> = (0..scenes).map(|k| -0.5 + k as f64 / scenes as f64).collect();
            way.seconds.push((way.run)(&starts)? / (scenes * STEPS) as f64);
        }
    }
    progress("");
    println!("scene,library,scalar,lanes,threads,nanoseconds,share");
    for way in &ways {
        let alone =
            |other: &&Way| (other.scene, other.scalar, other.lanes, other.threads) == (way.scene, way.scalar, 1, 1);
        let Some(alone) = ways.iter().find(alone) else { continue };
        let mut shares: Vec<f64> = way.seconds.iter().zip(&alone.seconds).map(|(own, alone)| own / alone).collect();
        let nanoseconds = 1e9 * median(&mut way.seconds.clone());
        let share = median(&mut shares);
        let Way { scene, scalar, lanes, threads, .. } = way;
        println!("{scene},Catena,{scalar},{lanes},{threads},{nanoseconds:.2},{share:.4}");
    }
    Ok(())
}
