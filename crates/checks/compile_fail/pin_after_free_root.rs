//! A free root holds a body, not a pin.
//@ `Free`
//@ start a chain with a body

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Free, (Pin, rod), Free)?;
    Ok(())
}
