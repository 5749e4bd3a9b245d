//! No Taylor series of elastic balls is known.
//@ takes no walk
//@ knows no series of its motion

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Pinned::origin(), (rod, ElasticBall::rotary([1.0; 3]), rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
