//! The plane and space do not mix.
//@ `Rod<f64>` is not an element of the chain's space `Spatial<f64>`
//@ not an element of `Spatial<f64>`

use catena::planar;
use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let flat = planar::Rod::uniform(1.0_f64, 1.0);
    System::new(Pinned::origin(), (Rod::uniform(1.0_f64, 0.1, 1.0), Ball, flat), Free)?;
    Ok(())
}
