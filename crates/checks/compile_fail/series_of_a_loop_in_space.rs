//! No Taylor series of forces that turn with the bodies of a loop is known.
//@ `Taylor` knows no series of loops that `
//@ Revolute<

use catena::spatial::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let arms = Network::new((Ball, rod), (Ball, rod), Revolute::about([0.0, 1.0, 0.0]));
    let scene = System::new(Pinned::origin(), (rod, arms, Ball, rod), Free)?;
    Taylor::<12>::knows(&scene);
    Ok(())
}
