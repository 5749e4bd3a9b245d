//! A root is an end, not an element.
//@ `Pin` cannot be the root of a chain

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pin, (rod, Pin, rod), Free)?;
    Ok(())
}
