//! Bodies of a vector are asked for by number at run time.
//@ the number of bodies of `Vec<
//@ is not known at compile time
//@ ask for a body by number

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let rope = System::new(Pinned::origin(), (rod, vec![(Pin, rod); 9]), Free)?;
    rope.angles(&rope.motion())?.body::<5>();
    Ok(())
}
