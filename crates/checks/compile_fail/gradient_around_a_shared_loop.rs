//! Forces that are chosen among many have no costates.
//@ no gradient of a run goes backward around a loop that `
//@ LeastNorm<Pin>

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let net = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), LeastNorm(Pin));
    let scene = System::new(Pinned::origin(), (rod, net), Free)?;
    let _ = scene.backward(Rk4);
    Ok(())
}
