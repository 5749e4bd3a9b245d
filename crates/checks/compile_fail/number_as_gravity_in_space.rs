//! In space no axis is down by itself.
//@ gravity in space is a vector
//@ `[0.0, 0.0, -9.81]` where z points up

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.05, 1.0);
    System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity(9.81);
    Ok(())
}
