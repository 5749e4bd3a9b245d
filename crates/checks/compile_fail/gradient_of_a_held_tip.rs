//! The costate sweep does not know tips that move: parameters in their motion would be lost.
//@ no gradient of a run goes backward through the tip `
//@ not a tip that the costate sweep knows

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let shaken = |t: f64| GroundMotion {
        place: [1.0 + t.sin(), 0.0, 0.0],
        velocity: [t.cos(), 0.0, 0.0],
        acceleration: [-t.sin(), 0.0, 0.0],
    };
    let arch = System::new(Pinned::origin(), (rod, Ball, rod), Pinned::on(Moving(shaken)))?;
    let _ = arch.backward(Rk4);
    Ok(())
}
