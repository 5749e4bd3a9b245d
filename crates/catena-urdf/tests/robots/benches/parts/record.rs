//! Counts of instructions as they were recorded, to compare with.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// By what share a count may exceed its record, for the default target and for x86-64-v3.
const ALLOWED: [f64; 2] = [0.03, 0.005];

/// Instructions of a call, for both targets; none where valgrind could not count.
pub struct Counted {
    pub row: [&'static str; 2],
    pub counts: [Option<u64>; 2],
}

impl Counted {
    /// The name of the row in a file: commas within it are semicolons.
    fn key(&self) -> String {
        self.row.map(|name| name.replace(',', ";")).join(",")
    }
}

fn compiler() -> Result<String, Box<dyn Error>> {
    let output = Command::new("rustc").arg("--version").output()?;
    Ok(String::from_utf8(output.stdout)?.split_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// Writes counts as those to compare with.
pub fn write(file: &Path, rows: &[Counted]) -> Result<(), Box<dyn Error>> {
    let (compiler, mut text) = (compiler()?, "robot,function,default,v3,compiler\n".to_owned());
    for row in rows {
        let [default, v3] = row.counts.map(|count| count.map_or(String::new(), |count| count.to_string()));
        writeln!(text, "{},{default},{v3},{compiler}", row.key())?;
    }
    Ok(std::fs::write(file, text)?)
}

/// Refuses counts above their record, and rows that have none. What valgrind could not count when it was recorded is compared with nothing.
pub fn check(file: &Path, rows: &[Counted]) -> Result<(), Box<dyn Error>> {
    let (text, compiler) = (std::fs::read_to_string(file)?, compiler()?);
    let recorded: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    if let Some(with) = recorded.iter().filter_map(|fields| fields.last()).find(|with| **with != compiler) {
        println!("Recorded with {with}, counted with {compiler}: not compared.");
        return Ok(());
    }
    let (mut worse, mut compared) = (vec![], 0);
    for row in rows {
        let fields = recorded.iter().find(|fields| fields.len() == 5 && fields[..2].join(",") == row.key());
        let fields = fields.ok_or_else(|| format!("{} is not recorded", row.key()))?;
        for ((count, record), allowed) in row.counts.iter().zip(&fields[2..4]).zip(ALLOWED) {
            let Ok(record) = record.parse::<f64>() else { continue };
            compared += 1;
            match count {
                Some(count) if *count as f64 <= record * (1.0 + allowed) => (),
                Some(count) => worse.push(format!("{}: {count} instead of {record}", row.key())),
                None => worse.push(format!("{}: no count instead of {record}", row.key())),
            }
        }
    }
    if !worse.is_empty() {
        return Err(worse.join("; ").into());
    }
    println!("None of {compared} counts is above what is allowed.");
    Ok(())
}
