//! What derivatives of a run cost: a step with derivatives beside a plain one.
//!
//! `cargo bench --bench sensitivity` measures instructions and time of steps of RK4 (yardstick A, 1 ms) for all initial values and for
//! parameters: through kept gains, by the rule itself over the same numbers, and over those of `num-dual`. Rods on balls in space besides, and
//! a crane whose cart slides: arrays of many derivatives are what compilers like to copy.

#[path = "parts/clock.rs"]
mod clock;

use catena::planar::*;
use catena::scalar::Jet;
use catena::simulate::Stepper;
use catena::system::{Position, Rate};
use catena::{Error, Motion, Scalar};
use clock::{median, progress};
use num_dual::DualSVec64;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Steps of a motion.
type Case = Box<dyn FnMut(usize) -> f64>;

struct Row {
    bodies: usize,
    /// What is differentiated by.
    seeds: &'static str,
    /// How.
    way: &'static str,
    /// How many such runs give all derivatives.
    runs: usize,
    make: fn() -> Result<Case, Error>,
}

impl Row {
    fn name(&self) -> String {
        format!("{}/{}/{}", self.bodies, self.seeds, self.way)
    }
}

/// A number with seeds.
trait Seeded: Scalar<Real = f64> {
    fn seed(value: f64, k: usize) -> Self;
}

impl Seeded for f64 {
    fn seed(value: f64, _: usize) -> f64 {
        value
    }
}
impl<const K: usize> Seeded for Jet<f64, K> {
    fn seed(value: f64, k: usize) -> Self {
        Jet::seed(value, k)
    }
}
impl<const K: usize> Seeded for DualSVec64<K> {
    fn seed(value: f64, k: usize) -> Self {
        let constant = Self::from_re(value);
        if k < K { constant.derivative(k) } else { constant }
    }
}

/// Rod `i` of `n`, released from the horizontal; lengths, masses, centres and moments of inertia of the first two are seeds in this
/// order, if parameters are.
fn rod<T: Seeded>(i: usize, n: usize, parameters: bool) -> Rod<T> {
    let share = black_box(1.0 / n as f64);
    let own = |kind: usize| if parameters && i < 2 { 2 * kind + i } else { usize::MAX };
    let values = [share, share, 0.5 * share, share * share * share / 12.0];
    let [length, mass, centre, inertia] = core::array::from_fn(|kind| T::seed(values[kind], own(kind)));
    Rod::new(length, mass, centre, inertia)
}

/// A motion at rest with seeds in its state: displacements, then rates.
fn with_seeds<T: Seeded, P: Position<T>>(mut motion: Motion<T, P>) -> Motion<T, P> {
    let mut number = 0;
    let mut seed = |x: T| {
        number += 1;
        T::seed(x.real(), number - 1)
    };
    let mut step = motion.rate().clone();
    step.replace(&mut seed);
    motion.position_mut().displace(&step);
    motion.rate_mut().replace(&mut seed);
    motion
}

/// A chain of `N` rods, all but the first in an array.
macro_rules! case {
    ($N:literal, $T:ty, $parameters:literal $(, $through:ident)?) => {
        || {
            let first = rod::<$T>(0, $N, $parameters);
            let others: [_; $N - 1] = core::array::from_fn(|i| (Pin, rod::<$T>(i + 1, $N, $parameters)));
            let system = System::new(Pinned::origin(), (first, others), Free)?.with_gravity(<$T>::literal(9.81));
            let start = system.at_rest(&[<$T>::literal(0.0); $N])?;
            let start = if $parameters { start } else { with_seeds(start) };
            let past = system.with_accelerations(start, &Unloaded)?;
            case!(steps system past $($through)?)
        }
    };
    (steps $system:ident $past:ident $($through:ident)?) => {{
        let (system, mut past) = ($system, $past);
        // The stepper borrows the scene for as long as the case lives.
        let system = Box::leak(Box::new(system));
        let mut stepper = system.stepper(case!(rule $($through)?));
        let mut next = past.clone();
        let case: Case = Box::new(move |steps| {
            for _ in 0..steps {
                if let Err(error) = stepper.advance(&past, &Unloaded, 1e-3, &mut next) {
                    eprintln!("{error}");
                }
                core::mem::swap(&mut past, &mut next);
            }
            let mut sum = 0.0;
            Position::visit(past.position(), &mut |x| sum += Scalar::real(x));
            sum
        });
        Ok(case)
    }};
    (rule) => { Rk4 };
    (rule through) => { catena::sensitivity::ThroughGains(Rk4) };
}

