//! The tip of an arm is free: a pin there holds nothing.
//@ `Pin`
//@ end a chain with a body

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Branch((Pin, rod, Pin)), Pin, rod), Free)?;
    Ok(())
}
