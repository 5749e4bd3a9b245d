//! The costate sweep does not know hinges with linear springs: the element is named, wherever it stands in the chain.
//@ no gradient of a run goes backward through it
//@ not known to this walk

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let mount = ElasticHinge::rotary(1.0).with_linear(Spring::new(1e4), Spring::new(1e4));
    let cart = System::new(Pinned::origin(), (rod, Branch((mount, rod)), Pin, rod), Free)?;
    let _ = cart.backward(Rk4);
    Ok(())
}