/// Three rods on balls.
macro_rules! in_space {
    ($T:ty, $parameters:literal $(, $through:ident)?) => {
        || {
            use catena::spatial::{Ball, Free, Pinned, Rod, System};
            let share = black_box(1.0 / 3.0);
            let of = |value: f64, k: usize| <$T as Seeded>::seed(value, if $parameters { k } else { usize::MAX });
            let rod = Rod::uniform(of(share, 0), of(0.1 * share, 1), of(share, 2));
            let system = System::new(Pinned::origin(), (rod, Ball, rod, Ball, rod), Free)?.with_gravity([<$T>::literal(0.0), -of(9.81, 3), <$T>::literal(0.0)]);
            let angles: [$T; 9] = core::array::from_fn(|i| <$T>::literal(0.1 * i as f64));
            let start = system.at_rest(&angles)?;
            let start = if $parameters { start } else { with_seeds(start) };
            let past = system.with_accelerations(start, &Unloaded)?;
            case!(steps system past $($through)?)
        }
    };
}

/// A cart on a track and two rods below it.
macro_rules! on_a_track {
    ($T:ty) => {
        || {
            let [cart, upper, lower] = core::array::from_fn(|i| rod::<$T>(i, 3, true));
            let [zero, slope] = [0.0, 0.1].map(|x| <$T>::literal(black_box(x)));
            let chain = (Slider::along(slope), cart, Pin, upper, Pin, lower);
            let system = System::new(Clamped::at(zero, zero, zero), chain, Free)?.with_gravity(<$T>::literal(9.81));
            let start = system.at_rest(&[zero; 2])?;
            let past = system.with_accelerations(start, &Unloaded)?;
            case!(steps system past)
        }
    };
}

fn rows() -> Vec<Row> {
    let mut rows = vec![];
    macro_rules! row {
        ($n:literal, $seeds:literal, $runs:literal, $way:literal, $($case:tt)*) => {
            rows.push(Row { bodies: $n, seeds: $seeds, way: $way, runs: $runs, make: case!($n, $($case)*) });
        };
    }
    row!(2, "none", 1, "plain", f64, false);
    row!(2, "state", 1, "gains", Jet<f64, 4>, false, through);
    row!(2, "state", 1, "jets", Jet<f64, 4>, false);
    row!(2, "state", 1, "num-dual", DualSVec64<4>, false);
    row!(2, "1 parameter", 1, "gains", Jet<f64, 1>, true, through);
    row!(2, "1 parameter", 1, "jets", Jet<f64, 1>, true);
    row!(2, "1 parameter", 1, "num-dual", DualSVec64<1>, true);
    row!(2, "4 parameters", 1, "gains", Jet<f64, 4>, true, through);
    row!(2, "4 parameters", 1, "jets", Jet<f64, 4>, true);
    row!(2, "4 parameters", 1, "num-dual", DualSVec64<4>, true);
    row!(2, "8 parameters", 1, "gains", Jet<f64, 8>, true, through);
    row!(2, "8 parameters", 1, "jets", Jet<f64, 8>, true);
    row!(2, "8 parameters", 1, "num-dual", DualSVec64<8>, true);
    macro_rules! space {
        ($seeds:literal, $runs:literal, $way:literal, $($case:tt)*) => {
            rows.push(Row { bodies: 3, seeds: $seeds, way: $way, runs: $runs, make: in_space!($($case)*) });
        };
    }
    space!("none", 1, "plain", f64, false);
    space!("state, in space", 1, "gains, 18", Jet<f64, 18>, false, through);
    space!("state, in space", 3, "gains, 6", Jet<f64, 6>, false, through);
    space!("state, in space", 3, "jets, 6", Jet<f64, 6>, false);
    space!("state, in space", 3, "num-dual, 6", DualSVec64<6>, false);
    space!("4 parameters, in space", 1, "gains", Jet<f64, 4>, true, through);
    space!("4 parameters, in space", 1, "jets", Jet<f64, 4>, true);
    space!("4 parameters, in space", 1, "num-dual", DualSVec64<4>, true);
    macro_rules! track {
        ($seeds:literal, $way:literal, $T:ty) => {
            rows.push(Row { bodies: 3, seeds: $seeds, way: $way, runs: 1, make: on_a_track!($T) });
        };
    }
    track!("none, on a track", "plain", f64);
    track!("5 parameters, on a track", "jets", Jet<f64, 5>);
    track!("8 parameters, on a track", "jets", Jet<f64, 8>);
    track!("16 parameters, on a track", "jets", Jet<f64, 16>);
    row!(20, "none", 1, "plain", f64, false);
    row!(20, "state", 1, "gains, 40", Jet<f64, 40>, false, through);
    row!(20, "state", 2, "gains, 20", Jet<f64, 20>, false, through);
    row!(20, "state", 5, "gains, 8", Jet<f64, 8>, false, through);
    row!(20, "state", 5, "jets, 8", Jet<f64, 8>, false);
    row!(20, "state", 3, "jets, 16", Jet<f64, 16>, false);
    row!(20, "state", 10, "num-dual, 4", DualSVec64<4>, false);
    row!(20, "state", 5, "num-dual, 8", DualSVec64<8>, false);
    row!(20, "1 parameter", 1, "gains", Jet<f64, 1>, true, through);
    row!(20, "1 parameter", 1, "jets", Jet<f64, 1>, true);
    row!(20, "1 parameter", 1, "num-dual", DualSVec64<1>, true);
    row!(20, "4 parameters", 1, "gains", Jet<f64, 4>, true, through);
    row!(20, "4 parameters", 1, "jets", Jet<f64, 4>, true);
    row!(20, "4 parameters", 1, "num-dual", DualSVec64<4>, true);
    row!(20, "8 parameters", 1, "gains", Jet<f64, 8>, true, through);
    row!(20, "8 parameters", 1, "jets", Jet<f64, 8>, true);
    row!(20, "8 parameters", 1, "num-dual", DualSVec64<8>, true);
    rows
}

