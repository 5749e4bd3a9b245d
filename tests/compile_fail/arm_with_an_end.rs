//! The tip of an arm is free as it is, and takes no end.
//@ `Free` is not an element of the chain's space `Planar<f64>`

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    System::new(Pinned::origin(), (rod, Branch((Pin, rod, Free)), Pin, rod), Free)?;
    Ok(())
}
