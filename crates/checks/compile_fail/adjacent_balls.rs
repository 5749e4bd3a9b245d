//! Between two balls there is a body.
//@ a joint or a `Free` root needs a body on its outboard side
//@ put a body between two joints

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    System::new(Pinned::origin(), (rod, Ball, Ball, rod), Free)?;
    Ok(())
}