/// Instructions of a step: what further steps add to a run of `program`.
fn instructions(program: &Path, row: &Row) -> Option<f64> {
    let count = |steps: usize| -> Option<f64> {
        let output = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(program)
            .args(["repeat", &row.name(), &steps.to_string()])
            .output()
            .ok()?;
        if !output.status.success() {
            return None; // it may not know an instruction
        }
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        text.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok())
    };
    Some((count(22)? - count(2)?) / 20.0)
}

/// Nanoseconds of a step of each row: rows take turns.
fn wall(rows: &[Row]) -> Result<Vec<f64>, Error> {
    let mut entries =
        rows.iter().map(|row| Ok(((row.make)()?, vec![]))).collect::<Result<Vec<(Case, Vec<f64>)>, Error>>()?;
    for round in 0..31 {
        progress(&format!("wall time, round {} of 31", round + 1));
        for (case, samples) in &mut entries {
            black_box(case(2));
            let start = Instant::now();
            black_box(case(50));
            samples.push(start.elapsed().as_nanos() as f64 / 50.0);
        }
    }
    progress("");
    Ok(entries.iter_mut().map(|(_, samples)| median(samples)).collect())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rows = rows();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let ["repeat", name, steps] = arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        if let Some(row) = rows.iter().find(|row| row.name() == name) {
            black_box((row.make)()?(steps.parse()?));
        }
        return Ok(());
    }
    let program = std::env::current_exe()?;
    let counts: Vec<f64> = rows.iter().map(|row| instructions(&program, row).unwrap_or(f64::NAN)).collect();
    let times = wall(&rows)?;
    println!("| n | derivatives by | way | runs | instructions a step | : plain | µs a step | : plain |");
    println!("|---:|---|---|---:|---:|---:|---:|---:|");
    for (i, row) in rows.iter().enumerate() {
        let plain = rows[..=i].iter().rposition(|other| other.way == "plain").unwrap_or(i);
        let runs = row.runs as f64;
        let (count, time) = (runs * counts[i], runs * times[i]);
        println!(
            "| {} | {} | {} | {} | {count:.0} | {:.2} | {:.2} | {:.2} |",
            row.bodies,
            row.seeds,
            row.way,
            row.runs,
            count / counts[plain],
            time * 1e-3,
            time / times[plain]
        );
    }
    Ok(())
}
