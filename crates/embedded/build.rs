//! Writes the arm's module from its description.

use catena_urdf::{Elements, Options, module};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let path = "../catena-urdf/robots/arm7.urdf";
    println!("cargo::rerun-if-changed={path}");
    let robot = Options::new().elements(Elements::LocalGeneral).without_test().read(&std::fs::read_to_string(path)?)?;
    let folder = std::env::var("OUT_DIR")?;
    std::fs::write(Path::new(&folder).join("arm7.rs"), module(&robot, "arm7"))?;
    Ok(())
}
