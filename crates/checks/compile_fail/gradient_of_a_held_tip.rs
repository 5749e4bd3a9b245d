//! The costate sweep does not know tips that are held in space.
//@ no gradient of a run goes backward through the tip `
//@ not a tip that the costate sweep knows

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let arch = System::new(Pinned::origin(), (rod, Ball, rod), Pinned::on([1.0, 0.0, 0.0]))?;
    let _ = arch.backward(Rk4);
    Ok(())
}
