//! No Taylor series of a tip that is held is known.
//@ knows no series of the forces of `Pinned<
//@ a tip that is held

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(1.0, 0.0))?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
