//! No Taylor series of a loop is known.
//@ takes no walk

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Network::new((Pin, rod), (Pin, rod), Pin), Pin, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
