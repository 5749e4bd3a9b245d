//! Tuples of more than 16 are no chains: nest them, or use an array.
//@ is not an element of the chain's space
//@ tuples (to 16)

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let r = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (r, Pin, r, Pin, r, Pin, r, Pin, r, Pin, r, Pin, r, Pin, r, Pin, r), Free)?;
    Ok(())
}
