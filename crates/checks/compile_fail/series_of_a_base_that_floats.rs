//! No Taylor series of a base that floats is known.
//@ is not known to stand on ground that rests
//@ a root that floats

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Free, (rod, Ball, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
