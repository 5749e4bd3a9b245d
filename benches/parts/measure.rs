//! Measuring: wall time as the median of many interleaved samples, instructions as a difference of two counts.

use crate::clock::{median, progress};
use crate::count;
use crate::scenes::{Case, Row};
use std::collections::HashMap;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

/// Samples of each row.
const ROUNDS: usize = 101;
/// How long a sample should take at least.
const SAMPLE: Duration = Duration::from_micros(50);

/// Nanoseconds per body of each row: rows take turns, so that a disturbance of the machine hits all of them.
pub fn wall(rows: &[Row]) -> Vec<f64> {
    struct Entry {
        case: Box<dyn Case>,
        times: usize,
        samples: Vec<f64>,
    }
    let time = |case: &mut dyn Case, times| {
        let start = Instant::now();
        case.sweep(times);
        start.elapsed()
    };
    let mut entries: Vec<_> = rows
        .iter()
        .map(|row| {
            let mut case = (row.make)();
            let mut times = 1;
            while time(case.as_mut(), times) < SAMPLE {
                times *= 2;
            }
            Entry { case, times, samples: Vec::with_capacity(ROUNDS) }
        })
        .collect();
    for round in 0..ROUNDS {
        progress(&format!("wall time, round {} of {ROUNDS}", round + 1));
        for (row, Entry { case, times, samples }) in rows.iter().zip(&mut entries) {
            case.sweep(1); // the caches and predictors that other rows have used are this row's again
            samples.push(time(case.as_mut(), *times).as_nanos() as f64 / (*times * row.bodies) as f64);
        }
    }
    progress("");
    entries.iter_mut().map(|entry| median(&mut entry.samples)).collect()
}

/// Wall times that another build of this program measures, by the name of the row.
pub fn wall_of(program: &Path, words: &[&str]) -> Result<HashMap<String, f64>, String> {
    let output = Command::new(program).arg("wall").args(words).stderr(std::process::Stdio::inherit()).output();
    let output = output.map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("{} does not run on this machine: {}", program.display(), output.status));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let pairs = text.lines().filter_map(|line| line.split_once('\t'));
    Ok(pairs.filter_map(|(name, ns)| Some((name.to_owned(), ns.parse().ok()?))).collect())
}

/// Instructions per body of a row as callgrind counts them: what further sweeps add to a run of `program`, so that
/// start and construction cancel. The count is exact.
pub fn instructions(program: &Path, row: &Row) -> Result<f64, String> {
    let (few, more) = (2, if row.bodies > 10_000 { 4 } else { 102 });
    let counted = |times: usize| count::count(program, &["repeat", &row.name(), &times.to_string()]);
    let added = counted(more)? - counted(few)?;
    Ok(added as f64 / ((more - few) * row.bodies) as f64)
}
