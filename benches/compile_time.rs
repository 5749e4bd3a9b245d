//! How long a user waits: the time to compile a program with a chain of sixty bodies of three kinds and the pins
//! between them, in nested tuples of different types, when catena itself is already built. Every build is a whole one:
//! nothing is left over from the build before.
//!
//! `cargo bench --bench compile_time`

#[path = "parts/clock.rs"]
mod clock;

use clock::{median, progress};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

const BODIES: usize = 60;
/// Items of an inner tuple.
const GROUP: usize = 15;
/// Builds that are timed; the fastest counts, because a build uses all of a machine that is rarely idle.
const ROUNDS: usize = 5;
/// What we aim at (s).
const TARGET: f64 = 2.0;

/// How much of the library a program uses.
enum Use {
    /// The accelerations of one state.
    Accelerations,
    /// A run with error control.
    Simulation,
}

impl Use {
    fn name(&self) -> &'static str {
        match self {
            Self::Accelerations => "forward dynamics",
            Self::Simulation => "simulation by Dop853",
        }
    }
    fn statement(&self) -> &'static str {
        match self {
            Self::Accelerations => "let motion = scene.with_accelerations(start, &Loads::none())?;",
            Self::Simulation => "let motion = scene.simulate(start, Dop853::tolerance(1e-9), 0.1, |_| ())?.motion;",
        }
    }
}

/// The program. `round` makes each text a new one.
fn program(uses: &Use, round: usize) -> String {
    let body = |i: usize| match i % 3 {
        0 => format!("Rod::uniform(0.1, {:?})", 1.0 + i as f64),
        1 => format!("RigidBody::new({:?}, 0.01, [0.05, 0.01], [0.1, 0.02])", 1.0 + i as f64),
        _ => format!("PointMass::new(0.1, {:?})", 1.0 + i as f64),
    };
    let items: Vec<String> =
        (0..2 * BODIES - 1).map(|k| if k % 2 == 0 { body(k / 2) } else { "Pin".to_owned() }).collect();
    let mut text = format!("// Round {round}.\nuse catena::planar::*;\n\nfn main() -> Result<(), catena::Error> {{\n");
    text += "    let chain = (\n";
    for group in items.chunks(GROUP) {
        _ = writeln!(text, "        ({},),", group.join(", "));
    }
    text += "    );\n    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);\n";
    _ = writeln!(text, "    let start = scene.at_rest(&[0.1; {BODIES}])?;\n    {}", uses.statement());
    text += "    println!(\"{:?}\", scene.angles(&motion)?.get(59));\n    Ok(())\n}\n";
    text
}

fn main() -> Result<(), Box<dyn Error>> {
    let library = Path::new(env!("CARGO_MANIFEST_DIR"));
    let user = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("compile_time");
    fs::create_dir_all(user.join("src"))?;
    let package = "[package]\nname = \"user\"\nedition = \"2024\"\n[workspace]\n";
    let manifest = format!("{package}[dependencies]\ncatena = {{ path = {library:?} }}\n");
    fs::write(user.join("Cargo.toml"), manifest)?;
    // The same versions, from what is already downloaded.
    fs::copy(library.join("Cargo.lock"), user.join("Cargo.lock"))?;

    println!("| {BODIES} bodies in nested tuples | profile | fastest build, s | median, s | target {TARGET} s |");
    println!("|---|---|---:|---:|---|");
    for uses in [Use::Accelerations, Use::Simulation] {
        for profile in ["dev", "release"] {
            let mut times = Vec::new();
            for round in 0..=ROUNDS {
                progress(&format!("{}, {profile}: build {round} of {ROUNDS}", uses.name()));
                fs::write(user.join("src/main.rs"), program(&uses, round))?;
                let start = Instant::now();
                let output = Command::new(env!("CARGO"))
                    .args(["build", "--quiet", "--offline", "--profile", profile, "--target-dir", "target"])
                    .env("CARGO_INCREMENTAL", "0") // every build a whole one
                    .current_dir(&user)
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
            let best = times[0];
            let verdict = if best < TARGET { "met" } else { "missed" };
            println!("| {} | {profile} | {best:.2} | {middle:.2} | {verdict} |", uses.name());
        }
    }
    Ok(())
}
