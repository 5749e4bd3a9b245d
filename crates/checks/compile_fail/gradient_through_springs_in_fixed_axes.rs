//! By implicit rules the costate sweep does not know linear springs along axes that do not turn: these are named, wherever the hinge stands.
//@ no gradient of a run by an implicit rule goes backward through linear springs along axes
//@ not axes that the costate sweep knows

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let mount = ElasticHinge::rotary(1.0).with_linear(Spring::new(1e4), Spring::new(1e4)).in_fixed_axes();
    let cart = System::new(Pinned::origin(), (rod, Branch((mount, rod)), Pin, rod), Free)?;
    let _ = cart.backward(Rk4);
    let _ = cart.backward(Sdirk4::new());
    Ok(())
}
