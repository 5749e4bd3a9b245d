//! A run chooses its steps: it takes a rule.
//@ `Rk4` does not say how long the steps of a run are
//@ `Rk4::step(0.001)` for steps of one size
//@ `Dop853::tolerance(1e-9)` for error control

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let start = pendulum.at_rest(&[-1.0, -0.5])?;
    pendulum.simulate(start, Rk4, 1.0, |_| ())?;
    Ok(())
}
