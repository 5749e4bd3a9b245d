//! An end belongs at an end, not inside the chain.
//@ `Free` is not an element of the chain's space

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Free, rod), Free)?;
    Ok(())
}
