//! Scenes that make no sense do not compile, and the compiler says which part of them is to blame.
//!
//! Each file in compile_fail is such a scene. Its lines `//@ …` are phrases that the first error must contain;
//! the rest of what compilers print differs from version to version.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A scene that does make sense: what the others fail at is not the way they are compiled.
const SOUND: &str = "fn main() -> Result<(), catena::Error> {
    use catena::planar::*;
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    Ok(())
}";

/// What the compiler prints about a program; `None` if it has nothing to say.
fn complaint(folder: &Path, program: &str) -> Result<Option<String>, Box<dyn Error>> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["check", "--quiet", "--color", "never", "--bin", program, "--manifest-path"]);
    let output = cargo.arg(folder.join("Cargo.toml")).arg("--target-dir").arg(folder.join("target")).output()?;
    Ok(if output.status.success() { None } else { Some(String::from_utf8_lossy(&output.stderr).into_owned()) })
}

/// The first error, without the paths of types.
fn first_error(complaint: &str) -> String {
    let from_error = complaint.find("error").map_or(complaint, |start| &complaint[start..]);
    let first = from_error.split("\n\n").next().unwrap_or_default();
    ["catena::planar::", "catena::relation::planar::"]
        .iter()
        .fold(first.to_owned(), |text, path| text.replace(path, ""))
}

#[test]
fn errors_name_the_culprit() -> Result<(), Box<dyn Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = here.join("../..");
    let mut cases: Vec<PathBuf> = fs::read_dir(here.join("compile_fail"))?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<_, _>>()?;
    cases.sort();

    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("compile_fail");
    fs::create_dir_all(&folder)?;
    fs::write(folder.join("sound.rs"), SOUND)?;
    let mut manifest = format!(
        "[package]\nname = 'compile-fail'\nedition = '2024'\n[workspace]\n[dependencies]\ncatena = {{ path = '{}' }}\n",
        root.canonicalize()?.display()
    );
    let names: Vec<String> =
        cases.iter().filter_map(|case| case.file_stem()).map(|name| name.to_string_lossy().into_owned()).collect();
    let sound = ("sound".to_owned(), folder.join("sound.rs"));
    for (name, path) in names.iter().cloned().zip(cases.iter().cloned()).chain([sound]) {
        write!(manifest, "[[bin]]\nname = '{name}'\npath = '{}'\n", path.display())?;
    }
    fs::write(folder.join("Cargo.toml"), manifest)?;
    // The versions that are tested here anyway, so that nothing new is looked up.
    if root.join("Cargo.lock").exists() {
        fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    }

    if let Some(complaint) = complaint(&folder, "sound")? {
        return Err(format!("a sound scene does not compile:\n{complaint}").into());
    }
    let mut failures = String::new();
    for (name, path) in names.iter().zip(&cases) {
        let source = fs::read_to_string(path)?;
        let phrases: Vec<&str> = source.lines().filter_map(|line| line.strip_prefix("//@ ")).collect();
        assert!(!phrases.is_empty(), "{name} expects nothing");
        let Some(complaint) = complaint(&folder, name)? else {
            writeln!(failures, "{name} compiles")?;
            continue;
        };
        let error = first_error(&complaint);
        println!("{name}: {}", error.lines().next().unwrap_or_default());
        for phrase in phrases.iter().filter(|phrase| !error.contains(**phrase)) {
            writeln!(failures, "{name} does not say {phrase:?}:\n{error}\n")?;
        }
    }
    assert!(failures.is_empty(), "{failures}");
    Ok(())
}
