//! A stepper is told the size of every step: it takes a method alone.
//@ makes no stepper
//@ told the size of every step
//@ takes a method alone, `Rk4`

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let now = pendulum.at_rest(&[-1.0, -0.5])?;
    let mut next = now;
    pendulum.stepper(Rk4::step(1e-3)).step(&now, &Unloaded, 1e-3, &mut next)
}
