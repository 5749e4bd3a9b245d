//! An arm lives in the space of its chain.
//@ `catena::spatial::Rod<f64>` is not an element of the chain's space `Planar<f64>`

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let arm = (Pin, catena::spatial::Rod::uniform(1.0, 0.1, 1.0));
    System::new(Pinned::origin(), (rod, Branch(arm), Pin, rod), Free)?;
    Ok(())
}
