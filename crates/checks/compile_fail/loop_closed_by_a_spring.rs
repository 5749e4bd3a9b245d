//! Loops are cut at joints that hold two ends together.
//@ cannot close a loop
//@ in the plane `Pin` and `Weld` close loops

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let hinge = ElasticHinge::rotary(1.0);
    System::new(Pinned::origin(), (rod, Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), hinge)), Free)?;
    Ok(())
}
