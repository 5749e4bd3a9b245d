//! A double pendulum has no body number 5.
//@ this chain has no body number 5

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let start = pendulum.at_rest(&[0.0, 0.0])?;
    pendulum.angles(&start)?.body::<5>();
    Ok(())
}
