//! Counts of instructions as they were recorded, to compare with: a gate, where compilers are the same.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// By how much a count may exceed its record, for the default target and for x86-64-v3: as a share, or in instructions a body.
const ALLOWED: [f64; 2] = [0.03, 0.005];
const SLACK: f64 = 0.1;

/// A row's name and its instructions a body and sweep, for either target.
pub type Counts = Vec<(String, Vec<f64>)>;

fn compiler() -> Result<String, Box<dyn Error>> {
    let output = Command::new("rustc").arg("--version").output()?;
    Ok(String::from_utf8(output.stdout)?.split_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// Writes counts as those to compare with.
pub fn write(file: &Path, counts: &Counts) -> Result<(), Box<dyn Error>> {
    let compiler = compiler()?;
    let mut text = "row,default,v3,compiler\n".to_owned();
    for (name, own) in counts {
        let values: Vec<String> = own.iter().map(|value| format!("{value:.1}")).collect();
        writeln!(text, "{name},{},{compiler}", values.join(","))?;
    }
    Ok(std::fs::write(file, text)?)
}

/// Refuses counts above their record, and rows that are missing on either side.
pub fn check(file: &Path, counts: &Counts) -> Result<(), Box<dyn Error>> {
    let (text, compiler) = (std::fs::read_to_string(file)?, compiler()?);
    let mut worse = vec![];
    for line in text.lines().skip(1) {
        let [name, default, v3, with] = line.split(',').collect::<Vec<_>>()[..] else {
            return Err(format!("{line} is no record").into());
        };
        if with != compiler {
            println!("Recorded with {with}, counted with {compiler}: not compared.");
            return Ok(());
        }
        let (_, own) = counts.iter().find(|(own, _)| own == name).ok_or_else(|| format!("{name} is not counted"))?;
        for (k, (value, record)) in own.iter().zip([default, v3]).enumerate() {
            let record: f64 = record.parse()?;
            if value.is_nan() {
                return Err(format!("{name} is not counted").into());
            }
            if *value > record + SLACK.max(ALLOWED[k] * record) {
                worse.push(format!("{name}: {value:.1} instead of {record:.1}"));
            }
        }
    }
    let recorded = text.lines().count().saturating_sub(1);
    if !worse.is_empty() {
        return Err(worse.join("; ").into());
    }
    if recorded != counts.len() {
        return Err(format!("{} rows, of which {recorded} are recorded", counts.len()).into());
    }
    println!("All {recorded} rows as recorded or below.");
    Ok(())
}
