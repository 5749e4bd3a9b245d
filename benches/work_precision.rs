//! Run time and sweeps against error: every explicit rule, with fixed steps and with error control, in single and
//! double precision.
//!
//! Chains of n uniform rods of together 1 m and 1 kg, joined by pins and released at rest from the horizontal; the
//! error is that of the last rod's angle at the end.
//!
//! `cargo bench --bench work_precision` prints what it takes to reach an error, and writes every run to
//! `target/bench/work_precision.csv` and a diagram to `target/bench/work_precision.svg`.

#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/diagram.rs"]
mod diagram;

use catena::Real;
use catena::planar::*;
use clock::{median, progress};
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How long a run is repeated for its median time.
const BUDGET: Duration = Duration::from_millis(30);
/// Errors (rad) for the table.
const LEVELS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// One run.
pub struct Point {
    /// Step (s) or tolerance.
    parameter: f64,
    sweeps: usize,
    error: f64,
    seconds: f64,
}

/// The runs of a rule, from coarse to fine.
pub struct Series {
    rule: &'static str,
    control: &'static str,
    scalar: &'static str,
    points: Vec<Point>,
}

/// A chain and what is known of its motion.
pub struct Scene {
    name: &'static str,
    bodies: usize,
    end: f64,
    /// Absolute angle of the last rod at the end (rad): a Taylor series of 30 digits.
    reference: f64,
    series: Vec<Series>,
}

impl Series {
    fn name(&self) -> String {
        format!("{} {} {}", self.rule, self.control, self.scalar)
    }

    /// The least time (s) of a run with an error below `level`, if the next finer one is below it too: an error may
    /// vanish by chance where it changes sign.
    fn time_to(&self, level: f64) -> Option<f64> {
        let pairs = self.points.iter().zip(self.points.iter().skip(1));
        let exact = pairs.filter(|(point, finer)| point.error <= level && finer.error <= level);
        exact.map(|(point, _)| point.seconds).min_by(f64::total_cmp)
    }
}

/// Repeats a run that yields its sweeps and the angle reached; NaN for one that fails.
fn measure(parameter: f64, reference: f64, run: &mut dyn FnMut() -> Option<(usize, f64)>) -> Point {
    let (start, mut times) = (Instant::now(), Vec::new());
    let mut outcome = None;
    while times.len() < 3 || (start.elapsed() < BUDGET && times.len() < 1000) {
        let one = Instant::now();
        outcome = run();
        times.push(one.elapsed().as_secs_f64());
    }
    let (sweeps, angle) = outcome.unwrap_or((0, f64::NAN));
    Point { parameter, sweeps, error: (angle - reference).abs(), seconds: median(&mut times) }
}

/// Values from `coarse` down to `fine`, each a share `ratio` of the one before.
fn ladder(coarse: f64, fine: f64, ratio: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(coarse), move |value| Some(value * ratio)).take_while(move |value| *value >= 0.99 * fine)
}

