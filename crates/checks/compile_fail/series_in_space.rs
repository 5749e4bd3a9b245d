//! No Taylor series of a motion in space is known.
//@ knows no motion in `
//@ runs scenes of the plane

use catena::spatial::*;
use catena::time::Taylor;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Ball, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
