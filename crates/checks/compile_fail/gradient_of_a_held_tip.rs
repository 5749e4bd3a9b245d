//! The costate sweep does not know held tips.
//@ is held
//@ not a free tip

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let arch = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(1.0, 0.0))?;
    let _ = arch.backward(Rk4);
    Ok(())
}
