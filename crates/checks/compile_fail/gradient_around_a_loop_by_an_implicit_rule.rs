//! Nor loops.
//@ no gradient of a run by this implicit rule goes backward around loops

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let net = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
    let scene = System::new(Pinned::origin(), (rod, net), Free)?;
    let _ = scene.backward(Sdirk4::new());
    Ok(())
}
