//! Writes a module for each robot, as a user's build script does.

use catena_urdf::{Base, Elements, Error, Laws, Options, Robot, module};
use std::path::Path;

fn main() -> Result<(), Error> {
    let robots = "../../robots";
    Options::new().build(format!("{robots}/arm7.urdf"))?;
    Options::new().snap(1e-4).build(format!("{robots}/quadruped.urdf"))?;
    Options::new().base(Base::Floating).build(format!("{robots}/humanoid.urdf"))?;
    Options::new().repair().build(format!("{robots}/cart.urdf"))?;
    let laws = Laws::none().damping().friction([0.1; 2]).stops([0.02; 2], [1.0; 2]).motors();
    // A module of the whole stem, dot and all.
    Options::new().laws(laws).build("odd.names.urdf")?;
    // In body axes, with zeros as types and without.
    local("arm7", Options::new());
    local("quadruped", Options::new().snap(1e-4));
    local("humanoid", Options::new().base(Base::Floating));
    local("cart", Options::new().repair());
    let stood = Options::new().base(Base::Fixed).snap(1e-4).elements(Elements::Local).read(&text("quadruped"))?;
    write("quadruped_fixed", &stood);
    Ok(())
}

fn text(name: &str) -> String {
    std::fs::read_to_string(format!("../../robots/{name}.urdf")).expect("a description")
}

/// Writes the module of a robot.
fn write(name: &str, robot: &Robot) {
    let folder = std::env::var("OUT_DIR").expect("a folder");
    std::fs::write(Path::new(&folder).join(format!("{name}.rs")), module(robot, name)).expect("a place");
}

/// Writes the modules of a robot in body axes, of names of their own.
fn local(name: &str, options: Options) {
    let text = text(name);
    for (elements, suffix) in [(Elements::Local, "local"), (Elements::LocalGeneral, "general")] {
        let robot = options.clone().elements(elements).read(&text).expect("a robot");
        write(&format!("{name}_{suffix}"), &robot);
    }
}
