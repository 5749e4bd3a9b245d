//! Where solvers and rules hold, degrade and fail: one thing is varied at a time from a stated base scene.
//!
//! ```text
//! cargo run --release -p catena-stability                  # all parts but the long runs: some half an hour
//! cargo run --release -p catena-stability -- --quick       # a share of each part: seconds
//! cargo run --release -p catena-stability -- step runs     # these parts
//! cargo run --release -p catena-stability -- long          # 1e7 steps of six scenes
//! ```
//!
//! It prints a table and writes `benches/results/stability/PART.csv` (`--quick`: nothing). *Holds*: an error below 1e-6 (`f32`: 1e-2);
//! *degrades*: below 1e-2; *fails*: more, or an error that is returned.

mod hard;
mod long;
mod nested;
mod random;
mod remedies;
mod runs;
mod step;
mod sweep;
mod table;
#[path = "../../parts/transformed.rs"]
mod transformed;
#[path = "../../parts/twice.rs"]
mod twice;

use std::path::Path;
use std::time::Instant;
use table::Table;

/// A part of the table by its name.
type Part = (&'static str, fn(&mut Table, bool));

const PARTS: &[Part] = &[
    ("step", step::run),
    ("sweep", sweep::run),
    ("runs", runs::run),
    ("nested", nested::run),
    ("hard", hard::run),
    ("random", random::run),
    (LONG, long::run),
];
/// Not run unless named.
const LONG: &str = "long";

/// Says what long work is about, on one line that is written over.
fn progress(what: &str) {
    eprint!("\r\x1b[K{what}");
}

fn main() -> std::io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let quick = words.iter().any(|word| word == "--quick");
    let named: Vec<&String> = words.iter().filter(|word| !word.starts_with('-')).collect();
    for unknown in named.iter().filter(|word| !PARTS.iter().any(|(name, _)| name == **word)) {
        eprintln!("no part {unknown}: there are {:?}", PARTS.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    }
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results/stability");
    let mut totals = [0; 3];
    for (name, run) in PARTS {
        let wanted = if named.is_empty() { *name != LONG } else { named.iter().any(|word| word == name) };
        if !wanted {
            continue;
        }
        let (start, mut table) = (Instant::now(), Table::default());
        run(&mut table, quick);
        progress("");
        table.print();
        let [holds, degrades, fails] = table.counts();
        println!("\n{name}: {holds} hold, {degrades} degrade, {fails} fail; {:.0} s", start.elapsed().as_secs_f64());
        totals.iter_mut().zip([holds, degrades, fails]).for_each(|(total, more)| *total += more);
        if !quick {
            table.save(&directory)?;
        }
    }
    println!("\nIn all {} hold, {} degrade, {} fail.", totals[0], totals[1], totals[2]);
    Ok(())
}
