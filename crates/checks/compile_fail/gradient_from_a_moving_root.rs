//! The costate sweep does not know roots that move: parameters in their motion would be lost.
//@ is not known to stand on ground that rests
//@ a ground that may move

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let shaken =
        |t: f64| GroundMotion { place: [t.sin(), 0.0], velocity: [t.cos(), 0.0], acceleration: [-t.sin(), 0.0] };
    let pendulum = System::new(Pinned::on(Moving(shaken)), (rod, Pin, rod), Free)?;
    let _ = pendulum.backward(Rk4);
    Ok(())
}
