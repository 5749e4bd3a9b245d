//! The costate sweep does not know what a multistep rule carries from step to step.
//@ no gradient of a run goes backward through the rule `
//@ Adams

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, ElasticHinge::rotary(1.0), rod), Free)?;
    let _ = scene.backward(Adams);
    Ok(())
}
