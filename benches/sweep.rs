//! What a sweep costs: time and instructions per body, beside loops written by hand.
//!
//! `cargo bench --bench sweep` checks that library and hand agree, measures this build and prints three tables: scenes beside loops
//! by hand, other joints, ends and topologies beside pins, and chains in space. `benches/count.sh` builds for the default target and for
//! x86-64-v3 and prints both builds in one. `--quick` counts the instructions of short chains of rods only.

#[path = "parts/by_hand.rs"]
mod by_hand;
#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/count.rs"]
mod count;
#[path = "parts/held_by_hand.rs"]
mod held_by_hand;
#[path = "parts/inverse.rs"]
mod inverse;
#[path = "parts/joints.rs"]
mod joints;
#[path = "parts/measure.rs"]
mod measure;
#[path = "parts/record.rs"]
mod record;
#[path = "parts/scenes.rs"]
mod scenes;
#[path = "parts/scenes_in_space.rs"]
mod scenes_in_space;
#[path = "parts/system_sine.rs"]
mod system_sine;
#[path = "parts/topologies.rs"]
mod topologies;

use clock::progress;
use count::has_valgrind;
use measure::{instructions, wall, wall_of};
use record::Record;
use scenes::{Row, rows};
use std::collections::HashMap;
use std::error::Error;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// What counts are compared with.
const RECORD: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/results/counts.csv");

fn main() -> Result<(), Box<dyn Error>> {
    let mut rows = rows();
    let by_hand = rows.len();
    rows.extend(joints::rows());
    let springs = rows.len();
    rows.extend(topologies::rows());
    let in_plane = rows.len();
    rows.extend(scenes_in_space::rows());
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["repeat", name, times] => repeat(&rows, name, times.parse()?),
        ["wall", ..] => rows.iter().zip(wall(&rows)).for_each(|(row, ns)| println!("{}\t{ns}", row.name())),
        ["--quick", "--against", other] => quick(rows, Some(Path::new(other)))?,
        ["--check", "--against", other] => {
            rows.retain(|row| row.bodies <= 1000); // of more, callgrind would count for minutes
            let both = [std::env::current_exe()?, PathBuf::from(other)];
            let [default, v3] =
                ["default", "v3"].map(|target| counted(&both[usize::from(target == "v3")], &rows, target));
            record::check(Path::new(RECORD), &rows, [&default, &v3])?;
        }
        ["--record", "--against", other] => {
            let columns = tables(&rows, [by_hand, in_plane], Some(Path::new(other)))?;
            record::write(Path::new(RECORD), &recorded(&rows, [by_hand, springs, in_plane], &columns))?;
        }
        ["--quick"] => quick(rows, None)?,
        ["--against", other] => drop(tables(&rows, [by_hand, in_plane], Some(Path::new(other)))?),
        _ => drop(tables(&rows, [by_hand, in_plane], None)?), // cargo hands arguments of its own
    }
    Ok(())
}

/// Sweeps one row a number of times: what is run under valgrind.
fn repeat(rows: &[Row], name: &str, times: usize) {
    if let Some(row) = rows.iter().find(|row| row.name() == name) {
        (row.make)().sweep(times);
    }
}

/// Compares each row with the loop by hand: the largest difference as a share of the largest acceleration. A case with a reckoning
/// of its own must leave little more than rounding does.
fn check(rows: &[Row]) -> Result<f64, String> {
    let swept = |row: &Row| {
        let mut case = (row.make)();
        case.sweep(1);
        (case.accelerations(), case.residual())
    };
    let mut largest = 0.0_f64;
    for row in rows {
        let (got, residual) = swept(row);
        if let Some(residual) = residual {
            if !residual.lt(&100.0) {
                return Err(format!("{} leaves {residual:.1e} times what rounding leaves", row.name()));
            }
            continue;
        }
        let hand = row.yardstick(rows).ok_or_else(|| format!("nothing by hand for {}", row.name()))?;
        let (want, _) = swept(hand);
        let size = want.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let errors: Vec<f64> = got.iter().zip(&want).map(|(x, y)| (x - y).abs() / size).collect();
        if got.len() != want.len() || !errors.iter().all(|error| *error < 1e-12) {
            return Err(format!("{} differs from the loop by hand by 1e-12 of the largest acceleration", row.name()));
        }
        largest = errors.into_iter().fold(largest, f64::max);
    }
    Ok(largest)
}

/// What one build measures, row by row; NaN where there is nothing.
struct Column {
    instructions: Vec<f64>,
    nanoseconds: Vec<f64>,
}

fn counted(program: &Path, rows: &[Row], target: &str) -> Vec<f64> {
    if !has_valgrind() {
        return vec![f64::NAN; rows.len()];
    }
    let count = |(i, row): (usize, &Row)| {
        progress(&format!("instructions, {target}: {} of {}", i + 1, rows.len()));
        instructions(program, row).unwrap_or_else(|error| {
            eprintln!("{}: {error}", row.name()); // valgrind does not know each instruction of each processor
            f64::NAN
        })
    };
    let counts = rows.iter().enumerate().map(count).collect();
    progress("");
    counts
}

