//! Counts of instructions as they were recorded, to compare with: a gate, where compilers are the same.

use crate::scenes::Row;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// By how much a count may exceed its record, for the default target and for x86-64-v3: as a share, or in instructions a body.
const ALLOWED: [f64; 2] = [0.03, 0.005];
const SLACK: f64 = 0.1;

/// What is recorded of a row, for the default target and for x86-64-v3.
pub struct Record<'r> {
    pub part: &'static str,
    pub row: &'r Row,
    /// A body and sweep.
    pub instructions: Vec<f64>,
    /// As multiples of those of the row that it compares to.
    pub ratios: Vec<f64>,
    /// A body and sweep.
    pub nanoseconds: Vec<f64>,
}

fn compiler() -> Result<String, Box<dyn Error>> {
    let output = Command::new("rustc").arg("--version").output()?;
    Ok(String::from_utf8(output.stdout)?.split_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// The name of a row in a file: commas within it are semicolons.
fn key(row: &Row) -> String {
    format!("{},{},{}", row.scene.replace(',', ";"), row.form.replace(',', ";"), row.bodies)
}

/// Writes counts as those to compare with.
pub fn write(file: &Path, records: &[Record<'_>]) -> Result<(), Box<dyn Error>> {
    let compiler = compiler()?;
    let mut text = "part,scene,form,n,default,v3,default_ratio,v3_ratio,default_ns,v3_ns,compiler\n".to_owned();
    for record in records {
        let digits = |values: &[f64], digits: usize| -> String {
            values
                .iter()
                .map(|value| if value.is_nan() { ",".to_owned() } else { format!("{value:.digits$},") })
                .collect()
        };
        let numbers =
            [digits(&record.instructions, 1), digits(&record.ratios, 2), digits(&record.nanoseconds, 1)].concat();
        writeln!(text, "{},{},{numbers}{compiler}", record.part, key(record.row))?;
    }
    Ok(std::fs::write(file, text)?)
}

/// Refuses counts above their record, and rows that have none. What valgrind could not count when it was recorded is compared with
/// nothing.
pub fn check(file: &Path, rows: &[Row], counts: [&[f64]; 2]) -> Result<(), Box<dyn Error>> {
    let (text, compiler) = (std::fs::read_to_string(file)?, compiler()?);
    let recorded: Vec<Vec<&str>> = text.lines().skip(1).map(|line| line.split(',').collect()).collect();
    if let Some(with) = recorded.iter().filter_map(|fields| fields.last()).find(|with| **with != compiler) {
        println!("Recorded with {with}, counted with {compiler}: not compared.");
        return Ok(());
    }
    let mut worse = vec![];
    for (k, row) in rows.iter().enumerate() {
        let fields = recorded.iter().find(|fields| fields.len() == 11 && fields[1..4].join(",") == key(row));
        let Some(fields) = fields else {
            return Err(format!("{} is not recorded", row.name()).into());
        };
        for ((counts, record), allowed) in counts.iter().zip(&fields[4..6]).zip(ALLOWED) {
            let Ok(record) = record.parse::<f64>() else { continue };
            if counts[k].is_nan() || counts[k] > record + SLACK.max(allowed * record) {
                worse.push(format!("{}: {:.1} instead of {record:.1}", row.name(), counts[k]));
            }
        }
    }
    if !worse.is_empty() {
        return Err(worse.join("; ").into());
    }
    println!("None of {} rows takes more than is allowed.", rows.len());
    Ok(())
}
