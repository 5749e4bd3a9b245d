//! Both arms of a loop live in the space of their chain.
//@ `catena::spatial::Rod<f64>` cannot take
//@ only elements of the chain's space `Planar<f64>` can

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let other = catena::spatial::Rod::uniform(1.0_f64, 0.1, 1.0);
    System::new(Pinned::origin(), (rod, Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, other), Pin)), Free)?;
    Ok(())
}