/// Runs all rules in one precision and adds their series to a scene.
macro_rules! run_rules {
    ($scene:ident, $T:ident, $steps:expr, $tolerances:expr, |$rod:ident| $chain:expr) => {{
        let share = (1.0 / $scene.bodies as f64) as $T;
        let $rod = Rod::uniform(share, share);
        let system = System::new(Pinned::origin(), $chain, Free)?.with_gravity(9.81 as $T);
        let start = system.at_rest(&vec![0.0; $scene.bodies])?;
        macro_rules! add {
            ($name:literal $control:literal, $parameters:expr, $rule:expr) => {{
                let mut points = Vec::new();
                for parameter in $parameters {
                    progress(&format!("{}: {} {} {}, {parameter:.1e}", $scene.name, $name, $control, stringify!($T)));
                    points.push(measure(parameter, $scene.reference, &mut || {
                        let start = black_box(start.clone());
                        let run = system.simulate(start, $rule(parameter as $T), $scene.end as $T, |_| ()).ok()?;
                        let angle = system.angles(&run.motion).get($scene.bodies - 1)?.as_f64();
                        Some((run.sweeps, angle))
                    }));
                }
                $scene.series.push(Series { rule: $name, control: $control, scalar: stringify!($T), points });
            }};
        }
        add!("Rk4" "fixed", $steps(1.0), Rk4::step);
        add!("Dopri5" "fixed", $steps(2.0), Dopri5::step);
        add!("Dopri5" "controlled", $tolerances, Dopri5::tolerance);
        add!("Adams" "fixed", $steps(1.0), Adams::step);
        add!("Adams" "controlled", $tolerances, Adams::tolerance);
        add!("Dop853" "fixed", $steps(4.0), Dop853::step);
        add!("Dop853" "controlled", $tolerances, Dop853::tolerance);
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut two = Scene { name: "n = 2", bodies: 2, end: 2.0, reference: -0.9071302549910606, series: Vec::new() };
    let mut twenty = Scene { name: "n = 20", bodies: 20, end: 0.5, reference: -3.0330002988365, series: Vec::new() };
    let ratio = 0.5_f64.sqrt();
    {
        let steps = |size: f64| ladder(0.02 * size, 1e-4 * size, ratio);
        run_rules!(two, f64, steps, ladder(1e-2, 1e-13, 0.1), |rod| (rod, Pin, rod));
        run_rules!(two, f32, steps, ladder(1e-2, 1e-7, 0.1), |rod| (rod, Pin, rod));
    }
    {
        let steps = |size: f64| ladder(0.002 * size, 1e-5 * size, ratio);
        run_rules!(twenty, f64, steps, ladder(1e-2, 1e-13, 0.1), |rod| (rod, [(Pin, rod); 19]));
        run_rules!(twenty, f32, steps, ladder(1e-2, 1e-7, 0.1), |rod| (rod, [(Pin, rod); 19]));
    }
    progress("");
    let scenes = [two, twenty];
    let directory = PathBuf::from(std::env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into())).join("bench");
    fs::create_dir_all(&directory)?;
    fs::write(directory.join("work_precision.csv"), csv(&scenes))?;
    diagram::draw(&directory.join("work_precision.svg"), &scenes)?;
    scenes.iter().for_each(print);
    println!("\nEvery run and the diagram are in {}.", directory.display());
    Ok(())
}

fn csv(scenes: &[Scene]) -> String {
    let mut text = "scene,rule,control,scalar,step_or_tolerance,sweeps,error_rad,seconds\n".to_owned();
    for scene in scenes {
        for Series { rule, control, scalar, points } in &scene.series {
            for Point { parameter, sweeps, error, seconds } in points {
                text +=
                    &format!("{},{rule},{control},{scalar},{parameter:e},{sweeps},{error:e},{seconds:e}\n", scene.name);
            }
        }
    }
    text
}

/// What it takes to reach an error, as a table in Markdown.
fn print(scene: &Scene) {
    println!(
        "\n{} rods, {} s: milliseconds to an error, and nanoseconds per body and sweep\n",
        scene.bodies, scene.end
    );
    let levels: String = LEVELS.iter().map(|level| format!(" {level:.0e} rad |")).collect();
    println!("| rule |{levels} ns |\n|---|{}---:|", "---:|".repeat(LEVELS.len()));
    for series in &scene.series {
        let mut line = format!("| {} |", series.name());
        for level in LEVELS {
            line += &series.time_to(level).map_or(" – |".to_owned(), |time| format!(" {:.3} |", time * 1e3));
        }
        let per_sweep = |point: &Point| point.seconds * 1e9 / (point.sweeps * scene.bodies) as f64;
        let mut costs: Vec<f64> = series.points.iter().rev().take(5).map(per_sweep).collect();
        println!("{line} {:.1} |", median(&mut costs));
    }
}
