//! A scene has one scalar.
//@ `Rod<f32>` is not an element of the chain's space `Planar<f64>`
//@ one scalar

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    System::new(Pinned::origin(), (Rod::uniform(1.0_f64, 1.0), Pin, Rod::uniform(1.0_f32, 1.0)), Free)?;
    Ok(())
}
