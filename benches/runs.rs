//! What a run costs beside its sweeps: instructions and time per body and sweep, of sweeps alone and of whole runs, in one program.
//!
//! Chains of rods of together 1 m and 1 kg, released at rest from angles that are nothing special: two in a tuple on a pin, twenty in an
//! array on a wall. `cargo bench --bench runs` measures this build; `benches/count.sh runs` builds for the default target and for
//! x86-64-v3 and prints both.

#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/count.rs"]
mod count;

use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::Dynamics;
use clock::{median, progress};
use count::{count, has_valgrind};
use std::collections::HashMap;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Rounds in which rows take turns.
const ROUNDS: usize = 41;

struct Row {
    form: &'static str,
    bodies: usize,
    /// Sweeps alone, or the rule of a run.
    what: &'static str,
    /// Goes on for a number of units and tells how many sweeps that took.
    go: fn(usize) -> usize,
}

impl Row {
    fn name(&self) -> String {
        format!("{}/{}/{}", self.form, self.bodies, self.what).replace(' ', "-")
    }
    fn is_sweep(&self) -> bool {
        self.what == "sweep"
    }
}

/// A chain: its sweeps, and its runs by rules, each for as long (s) as so many units of it say.
macro_rules! rows {
    ($form:literal $n:literal, $root:expr, |$rod:ident| $chain:expr; $($what:literal: $unit:literal $rule:expr),*) => {
        [
            Row {
                form: $form,
                bodies: $n,
                what: "sweep",
                go: |units| {
                    let ($rod, times) = (rod($n), units * 1000);
                    let scene = System::new($root, $chain, Free).unwrap().with_gravity(9.81);
                    let motion = scene.at_rest(&ANGLES[..$n]).unwrap();
                    let (mut workspace, mut acceleration) = (Dynamics::<Unloaded>::workspace(&scene), motion.rate().clone());
                    for _ in 0..times {
                        let (position, rate) = black_box((motion.position(), motion.rate()));
                        scene.accelerations(0.0, position, rate, &Unloaded, &mut workspace, black_box(&mut acceleration));
                    }
                    times
                },
            },
            $(Row {
                form: $form,
                bodies: $n,
                what: $what,
                go: |units| {
                    let $rod = rod($n);
                    let scene = System::new($root, $chain, Free).unwrap().with_gravity(9.81);
                    let start = scene.at_rest(&ANGLES[..$n]).unwrap();
                    scene.simulate(start, $rule, $unit * units as f64, |now| _ = black_box(now.time())).unwrap().sweeps
                },
            }),*
        ]
    };
}

const ANGLES: [f64; 20] = [
    -0.3, -0.6, -0.2, 0.1, -0.4, -0.9, -0.5, -0.1, -0.7, -0.3, 0.2, -0.2, -0.6, -0.8, -0.4, -0.1, -0.5, -0.3, 0.0, -0.2,
];

fn rod(n: usize) -> Rod<f64> {
    let share = 1.0 / n as f64;
    Rod::uniform(share, share)
}

fn rows() -> Vec<Row> {
    let two = rows!("tuple" 2, Pinned::<[f64; 2]>::origin(), |rod| (rod, Pin, rod);
        "RK4": 1.0 Rk4::step(0.005), "Dopri5": 1.0 Dopri5::tolerance(1e-6), "DOP853": 4.0 Dop853::tolerance(1e-9), "Vcabm": 4.0 Vcabm::new().tolerance(1e-9));
    let twenty = rows!("array" 20, Clamped::at(0.0, 0.0, 0.0), |rod| [(Pin, rod); 20];
        "RK4": 0.25 Rk4::step(0.001), "Dopri5": 0.25 Dopri5::tolerance(1e-6), "DOP853": 0.25 Dop853::tolerance(1e-9), "Vcabm": 0.25 Vcabm::new().tolerance(1e-9));
    two.into_iter().chain(twenty).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rows = rows();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["repeat", name, units] => {
            let units = units.parse()?;
            rows.iter().filter(|row| row.name() == name).for_each(|row| _ = black_box((row.go)(units)));
        }
        ["wall", ..] => rows.iter().zip(wall(&rows)).for_each(|(row, ns)| println!("{}\t{ns}", row.name())),
        ["--against", other] => table(&rows, Some(Path::new(other)))?,
        _ => table(&rows, None)?, // cargo hands arguments of its own
    }
    Ok(())
}

/// Nanoseconds per body and sweep of each row: rows take turns, so that a disturbance of the machine hits all of them.
fn wall(rows: &[Row]) -> Vec<f64> {
    let mut samples = vec![Vec::new(); rows.len()];
    for round in 0..ROUNDS {
        progress(&format!("wall time, round {} of {ROUNDS}", round + 1));
        for (row, samples) in rows.iter().zip(&mut samples) {
            let start = Instant::now();
            let sweeps = (row.go)(1);
            samples.push(start.elapsed().as_nanos() as f64 / (sweeps * row.bodies) as f64);
        }
    }
    progress("");
    samples.iter_mut().map(|samples| median(samples)).collect()
}

/// Instructions per body and sweep of a row: what a longer run adds to a shorter one, so that start and construction cancel.
fn instructions(program: &Path, row: &Row) -> Result<f64, String> {
    let counted = |units: usize| count(program, &["repeat", &row.name(), &units.to_string()]);
    let added = (row.go)(3) - (row.go)(1);
    Ok((counted(3)? - counted(1)?) as f64 / (added * row.bodies) as f64)
}

/// A table in Markdown, one build after the other.
fn table(rows: &[Row], other: Option<&Path>) -> Result<(), Box<dyn std::error::Error>> {
    let this: PathBuf = std::env::current_exe()?;
    let mut builds = vec![(if other.is_some() { "default" } else { "this build" }, this, wall(rows))];
    if let Some(other) = other {
        let output = Command::new(other).arg("wall").output()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let pairs = text.lines().filter_map(|line| line.split_once('\t'));
        let by_name: HashMap<&str, f64> = pairs.filter_map(|(name, ns)| Some((name, ns.parse().ok()?))).collect();
        let ns = rows.iter().map(|row| by_name.get(row.name().as_str()).copied().unwrap_or(f64::NAN)).collect();
        builds.push(("x86-64-v3", other.to_owned(), ns));
    }
    println!("Per body and sweep; a run's figures stand beside those of the sweep alone.\n");
    println!(
        "| target | form | n | what | instructions | : sweep | ns | : sweep |\n|---|---|---:|---|---:|---:|---:|---:|"
    );
    for (target, program, ns) in builds {
        let mut alone = [f64::NAN; 2];
        for (row, ns) in rows.iter().zip(ns) {
            progress(&format!("instructions, {target}: {}", row.name()));
            let instructions = if has_valgrind() { instructions(&program, row)? } else { f64::NAN };
            if row.is_sweep() {
                alone = [instructions, ns];
            }
            progress("");
            let [times, longer] = [instructions / alone[0], ns / alone[1]];
            let Row { form, bodies, what, .. } = row;
            println!(
                "| {target} | {form} | {bodies} | {what} | {instructions:.1} | {times:.2} | {ns:.1} | {longer:.2} |"
            );
        }
    }
    Ok(())
}
