//! Arms of a loop end with bodies: the joint that closes it is its last.
//@ needs a body on its outboard side

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    System::new(Pinned::origin(), (rod, Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin), Pin)), Free)?;
    Ok(())
}
