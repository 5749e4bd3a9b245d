//! Writes modules of the robots of `catena-urdf`, with the furniture of their joints as laws.

use catena_urdf::{Base, Elements, Laws, Options, module};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let laws = Laws::none().damping().friction([0.05, 0.01]).stops([0.02, 0.002], [1.0, 10.0]).motors();
    let local = Options::new().elements(Elements::Local).laws(laws);
    write("arm7", "arm7", &local)?;
    write("arm7", "arm7_bare", &Options::new().elements(Elements::Local))?;
    write("quadruped", "quadruped", &local.clone().snap(1e-4))?;
    write("quadruped", "sticking_quadruped", &local.clone().snap(1e-4).laws(laws.sticking()))?;
    write("arm7", "sticking_arm7", &Options::new().laws(laws.sticking()))?;
    write("arm7", "bounded_arm7", &Options::new().elements(Elements::Local).laws(laws.sticking().hard_stops(0.2)))?;
    write("arm7", "striking_arm7", &Options::new().laws(Laws::none().damping().hard_stops(0.2)))?;
    write("humanoid", "humanoid", &local.base(Base::Floating))?;
    write("cart", "cart", &Options::new().repair().laws(laws))?;
    Ok(())
}

/// Writes a module of a robot, with a name of its own.
fn write(robot: &str, name: &str, options: &Options) -> Result<(), Box<dyn Error>> {
    let path = format!("../catena-urdf/robots/{robot}.urdf");
    println!("cargo::rerun-if-changed={path}");
    let robot = options.read(&std::fs::read_to_string(path)?)?;
    let folder = std::env::var("OUT_DIR")?;
    std::fs::write(Path::new(&folder).join(name).with_extension("rs"), module(&robot, name))?;
    Ok(())
}
