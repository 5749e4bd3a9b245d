//! Writes the tables of BENCHMARKS.md from the files in `benches/results`: what stands between `<!-- NAME -->` and `<!-- end -->`, and the
//! picture of run time against error.
//!
//! ```text
//! cargo run -p catena-report              # writes
//! cargo run -p catena-report -- --check   # fails where something would change
//! ```

mod picture;
mod robots;
mod tables;

use std::error::Error;
use std::path::Path;
use tables::Rows;

/// A table by its name: the file that it is made of, and how.
type Table = (&'static str, &'static str, fn(&Rows) -> String);

const TABLES: &[Table] = &[
    ("chains", "counts.csv", |rows| tables::sweeps(rows, "chains", Some("hand"))),
    ("springs and tips", "counts.csv", |rows| tables::sweeps(rows, "springs and tips", Some("pins"))),
    ("trees and loops", "counts.csv", |rows| tables::sweeps(rows, "trees and loops", Some("pins"))),
    ("space", "counts.csv", |rows| tables::sweeps(rows, "space", None)),
    ("stability step", "stability/step.csv", tables::cases),
    ("stability sweep", "stability/sweep.csv", tables::cases),
    ("stability runs", "stability/runs.csv", tables::cases),
    ("stability nested", "stability/nested.csv", tables::cases),
    ("stability hard", "stability/hard.csv", tables::cases),
    ("stability random", "stability/random.csv", tables::cases),
    ("stability long", "stability/long.csv", tables::noted),
    ("stability losses", "stability", tables::losses),
    ("skip", "skip-", tables::skip),
    ("ensembles", "ensembles.csv", tables::ensembles),
    ("precision", "precision", tables::precision),
    ("gradients beside phyz", "gradients.csv", tables::gradients),
    ("robots counted", "robot_counts.csv", robots::counted),
    ("robots", "robots.csv", robots::beside),
    ("published robots", "published.csv", robots::published),
    ("robots' losses", "robots.csv", robots::losses),
    ("real time", "real_time.csv", robots::in_real_time),
];

fn main() -> Result<(), Box<dyn Error>> {
    let check = std::env::args().any(|word| word == "--check");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = root.join("BENCHMARKS.md");
    let before = std::fs::read_to_string(&page)?;
    let mut text = before.clone();
    for (name, source, make) in TABLES {
        let rows = Rows::read(&root.join("benches/results"), source)?;
        let begin = format!("<!-- {name} -->\n");
        let Some(start) = text.find(&begin).map(|at| at + begin.len()) else {
            return Err(format!("BENCHMARKS.md has no place for {name}").into());
        };
        let Some(length) = text[start..].find("<!-- end -->") else {
            return Err(format!("the place of {name} does not end").into());
        };
        let table = if rows.0.is_empty() { "Not measured yet.\n".to_owned() } else { make(&rows) };
        text.replace_range(start..start + length, &format!("\n{table}\n"));
    }
    let pictured = root.join("docs/pictures/work_precision.svg");
    let drawn = picture::draw(&Rows::read(&root.join("benches/results"), "precision")?)?;
    if !check {
        std::fs::write(page, text)?;
        std::fs::write(pictured, drawn)?;
    } else if text != before || std::fs::read_to_string(pictured)? != drawn {
        let what = "BENCHMARKS.md or its picture is not what the files in benches/results say";
        return Err(format!("{what}: cargo run -p catena-report").into());
    }
    Ok(())
}
