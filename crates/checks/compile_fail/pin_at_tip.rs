//! A pin holds a body: at a free tip there is none.
//@ `Pin`
//@ end a chain with a body

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Pin), Free)?;
    Ok(())
}
