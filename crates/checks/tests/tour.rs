//! The tour of the examples: numbered without a gap, each example once, none shorter than a story or longer than two screens; every picture that
//! moves stands in the gallery beside its code.

use std::collections::BTreeSet;
use std::error::Error;
use std::fs;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

type Failure = Box<dyn Error>;

/// Lines of an example.
const LINES: RangeInclusive<usize> = 60..=150;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Files right in a folder with this ending.
fn files(folder: &Path, ending: &str) -> Result<Vec<PathBuf>, Failure> {
    let paths: Vec<_> = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>()?;
    Ok(paths.into_iter().filter(|path| path.extension().is_some_and(|found| found == ending)).collect())
}

/// Rows of the tour that have a number: that, and where they link to.
fn stops(text: &str) -> Vec<(usize, &str)> {
    let rows = text.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(" | "));
    rows.filter_map(|(number, rest)| Some((number.parse().ok()?, rest.split_once("](")?.1.split_once(')')?.0)))
        .collect()
}

#[test]
fn every_example_has_a_number() -> Result<(), Failure> {
    let examples = root().join("examples");
    let text = fs::read_to_string(examples.join("README.md"))?;
    let stops = stops(&text);
    let numbers: Vec<usize> = stops.iter().map(|(number, _)| *number).collect();
    assert_eq!(numbers, (1..=stops.len()).collect::<Vec<_>>());
    let mut there = vec![root().join("crates/identify/src/main.rs").canonicalize()?];
    for folder in [examples.clone(), root().join("crates/robots/examples")] {
        for path in files(&folder, "rs")? {
            there.push(path.canonicalize()?);
        }
    }
    let linked: Vec<PathBuf> =
        stops.iter().map(|(_, link)| examples.join(link).canonicalize()).collect::<Result<_, _>>()?;
    assert_eq!(linked.len(), there.len(), "an example is missing, or met twice");
    let [linked, there] = [linked, there].map(BTreeSet::from_iter);
    assert_eq!(linked, there);
    for path in &there {
        let lines = fs::read_to_string(path)?.lines().count();
        assert!(LINES.contains(&lines), "{}: {lines} lines", path.display());
    }
    Ok(())
}

#[test]
fn the_gallery_shows_what_moves() -> Result<(), Failure> {
    let gallery = fs::read_to_string(root().join("docs/gallery.html"))?;
    for path in files(&root().join("docs/pictures"), "svg")? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let figure = gallery.split("<figure").find(|part| part.contains(&format!("pictures/{name}.svg")));
        let figure = figure.ok_or(format!("{name} is not in the gallery"))?;
        assert!(figure.contains("cargo run") && figure.contains("href=\"../"), "{name} is shown without its code");
    }
    Ok(())
}
