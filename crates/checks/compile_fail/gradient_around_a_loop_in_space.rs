//! The costate sweep does not know loops in space.
//@ no gradient of a run goes backward around
//@ Ball

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let net = Network::new((Ball, rod, Ball, rod), (Ball, rod, Ball, rod), Ball);
    let scene = System::new(Pinned::origin(), (rod, net), Free)?;
    let _ = scene.backward(Rk4);
    Ok(())
}
