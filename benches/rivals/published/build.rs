//! Writes the module of the robot whose description the environment names: `DESCRIPTION` (a file), `BASE` (`fixed` or `floating`).

use catena_urdf::{Base, Carrier, Elements, Options, module};
use std::env::var;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=DESCRIPTION\ncargo::rerun-if-env-changed=BASE");
    let (file, floats) = (var("DESCRIPTION")?, var("BASE")? == "floating");
    println!("cargo::rerun-if-changed={file}\ncargo::rustc-check-cfg=cfg(floats)");
    if floats {
        println!("cargo::rustc-cfg=floats");
    }
    let base = if floats { Base::Floating } else { Base::Fixed };
    let options = Options::new().base(base).snap(1e-6).repair().elements(Elements::Local).without_test();
    let robot = options.read(&std::fs::read_to_string(file)?)?;
    let last = Carrier::Body(robot.bodies().len() - 1);
    let link = robot.frames().iter().find(|frame| frame.carrier == last).ok_or("no link on the last joint")?;
    let text = format!("{}\nconst LAST_LINK: [f64; 3] = {:?};\n", module(&robot, "robot"), link.pose.place);
    Ok(std::fs::write(Path::new(&var("OUT_DIR")?).join("robot.rs"), text)?)
}
