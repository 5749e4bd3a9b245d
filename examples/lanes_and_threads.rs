//! How exactly must a double pendulum be made for its motion to be known? Hundreds of them, each a little off, run one by one, on all
//! threads, and four at once in the lanes of a number.
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo run --release --features rayon,simd --example lanes_and_threads -- 20000
//! ```
//!
//! The number is that of pendulums, from 8.

mod common;

use catena::Error;
use catena::planar::*;
use catena::scalar::{Elementary, Scalar, WideF64x4};
use catena::simulate::ensemble;
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use std::path::PathBuf;
use std::time::Instant;

/// Rods are longer or shorter by so much (m, standard deviation), and so heavy (kg/m).
const TOLERANCE: f64 = 1e-3;
const DENSITY: f64 = 1.0;
/// Step of the rule, and how far apart instants are that are looked at (s): so many of them.
const STEP: f64 = 0.02;
const APART: f64 = 0.25;
const INSTANTS: usize = 24;

/// Where the tip is (m) at each instant.
type Tips<T> = [[T; 2]; INSTANTS];

/// Runs a pendulum of rods of these lengths, or as many at once as a number has lanes.
fn run<T: Scalar<Real = f64>>(lengths: [T; 2]) -> Result<Tips<T>, Error> {
    let [inner, outer] = lengths.map(|length| Rod::uniform(length, length * T::literal(DENSITY)));
    let scene = System::new(Pinned::origin(), (inner, Pin, outer), Free)?.with_gravity(T::literal(9.81));
    let start = scene.at_rest(&[1.2, 1.9].map(T::literal))?;
    let mut tips = [[T::zero(); 2]; INSTANTS];
    let mut run = scene.simulation(Rk4::step(STEP)).begin(start, APART * INSTANTS as f64, |_| ())?;
    for (k, tip) in tips.iter_mut().enumerate() {
        run.until(APART * (k + 1) as f64)?;
        let (inner, ((), outer, ())) = *run.motion().position();
        for ((sin, cos), length) in [inner, outer].map(Elementary::sin_cos).into_iter().zip(lengths) {
            *tip = [tip[0] + length * cos, tip[1] + length * sin];
        }
    }
    Ok(tips)
}

/// Four pendulums in the lanes of one number.
fn four(lengths: [&[f64; 2]; 4]) -> Result<[Tips<f64>; 4], Error> {
    let tips = run([0, 1].map(|rod| WideF64x4::from(lengths.map(|pair| pair[rod]))))?;
    Ok(std::array::from_fn(|lane| tips.map(|tip| tip.map(|x| x.into_arr()[lane]))))
}

/// Lengths that scatter about 1 m: sums of twelve numbers of a generator, which is as good as a normal distribution here.
fn lengths(count: usize) -> Vec<[f64; 2]> {
    let mut state = 2005_u64;
    let mut uniform = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut length = || 1.0 + TOLERANCE * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0);
    (0..count).map(|_| [length(), length()]).collect()
}

/// Mean place of the tips at an instant, and how far they scatter about it (m, root of the mean square).
fn scatter(all: &[Tips<f64>], instant: usize) -> ([f64; 2], f64) {
    let mean = [0, 1].map(|axis| all.iter().map(|tips| tips[instant][axis]).sum::<f64>() / all.len() as f64);
    let off = |tips: &Tips<f64>| (tips[instant][0] - mean[0]).powi(2) + (tips[instant][1] - mean[1]).powi(2);
    (mean, (all.iter().map(off).sum::<f64>() / all.len() as f64).sqrt())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args().nth(1).map_or(Ok(200), |text| text.parse::<usize>())?.max(8);
    let lengths = lengths(count);
    println!("{count} double pendulums, their rods 1 m ± {:.1} mm; RK4, steps of {STEP} s\n", 1e3 * TOLERANCE);

    common::heads(&[("run", 24), ("pendulums/s", 12), ("share of the first", 18)]);
    let mut first = None;
    let mut timed = |name: &str, way: &dyn Fn() -> Result<Vec<Tips<f64>>, Error>| {
        let clock = Instant::now();
        let found = way()?;
        let time = clock.elapsed().as_secs_f64();
        let share = time / *first.get_or_insert(time);
        println!("  {name:>24}  {:12.0}  {share:18.2}", count as f64 / time);
        Ok::<_, Error>(found)
    };
    let one = timed("one by one", &|| lengths.iter().map(|pair| run(*pair)).collect())?;
    let threads = timed("on all threads", &|| ensemble(&lengths).run(|pair| run(*pair)).into_iter().collect())?;
    let both = timed("in lanes, on all threads", &|| ensemble(&lengths).run_in_lanes(four).into_iter().collect())?;
    if one != threads || one != both {
        return Err("lanes, threads and a loop differ".into());
    }
    println!("\nAll three find the same places, bit by bit.\n");

    common::heads(&[("time (s)", 8), ("mean tip x (m)", 14), ("mean tip y (m)", 14), ("scatter (mm)", 12)]);
    for instant in (1..INSTANTS).step_by(2) {
        let ([x, y], off) = scatter(&both, instant);
        println!("  {:8.2}  {x:14.4}  {y:14.4}  {:12.2}", APART * (instant + 1) as f64, 1e3 * off);
    }
    println!("\nPicture: {}", draw(&both)?.display());
    Ok(())
}

/// Tips at four instants on the left, their scatter over time on the right.
fn draw(all: &[Tips<f64>]) -> Drawn<PathBuf> {
    common::picture("lanes_and_threads", (1000, 560), |area| {
        let subtitle = format!(
            "{} double pendulums let go alike, their rods 1 m ± 1 mm: after six seconds nobody can tell where a tip is.",
            all.len()
        );
        let area = common::heading(area, "The same pendulum, made many times", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(500.0));
        let mut places = common::chart(&left, "Tips, x and y (m)", "", -2.2..2.2, -2.4..2.0)?;
        let instants = [(3, "1 s", GREY), (9, "2.5 s", BLUE), (15, "4 s", GREEN), (23, "6 s", ORANGE)];
        for (instant, _, colour) in instants {
            let tips = all.iter().take(2000).map(|tips| (tips[instant][0], tips[instant][1]));
            common::dots(&mut places, tips, 2.2, colour)?;
        }
        common::legend(&left, &instants.map(|(_, name, colour)| (name, colour)))?;

        let points: Vec<_> =
            (0..INSTANTS).map(|k| (APART * (k + 1) as f64, (1e3 * scatter(all, k).1).log10())).collect();
        let mut grown = common::powers(&right, "Scatter of the tips (mm)", "time (s)", 0.0..6.0, 0.0..4.0)?;
        common::curve(&mut grown, points.iter().copied(), line(BLUE, 1.8))?;
        common::dots(&mut grown, points, 3.0, BLUE)
    })
}
