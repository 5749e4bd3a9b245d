//! No Taylor series of forces that are chosen among many is known.
//@ `Taylor` knows no series of loops that `
//@ LeastNorm<Pin>

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let arms = Network::new((Pin, rod), (Pin, rod), LeastNorm(Pin));
    let scene = System::new(Pinned::origin(), (rod, arms, Pin, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