/// Instructions of short chains of rods alone.
fn quick(mut rows: Vec<Row>, other: Option<&Path>) -> Result<(), Box<dyn Error>> {
    rows.retain(|row| row.scene == "rods" && row.bodies <= 20);
    println!("Library and hand agree to {:.1e} of the largest acceleration.", check(&rows)?);
    let this: PathBuf = std::env::current_exe()?;
    let uncounted = |instructions: Vec<f64>| Column { nanoseconds: vec![f64::NAN; instructions.len()], instructions };
    let mut columns = vec![uncounted(counted(&this, &rows, "this build"))];
    columns.extend(other.map(|other| uncounted(counted(other, &rows, "other build"))));
    print(&rows, 0..rows.len(), &columns, Beside::Hand);
    Ok(())
}

/// Measures all rows. The first ones, as many as `by_hand`, have loops by hand to compare to; the others in the plane compare to
/// pins, those in space to nothing.
fn tables(rows: &[Row], [by_hand, in_plane]: [usize; 2], other: Option<&Path>) -> Result<Vec<Column>, Box<dyn Error>> {
    check(&rows[in_plane..])?;
    if let Some(held) = rows.iter().position(|row| row.scene == "pinned tip") {
        check(&rows[held..held + 2])?; // an array, and what is by hand
    }
    println!("Library and hand agree to {:.1e} of the largest acceleration.", check(&rows[..by_hand])?);
    if !has_valgrind() {
        println!("Instructions are not counted: valgrind is not installed.");
    }
    let this: PathBuf = std::env::current_exe()?;
    let mut columns = vec![Column { instructions: counted(&this, rows, "this build"), nanoseconds: wall(rows) }];
    if let Some(other) = other {
        let by_name: HashMap<String, f64> = wall_of(other, &[])?;
        let nanoseconds = rows.iter().map(|row| by_name.get(&row.name()).copied().unwrap_or(f64::NAN)).collect();
        columns.push(Column { instructions: counted(other, rows, "other build"), nanoseconds });
    }
    print(rows, 0..by_hand, &columns, Beside::Hand);
    print(rows, by_hand..in_plane, &columns, Beside::Pins);
    print(rows, in_plane..rows.len(), &columns, Beside::Nothing);
    Ok(columns)
}

/// What rows compare to.
#[derive(Clone, Copy)]
enum Beside {
    Hand,
    Pins,
    Nothing,
}

impl Beside {
    /// Another row, of which this one is a multiple.
    fn of(self, row: &Row, rows: &[Row]) -> Option<usize> {
        let other = match self {
            _ if row.is_by_hand() => None,
            Self::Hand => row.yardstick(rows),
            Self::Pins => row.pins(rows),
            Self::Nothing => None,
        }?;
        rows.iter().position(|row| std::ptr::eq(row, other))
    }
    const fn name(self) -> &'static str {
        match self {
            Self::Hand => "hand",
            Self::Pins => "pins",
            Self::Nothing => "nothing",
        }
    }
}

/// What is kept of all rows, under the names of the tables of BENCHMARKS.md.
fn recorded<'r>(rows: &'r [Row], [by_hand, springs, in_plane]: [usize; 3], columns: &[Column]) -> Vec<Record<'r>> {
    let parts = [
        ("chains", 0..by_hand, Beside::Hand),
        ("springs and tips", by_hand..springs, Beside::Pins),
        ("trees and loops", springs..in_plane, Beside::Pins),
        ("space", in_plane..rows.len(), Beside::Nothing),
    ];
    let of_part = |(part, range, beside): (_, Range<usize>, Beside)| {
        range.map(move |k| {
            let ratio = |column: &Column| {
                beside.of(&rows[k], rows).map_or(f64::NAN, |other| column.instructions[k] / column.instructions[other])
            };
            Record {
                part,
                row: &rows[k],
                instructions: columns.iter().map(|column| column.instructions[k]).collect(),
                ratios: columns.iter().map(ratio).collect(),
                nanoseconds: columns.iter().map(|column| column.nanoseconds[k]).collect(),
            }
        })
    };
    parts.into_iter().flat_map(of_part).collect()
}

/// A table in Markdown: instructions of each build, nanoseconds of each build, ratios to the loop by hand or to the pin chain.
fn print(rows: &[Row], shown: Range<usize>, columns: &[Column], beside: Beside) {
    let targets: &[&str] = if columns.len() == 2 { &["default", "v3"] } else { &["this build"] };
    let mut head = "| scene | form | n |".to_owned();
    for what in ["instr/body", "ns/body", &format!("instr : {}", beside.name()), &format!("ns : {}", beside.name())] {
        targets.iter().for_each(|target| head += &format!(" {what} {target} |"));
    }
    println!("\n{head}\n|---|---|---:|{}", "---:|".repeat(4 * targets.len()));
    for (i, row) in rows.iter().enumerate().take(shown.end).skip(shown.start) {
        let other = beside.of(row, rows);
        let number = |value: f64, digits: usize| match value.is_nan() {
            true => " – |".to_owned(),
            false => format!(" {value:.digits$} |"),
        };
        let mut line = format!("| {} | {} | {} |", row.scene, row.form, row.bodies);
        columns.iter().for_each(|column| line += &number(column.instructions[i], 1));
        columns.iter().for_each(|column| line += &number(column.nanoseconds[i], 1));
        let ratio = |values: &[f64]| match other {
            Some(other) => number(values[i] / values[other], 2),
            None => " |".to_owned(),
        };
        columns.iter().for_each(|column| line += &ratio(&column.instructions));
        columns.iter().for_each(|column| line += &ratio(&column.nanoseconds));
        println!("{line}");
    }
}
