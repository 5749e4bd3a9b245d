//! An arm lives in the space of its chain.
//@ `catena::spatial::Rod<f64>` cannot take
//@ only elements of the chain's space `Planar<f64>` can

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let arm = (Pin, catena::spatial::Rod::uniform(1.0_f64, 0.1, 1.0));
    System::new(Pinned::origin(), (rod, Branch(arm), Pin, rod), Free)?;
    Ok(())
}
