//! What a scene pays for what it does not have: instructions and bytes of a general scene, of the same with each feature absent, and of
//! pairs of which one type does without a feature and the other cannot have it.
//!
//! ```text
//! cargo run --release -p catena-skip                                                  # the default target
//! RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release -p catena-skip
//! ```
//!
//! Needs valgrind. Prints tables and writes `benches/results/skip-TARGET.csv`.

#[path = "../../parts/by_hand.rs"]
mod by_hand;
mod case;
#[path = "../../parts/count.rs"]
mod count;
mod scenes;

use case::{Bytes, Row};
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

const TARGET: &str = if cfg!(target_feature = "fma") { "v3" } else { "default" };

fn all() -> (Vec<Row>, Vec<[Row; 2]>) {
    let mut pairs = scenes::pairs();
    pairs.extend(scenes::furniture());
    pairs.extend(scenes::least());
    (scenes::general(), pairs)
}

fn main() -> Result<(), Box<dyn Error>> {
    let (general, pairs) = all();
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let [repeat, name, times] = words.as_slice()
        && repeat == "repeat"
    {
        let rows = general.iter().chain(pairs.iter().flatten());
        if let Some(row) = rows.into_iter().find(|row| row.word() == *name) {
            (row.make)()?.sweep(times.parse()?);
        }
        return Ok(());
    }
    let mut csv = "feature,scene,target,instructions,scene_bytes,motion_bytes,stepper_bytes\n".to_owned();
    println!("Instructions a body and sweep, {TARGET}; bytes of scene, motion, stepper of RK4\n");
    println!("| scene | instructions | bytes |\n|---|---:|---|");
    for row in &general {
        let (count, bytes) = measure(row)?;
        println!("| {}, {} | {count:.1} | {} |", row.feature, row.name, text(bytes));
        line(&mut csv, row, count, bytes);
    }
    println!("\n| absent | does without | cannot have it | more | bytes |\n|---|---:|---:|---:|---|");
    for pair in &pairs {
        let [(a, own), (b, other)] = [measure(&pair[0])?, measure(&pair[1])?];
        let bytes = if own == other { text(own) } else { format!("{} against {}", text(own), text(other)) };
        let [first, second] = pair;
        let more = 100.0 * (a / b - 1.0);
        println!("| {} | {}: {a:.1} | {}: {b:.1} | {more:+.1} % | {bytes} |", first.feature, first.name, second.name);
        line(&mut csv, first, a, own);
        line(&mut csv, second, b, other);
    }
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../results");
    std::fs::create_dir_all(&directory)?;
    std::fs::write(directory.join(format!("skip-{TARGET}.csv")), csv)?;
    Ok(())
}

/// Instructions a body and sweep: what more repetitions add; not a number where valgrind does not know an instruction.
fn measure(row: &Row) -> Result<(f64, Option<Bytes>), Box<dyn Error>> {
    let case = (row.make)()?;
    let program = std::env::current_exe()?;
    let (few, more) = (4, 104);
    let count = |times: usize| count::count(&program, &["repeat", &row.word(), &times.to_string()]);
    let per_body = |added: u64| added as f64 / ((more - few) * case.bodies()) as f64;
    let counted = count(few).and_then(|few| Ok(per_body(count(more)? - few)));
    Ok((counted.unwrap_or(f64::NAN), case.bytes()))
}

fn text(bytes: Option<Bytes>) -> String {
    bytes.map_or_else(String::new, |Bytes { scene, motion, stepper }| format!("{scene}, {motion}, {stepper}"))
}

fn line(csv: &mut String, row: &Row, count: f64, bytes: Option<Bytes>) {
    let list = bytes.map_or_else(|| ",,".to_owned(), |b| format!("{},{},{}", b.scene, b.motion, b.stepper));
    let name = row.name.replace(',', ";");
    let _ = writeln!(csv, "{},{name},{TARGET},{count:.2},{list}", row.feature.replace(',', ";"));
}
