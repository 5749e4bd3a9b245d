//! No Taylor series of a loop in space is known.
//@ takes no walk

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let arms = Network::new((Ball, rod), (Ball, rod), Ball);
    let scene = System::new(Pinned::origin(), (rod, arms, Ball, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
