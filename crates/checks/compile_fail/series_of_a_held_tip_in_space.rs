//! No Taylor series of a tip that is held in space is known.
//@ is held as `Taylor` knows no series of
//@ not a tip that has a series

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Ball, rod), Pinned::at([1.0, 0.0, 0.0]))?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
