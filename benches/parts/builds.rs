//! The time to compile a user's program when the library is already built. Every build is a whole one: nothing is left over from the build
//! before.

use super::clock::{median, progress};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Builds that are timed; the fastest counts, because a build uses all of a machine that is rarely idle.
const ROUNDS: usize = 5;

/// A package that uses the library, in a folder of its own.
pub struct User {
    folder: PathBuf,
}

impl User {
    /// In a folder of this name; of the library's folder versions are the same, from what is already downloaded.
    pub fn named(name: &str, library: &Path) -> Result<Self, Box<dyn Error>> {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(folder.join("src"))?;
        let package = "[package]\nname = \"user\"\nedition = \"2024\"\n[workspace]\n";
        let manifest = format!("{package}[dependencies]\ncatena = {{ path = {library:?} }}\n");
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::copy(library.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        Ok(Self { folder })
    }

    /// The fastest and the middle one (s) of builds in a profile of a program, whose text is a new one in each round.
    pub fn seconds(
        &self,
        what: &str,
        profile: &str,
        program: impl Fn(usize) -> String,
    ) -> Result<[f64; 2], Box<dyn Error>> {
        let mut times = Vec::new();
        for round in 0..=ROUNDS {
            progress(&format!("{what}, {profile}: build {round} of {ROUNDS}"));
            fs::write(self.folder.join("src/main.rs"), program(round))?;
            let start = Instant::now();
            let output = Command::new(env!("CARGO"))
                .args(["build", "--quiet", "--offline", "--profile", profile, "--target-dir", "target"])
                .env("CARGO_INCREMENTAL", "0") // every build a whole one
                .current_dir(&self.folder)
                .output()?;
            if !output.status.success() {
                return Err(String::from_utf8_lossy(&output.stderr).into_owned().into());
            }
            if round > 0 {
                times.push(start.elapsed().as_secs_f64()); // the first build also builds the library
            }
        }
        progress("");
        let middle = median(&mut times); // sorts
        Ok([times[0], middle])
    }
}
