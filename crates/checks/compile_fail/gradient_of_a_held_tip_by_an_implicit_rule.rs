//! The costate sweep of a rule that puts tips back in each sweep does not know them.
//@ no gradient of a run by `
//@ Sdirk4
//@ none where a tip is held

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let (rod, hinge) = (Rod::uniform(1.0, 1.0), ElasticHinge::rotary(1.0));
    let arch = System::new(Pinned::origin(), (rod, hinge, rod, hinge, rod), Pinned::at(2.0, 0.0))?;
    let _ = arch.backward(Sdirk4::new());
    Ok(())
}
