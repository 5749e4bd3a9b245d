//! The costate sweep does not know tips that turn with the ground: their directions would be taken for those of one time.
//@ no gradient of a run goes backward through the tip `
//@ not a tip that the costate sweep knows

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let turning = |t: f64| AttitudeMotion {
        attitude: Rotation::from_angles([0.0, 0.0, 0.1 * t]),
        spin: [0.0, 0.0, 0.1],
        acceleration: [0.0; 3],
    };
    let arch = System::new(Pinned::origin(), (rod, Ball, rod), Clamped::on([1.0, 0.0, 0.0], Turning(turning)))?;
    let _ = arch.backward(Rk4);
    Ok(())
}
