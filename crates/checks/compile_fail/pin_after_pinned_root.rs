//! The root is a pin already: the chain starts with a body.
//@ `Pin`
//@ put a body between two pins

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (Pin, rod), Free)?;
    Ok(())
}
