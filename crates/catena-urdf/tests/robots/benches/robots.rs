//! What forward dynamics under torques and functions of lists of the shipped robots cost: instructions a call, counted by callgrind
//! (valgrind).
//!
//! `bash benches/count.sh robots` counts for the default target and for x86-64-v3; with `--check` it compares with
//! benches/results/robot_counts.csv, with `--record` it writes that file.

#[path = "../../../../../benches/parts/count.rs"]
mod count;
#[path = "parts/functions.rs"]
mod functions;
#[path = "parts/record.rs"]
mod record;
#[path = "parts/sweeps.rs"]
mod sweeps;

use count::{count, has_valgrind};
use record::Counted;
use std::error::Error;
use std::path::{Path, PathBuf};

/// Calls of each of two counts, whose difference is shared out.
const CALLS: [usize; 2] = [100, 600];
/// What counts are compared with.
const RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../../benches/results/robot_counts.csv");

/// A robot, and what it is asked: a sweep, or a function of lists.
type Row = [&'static str; 2];

fn rows() -> Vec<Row> {
    const SWEEPS: [&str; 3] = ["sweep: inertial", "sweep: local", "sweep: general"];
    let swept = ["arm7", "cart", "quadruped", "humanoid"].into_iter();
    let swept = swept.flat_map(|robot| SWEEPS.map(|sweep| [robot, sweep]));
    let called = functions::ROBOTS.into_iter().flat_map(|robot| functions::FUNCTIONS.map(|name| [robot, name]));
    swept.chain(called).chain(sweeps::OF_THE_ARM.map(|name| ["arm7", name])).collect()
}

/// Calls what a row says a number of times: what is run under valgrind.
fn run(robot: &str, what: &str, times: usize) -> Result<(), Box<dyn Error>> {
    match what.strip_prefix("sweep: ") {
        Some(form) => sweeps::run(robot, form, times),
        None if functions::FUNCTIONS.contains(&what) => functions::run(robot, what, times),
        None => sweeps::function(what, times),
    }
}

/// Instructions of a call; nothing where valgrind does not know one.
fn instructions(program: &Path, [robot, what]: Row) -> Option<u64> {
    let counted = |times: usize| {
        let words = ["repeat", robot, what, &times.to_string()];
        count(program, &words)
            .inspect_err(|error| eprintln!("{robot}, {what}: {}", error.lines().next().unwrap_or("")))
            .ok()
    };
    let [few, more] = CALLS;
    Some((counted(more)? - counted(few)?) / (more - few) as u64)
}

/// Counts of two builds, printed.
fn counted(other: &Path) -> Result<Vec<Counted>, Box<dyn Error>> {
    if !has_valgrind() {
        return Err("valgrind is not installed".into());
    }
    let programs = [std::env::current_exe()?, other.to_owned()];
    println!("| robot | function | default | v3 |\n|---|---|---:|---:|");
    let count = |row: Row| {
        let counts = [0, 1].map(|k| instructions(&programs[k], row));
        let [default, v3] = counts.map(|count| count.map_or("–".to_owned(), |count| count.to_string()));
        println!("| {} | `{}` | {default} | {v3} |", row[0], row[1]);
        Counted { row, counts }
    };
    Ok(rows().into_iter().map(count).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["repeat", robot, what, times] => run(robot, what, times.parse()?),
        ["--check", "--against", other] => record::check(Path::new(RECORD), &counted(Path::new(other))?),
        ["--record", "--against", other] => record::write(Path::new(RECORD), &counted(Path::new(other))?),
        ["--against", other] => counted(&PathBuf::from(other)).map(drop),
        _ => {
            println!("counted by benches/count.sh robots, for two targets"); // cargo hands arguments of its own
            Ok(())
        }
    }
}
