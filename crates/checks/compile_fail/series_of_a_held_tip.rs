//! No Taylor series of a tip on ground that moves is known.
//@ is held as `Taylor` knows no series of
//@ not a tip that has a series

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let shaken =
        Moving(|time: f64| GroundMotion { place: [1.0 + time, 0.0], velocity: [1.0, 0.0], acceleration: [0.0; 2] });
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::on(shaken))?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
