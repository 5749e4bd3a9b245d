//! Run time and sweeps against error: every explicit rule, with fixed steps and with error control, in single and
//! double precision.
//!
//! Chains of n uniform rods of together 1 m and 1 kg, joined by pins and released at rest from the horizontal, where the error is that of
//! the last rod's angle at the end; and round rods of a tenth of their length in radius on balls, the first turning at 1 and 2 rad/s
//! about its own x and y, where it is that of the tip's height.
//!
//! `cargo bench --bench work_precision` prints what it takes to reach an error, and writes every run to
//! `target/bench/work_precision.csv` and a diagram to `target/bench/work_precision.svg`. Runs of other libraries that
//! `benches/rivals/rivals.py` left in `target/bench/rivals.csv` stand in both.

#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/diagram.rs"]
mod diagram;

use catena::Real;
use catena::planar::*;
use catena::spatial;
use clock::{median, progress};
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
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
    /// Whose it is, if not Catena's.
    rival: Option<String>,
    rule: String,
    control: &'static str,
    scalar: &'static str,
    points: Vec<Point>,
}

/// A chain and what is known of its motion.
pub struct Scene {
    name: &'static str,
    bodies: usize,
    end: f64,
    /// Absolute angle of the last rod at the end (rad), a Taylor series of 30 digits; height of the tip (m), on which DOP853 at 1e-14 and
    /// another library agree.
    reference: f64,
    /// What it is.
    unit: &'static str,
    series: Vec<Series>,
}

