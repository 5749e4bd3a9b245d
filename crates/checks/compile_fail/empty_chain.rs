//! A chain has at least one element.
//@ `()` is not an element of the chain's space

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    System::new(Pinned::<[f64; 2]>::origin(), (), Free)?;
    Ok(())
}
