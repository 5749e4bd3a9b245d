//! A tip is an end, not a chain.
//@ `(Pin, Rod<{float}>)` cannot be the tip of a chain

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Pin, rod), (Pin, rod))?;
    Ok(())
}
