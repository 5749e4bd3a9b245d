//! The costate sweep does not know linear springs of elastic hinges in space.
//@ no gradient of a run goes backward through it
//@ not known to this walk

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let spring = Spring::stiffness(1.0);
    let hinge = ElasticHinge::rotary([1.0, 1.0, 1.0]).with_linear(spring, spring, spring);
    let chain = System::new(Pinned::origin(), (rod, Prismatic::along([1.0, 0.0, 0.0]), rod, hinge, rod), Free)?;
    let _ = chain.backward(Rk4);
    Ok(())
}
