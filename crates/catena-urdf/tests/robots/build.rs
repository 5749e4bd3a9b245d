//! Writes a module for each robot, as a user's build script does.

use catena_urdf::{Base, Error, Options};

fn main() -> Result<(), Error> {
    let robots = "../../robots";
    Options::new().build(format!("{robots}/arm7.urdf"))?;
    Options::new().snap(1e-4).build(format!("{robots}/quadruped.urdf"))?;
    Options::new().base(Base::Floating).build(format!("{robots}/humanoid.urdf"))?;
    Options::new().repair().build(format!("{robots}/cart.urdf"))?;
    Options::new().build("names.urdf")?;
    Ok(())
}
