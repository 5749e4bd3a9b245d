//! No Taylor series of a ground that is a function of time is known.
//@ is not known to stand on ground that rests
//@ a ground that may move

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let still = GroundMotion { place: [0.0_f64; 2], velocity: [0.0; 2], acceleration: [0.0; 2] };
    let scene = System::new(Pinned::on(Moving(move |_: f64| still)), (rod, Pin, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
