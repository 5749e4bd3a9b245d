//! A string is no element.
//@ `String` is not an element of the chain's space

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Pin, String::new(), rod), Free)?;
    Ok(())
}
