//! No Taylor series of a tip on ground that moves is known.
//@ is held as `Taylor` knows no series of
//@ not a tip that has a series

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let shaken = Moving(|time: f64| GroundMotion {
        place: [1.0 + time, 0.0, 0.0],
        velocity: [1.0, 0.0, 0.0],
        acceleration: [0.0; 3],
    });
    let scene = System::new(Pinned::origin(), (rod, Ball, rod), Pinned::on(shaken))?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
