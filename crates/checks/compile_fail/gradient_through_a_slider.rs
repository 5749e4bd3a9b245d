//! The costate sweep does not know sliders: the element is named, wherever it stands in the chain.
//@ no gradient of a run goes backward through `Slider<
//@ not known to the costate sweep

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let cart = System::new(Pinned::origin(), (rod, Branch((Slider::along(0.0), rod)), Pin, rod), Free)?;
    let _ = cart.backward(Rk4);
    Ok(())
}