impl Series {
    fn name(&self) -> String {
        match &self.rival {
            Some(rival) => format!("{rival}, {}", self.rule),
            None => format!("{} {} {}", self.rule, self.control, self.scalar),
        }
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

/// Runs all rules in one precision and adds their series to a scene: `$read` tells of a system and a motion what the error is of.
macro_rules! run_rules {
    ($scene:ident, $T:ident, $steps:expr, $tolerances:expr, ($system:expr, $start:expr), |$own:ident, $motion:ident| $read:expr) => {{
        let (system, start) = ($system, $start);
        macro_rules! add {
            ($name:literal $control:literal, $parameters:expr, $rule:expr) => {{
                let mut points = Vec::new();
                for parameter in $parameters {
                    progress(&format!("{}: {} {} {}, {parameter:.1e}", $scene.name, $name, $control, stringify!($T)));
                    points.push(measure(parameter, $scene.reference, &mut || {
                        let start = black_box(start.clone());
                        let run = system.simulate(start, $rule(parameter as $T), $scene.end as $T, |_| ()).ok()?;
                        let ($own, $motion) = (&system, &run.motion);
                        Some((run.sweeps, $read?))
                    }));
                }
                let (rule, scalar) = ($name.to_owned(), stringify!($T));
                $scene.series.push(Series { rival: None, rule, control: $control, scalar, points });
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

/// The same for a chain of rods on pins.
macro_rules! run_pins {
    ($scene:ident, $T:ident, $steps:expr, $tolerances:expr, |$rod:ident| $chain:expr) => {{
        let share = (1.0 / $scene.bodies as f64) as $T;
        let $rod = Rod::uniform(share, share);
        let system = System::new(Pinned::origin(), $chain, Free)?.with_gravity(9.81 as $T);
        let start = system.at_rest(&vec![0.0; $scene.bodies])?;
        let last = $scene.bodies - 1;
        run_rules!($scene, $T, $steps, $tolerances, (system, start), |system, motion| {
            system.angles(motion).unwrap().get(last).map(|angle| angle.as_f64())
        });
    }};
}

/// And for rods on balls.
macro_rules! run_balls {
    ($scene:ident, $T:ident, $steps:expr, $tolerances:expr, |$rod:ident| $chain:expr) => {{
        let share = (1.0 / $scene.bodies as f64) as $T;
        let $rod = spatial::Rod::uniform(share, share / 10.0, share);
        let system = spatial::System::new(spatial::Pinned::origin(), $chain, spatial::Free)?.with_gravity([
            0.0,
            -9.81 as $T,
            0.0,
        ]);
        let start = system.at_rest(&vec![0.0; 3 * $scene.bodies])?;
        let mut rates = vec![0.0; 3 * $scene.bodies];
        (rates[0], rates[1]) = (1.0, 2.0);
        let start = system.with_rates(start, &rates)?;
        run_rules!($scene, $T, $steps, $tolerances, (system, start), |system, motion| {
            system.body_motions(motion).unwrap().iter().last().map(|body| body.outboard().place.y.as_f64())
        });
    }};
}

/// Runs of other libraries, if they are there.
fn rivals(path: &Path, scenes: &mut [Scene]) {
    let Ok(text) = fs::read_to_string(path) else { return };
    for line in text.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [name, library, rule, parameter, error, seconds] = fields[..] else { continue };
        let Some(scene) = scenes.iter_mut().find(|scene| scene.name == name) else { continue };
        let (Ok(parameter), Ok(error), Ok(seconds)) = (parameter.parse(), error.parse(), seconds.parse()) else {
            continue;
        };
        let point = Point { parameter, sweeps: 0, error, seconds };
        let own = |series: &&mut Series| series.rival.as_deref() == Some(library) && series.rule == rule;
        match scene.series.iter_mut().find(own) {
            Some(series) => series.points.push(point),
            None => scene.series.push(Series {
                rival: Some(library.to_owned()),
                rule: rule.to_owned(),
                control: "",
                scalar: "f64",
                points: vec![point],
            }),
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let scene = |name, bodies, end, reference, unit| Scene { name, bodies, end, reference, unit, series: Vec::new() };
    let mut two = scene("2 rods on pins", 2, 2.0, -0.9071302549910606, "rad");
    let mut twenty = scene("20 rods on pins", 20, 0.5, -3.0330002988365, "rad");
    let mut balls = scene("3 rods on balls", 3, 2.0, -0.28230043053974, "m");
    let ratio = 0.5_f64.sqrt();
    {
        let steps = |size: f64| ladder(0.02 * size, 1e-4 * size, ratio);
        run_pins!(two, f64, steps, ladder(1e-2, 1e-13, 0.1), |rod| (rod, Pin, rod));
        run_pins!(two, f32, steps, ladder(1e-2, 1e-7, 0.1), |rod| (rod, Pin, rod));
    }
    {
        let steps = |size: f64| ladder(0.002 * size, 1e-5 * size, ratio);
        run_pins!(twenty, f64, steps, ladder(1e-2, 1e-13, 0.1), |rod| (rod, [(Pin, rod); 19]));
        run_pins!(twenty, f32, steps, ladder(1e-2, 1e-7, 0.1), |rod| (rod, [(Pin, rod); 19]));
    }
    {
        let steps = |size: f64| ladder(0.02 * size, 1e-4 * size, ratio);
        let rods = |rod| (rod, spatial::Ball, rod, spatial::Ball, rod);
        run_balls!(balls, f64, steps, ladder(1e-2, 1e-13, 0.1), |rod| rods(rod));
    }
    progress("");
    let mut scenes = [two, twenty, balls];
    let directory = PathBuf::from(std::env::var_os("CARGO_TARGET_DIR").unwrap_or("target".into())).join("bench");
    fs::create_dir_all(&directory)?;
    rivals(&directory.join("rivals.csv"), &mut scenes);
    fs::write(directory.join("work_precision.csv"), csv(&scenes))?;
    diagram::draw(&directory.join("work_precision.svg"), &scenes)?;
    scenes.iter().for_each(print);
    println!("\nEvery run and the diagram are in {}.", directory.display());
    Ok(())
}

fn csv(scenes: &[Scene]) -> String {
    let mut text = "scene,library,rule,control,scalar,step_or_tolerance,sweeps,error,seconds\n".to_owned();
    for scene in scenes {
        for Series { rival, rule, control, scalar, points } in &scene.series {
            let library = rival.as_deref().unwrap_or("Catena");
            for Point { parameter, sweeps, error, seconds } in points {
                let how = format!("{library},{rule},{control},{scalar},{parameter:e}");
                text += &format!("{},{how},{sweeps},{error:e},{seconds:e}\n", scene.name);
            }
        }
    }
    text
}

/// What it takes to reach an error, as a table in Markdown.
fn print(scene: &Scene) {
    println!("\n{}, {} s: milliseconds to an error, and nanoseconds per body and sweep\n", scene.name, scene.end);
    let levels: String = LEVELS.iter().map(|level| format!(" {level:.0e} {} |", scene.unit)).collect();
    println!("| rule |{levels} ns |\n|---|{}---:|", "---:|".repeat(LEVELS.len()));
    for series in &scene.series {
        let mut line = format!("| {} |", series.name());
        for level in LEVELS {
            line += &series.time_to(level).map_or(" – |".to_owned(), |time| format!(" {:.3} |", time * 1e3));
        }
        if series.rival.is_some() {
            println!("{line} |");
            continue;
        }
        let per_sweep = |point: &Point| point.seconds * 1e9 / (point.sweeps * scene.bodies) as f64;
        let mut costs: Vec<f64> = series.points.iter().rev().take(5).map(per_sweep).collect();
        println!("{line} {:.1} |", median(&mut costs));
    }
}
