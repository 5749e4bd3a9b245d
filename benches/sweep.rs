//! What a sweep costs: time and instructions per body, in the plane beside loops written by hand.
//!
//! `cargo bench --bench sweep` checks that library and hand agree, and in space that accelerations solve the equations of motion; then it
//! measures this build and prints a table. `benches/count.sh` builds for the default target and for x86-64-v3 and prints one
//! table of both. Arguments restrict either to scenes whose names contain one: `benches/count.sh balls`.

#[path = "parts/by_hand.rs"]
mod by_hand;
#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/inverse.rs"]
mod inverse;
#[path = "parts/measure.rs"]
mod measure;
#[path = "parts/scenes.rs"]
mod scenes;
#[path = "parts/scenes_in_space.rs"]
mod scenes_in_space;
#[path = "parts/system_sine.rs"]
mod system_sine;

use clock::progress;
use measure::{has_valgrind, instructions, wall, wall_of};
use scenes::Row;
use std::collections::HashMap;
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let rows: Vec<Row> = scenes::rows().into_iter().chain(scenes_in_space::rows()).collect();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["repeat", name, times] => repeat(&rows, name, times.parse()?),
        ["wall", ref words @ ..] => {
            let rows = with_words(rows, words);
            rows.iter().zip(wall(&rows)).for_each(|(row, ns)| println!("{}\t{ns}", row.name()));
        }
        ["--against", other, ref words @ ..] => table(&with_words(rows, words), Some(Path::new(other)), words)?,
        ref words => {
            let words: Vec<&str> = words.iter().copied().filter(|word| !word.starts_with('-')).collect(); // cargo hands its own
            table(&with_words(rows, &words), None, &words)?;
        }
    }
    Ok(())
}

/// The rows of scenes whose names contain one of the words; all where there is none.
fn with_words(rows: Vec<Row>, words: &[&str]) -> Vec<Row> {
    rows.into_iter().filter(|row| words.is_empty() || words.iter().any(|word| row.scene.contains(word))).collect()
}

/// Sweeps one row a number of times: what is run under valgrind.
fn repeat(rows: &[Row], name: &str, times: usize) {
    if let Some(row) = rows.iter().find(|row| row.name() == name) {
        (row.make)().sweep(times);
    }
}

/// Compares each row with the loop by hand: the largest difference as a share of the largest acceleration. Where a case has a
/// reckoning of its own, that must leave nothing: the largest residual.
fn check(rows: &[Row]) -> Result<[f64; 2], String> {
    let swept = |row: &Row| {
        let mut case = (row.make)();
        case.sweep(1);
        (case.accelerations(), case.residual())
    };
    let mut largest = [0.0_f64; 2];
    for row in rows {
        let (got, residual) = swept(row);
        if let Some(residual) = residual {
            if !residual.lt(&100.0) {
                return Err(format!(
                    "{} leaves moments in its joints {residual:.1e} times what rounding leaves",
                    row.name()
                ));
            }
            largest[1] = largest[1].max(residual);
            continue;
        }
        let hand = row.yardstick(rows).ok_or_else(|| format!("nothing by hand for {}", row.name()))?;
        let (want, _) = swept(hand);
        let size = want.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let errors: Vec<f64> = got.iter().zip(&want).map(|(x, y)| (x - y).abs() / size).collect();
        if got.len() != want.len() || !errors.iter().all(|error| *error < 1e-12) {
            return Err(format!("{} differs from the loop by hand by 1e-12 of the largest acceleration", row.name()));
        }
        largest[0] = errors.into_iter().fold(largest[0], f64::max);
    }
    Ok(largest)
}

/// What one build measures, row by row; NaN where there is nothing.
struct Column {
    instructions: Vec<f64>,
    nanoseconds: Vec<f64>,
}

/// Instructions per body of each row; nothing where valgrind is missing or does not know an instruction.
fn counted(program: &Path, rows: &[Row], target: &str) -> Vec<f64> {
    if !has_valgrind() {
        return vec![f64::NAN; rows.len()];
    }
    let counts = rows.iter().enumerate().map(|(i, row)| {
        progress(&format!("instructions, {target}: {} of {}", i + 1, rows.len()));
        instructions(program, row).unwrap_or_else(|error| {
            eprintln!("{error}");
            f64::NAN
        })
    });
    let counts = counts.collect();
    progress("");
    counts
}

fn table(rows: &[Row], other: Option<&Path>, words: &[&str]) -> Result<(), Box<dyn Error>> {
    let [difference, residual] = check(rows)?;
    println!("Library and hand agree to {difference:.1e} of the largest acceleration.");
    println!(
        "In space moments where none may act are at most {residual:.1} times what rounding of accelerations leaves."
    );
    if !has_valgrind() {
        println!("Instructions are not counted: valgrind is not installed.");
    }
    let this: PathBuf = std::env::current_exe()?;
    let mut columns = vec![Column { instructions: counted(&this, rows, "this build"), nanoseconds: wall(rows) }];
    if let Some(other) = other {
        let by_name: HashMap<String, f64> = wall_of(other, words)?;
        let nanoseconds = rows.iter().map(|row| by_name.get(&row.name()).copied().unwrap_or(f64::NAN)).collect();
        columns.push(Column { instructions: counted(other, rows, "other build"), nanoseconds });
    }
    print(rows, &columns);
    Ok(())
}

/// A table in Markdown: instructions of each build, nanoseconds of each build, ratios to the loop by hand.
fn print(rows: &[Row], columns: &[Column]) {
    let targets: &[&str] = if columns.len() == 2 { &["default", "v3"] } else { &["this build"] };
    let mut head = "| scene | form | n |".to_owned();
    for what in ["instr/body", "ns/body", "instr : hand", "ns : hand"] {
        targets.iter().for_each(|target| head += &format!(" {what} {target} |"));
    }
    println!("\n{head}\n|---|---|---:|{}", "---:|".repeat(4 * targets.len()));
    for (i, row) in rows.iter().enumerate() {
        let hand = row.yardstick(rows).and_then(|hand| rows.iter().position(|row| std::ptr::eq(row, hand)));
        let number = |value: f64, digits: usize| match value.is_nan() {
            true => " – |".to_owned(),
            false => format!(" {value:.digits$} |"),
        };
        let mut line = format!("| {} | {} | {} |", row.scene, row.form, row.bodies);
        columns.iter().for_each(|column| line += &number(column.instructions[i], 1));
        columns.iter().for_each(|column| line += &number(column.nanoseconds[i], 1));
        let ratio = |values: &[f64]| match hand {
            Some(hand) if !row.is_by_hand() => number(values[i] / values[hand], 2),
            _ => " |".to_owned(),
        };
        columns.iter().for_each(|column| line += &ratio(&column.instructions));
        columns.iter().for_each(|column| line += &ratio(&column.nanoseconds));
        println!("{line}");
    }
}
