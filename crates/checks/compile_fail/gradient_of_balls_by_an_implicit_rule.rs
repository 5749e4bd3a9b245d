//! The costate sweep of an implicit rule does not know balls.
//@ no gradient of a run by an implicit rule goes backward through a `Ball`
//@ explicit rules know balls

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let scene = System::new(Clamped::origin(), (Revolute::about([0.0, 0.0, 1.0]), rod, Ball, rod), Free)?;
    let _ = scene.backward(Rk4);
    let _ = scene.backward(Sdirk4::new());
    Ok(())
}
