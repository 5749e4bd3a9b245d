//! A law of time gives one coordinate.
//@ is no joint that can be driven, stick or strike stops
//@ Ball
//@ `Driven`, `Coulomb` and `HardStops` take

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    System::new(Clamped::origin(), (Driven::new(Ball, |time: f64| [time, 1.0, 0.0]), rod), Free)?;
    Ok(())
}
