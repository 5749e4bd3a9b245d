//! How long a user waits: the time to compile a program with a chain of sixty bodies of three kinds and the pins
//! between them, in nested tuples of different types, when catena itself is already built.
//!
//! `cargo bench --bench compile_time`

#[path = "parts/builds.rs"]
mod builds;
#[path = "parts/clock.rs"]
mod clock;

use builds::User;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

const BODIES: usize = 60;
/// Items of an inner tuple.
const GROUP: usize = 15;
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
    let user = User::named("compile_time", Path::new(env!("CARGO_MANIFEST_DIR")))?;
    println!("| {BODIES} bodies in nested tuples | profile | fastest build, s | median, s | target {TARGET} s |");
    println!("|---|---|---:|---:|---|");
    for uses in [Use::Accelerations, Use::Simulation] {
        for profile in ["dev", "release"] {
            let [best, middle] = user.seconds(uses.name(), profile, |round| program(&uses, round))?;
            let verdict = if best < TARGET { "met" } else { "missed" };
            println!("| {} | {profile} | {best:.2} | {middle:.2} | {verdict} |", uses.name());
        }
    }
    Ok(())
}
