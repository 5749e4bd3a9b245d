//! How long a user waits: the time to compile a program that steps a humanoid of 29 joints, whose base floats, from its description, when the
//! library is already built.
//!
//! ```text
//! cargo bench -p catena-robots --bench compile_time
//! ```

#[path = "../../../benches/parts/builds.rs"]
mod builds;
#[path = "../../../benches/parts/clock.rs"]
mod clock;

use builds::User;
use std::error::Error;
use std::path::Path;

/// What is aimed at in debug builds (s).
const TARGET: f64 = 3.0;

/// Types, values and constants of the humanoid, and its test.
const MODULE: &str = include_str!(concat!(env!("OUT_DIR"), "/humanoid.rs"));

/// The program: accelerations, or steps. `round` makes each text a new one.
fn program(statement: &str, round: usize) -> String {
    format!(
        "// Round {round}.\n{MODULE}\nuse catena::robot::*;\n\nfn main() -> Result<(), catena::Error> {{
    let scene = humanoid::scene::<f64>()?;
    let start = scene.motion();
    {statement}
    println!(\"{{:?}}\", motion.coordinates());
    Ok(())
}}\n"
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let user = User::named("compile_time_of_a_humanoid", &Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))?;
    println!("| a humanoid of 29 joints | profile | fastest build, s | median, s | target {TARGET} s |");
    println!("|---|---|---:|---:|---|");
    for (name, statement) in [
        ("forward dynamics", "let motion = scene.with_accelerations(start, &Unloaded)?;"),
        (
            "a step of RK4",
            "let mut motion = start;\n    scene.stepper(Rk4).step(&start, &Unloaded, 1e-3, &mut motion)?;",
        ),
        (
            "a run by MoreauJean",
            "let motion = scene.simulation(MoreauJean::step(1e-3)).run(start, 0.1, |_| ())?.motion;",
        ),
    ] {
        for profile in ["dev", "release"] {
            let [best, middle] = user.seconds(name, profile, |round| program(statement, round))?;
            let verdict = match profile {
                "dev" if best < TARGET => "met",
                "dev" => "missed",
                _ => "",
            };
            println!("| {name} | {profile} | {best:.2} | {middle:.2} | {verdict} |");
        }
    }
    Ok(())
}
