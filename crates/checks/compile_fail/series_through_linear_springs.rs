//! No Taylor series of hinges with linear springs is known.
//@ takes no walk
//@ knows no series of its motion

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let mount = ElasticHinge::rotary(1.0).with_linear(Spring::new(1e4), Spring::new(1e4));
    let scene = System::new(Pinned::origin(), (rod, mount, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
