//! The tip of an arm is free as it is, and takes no end.
//@ `Free` cannot take what lies outboard of it
//@ end a chain with a body

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Branch((Pin, rod, Free)), Pin, rod), Free)?;
    Ok(())
}
