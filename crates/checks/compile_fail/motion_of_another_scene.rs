//! A motion belongs to scenes of its own shape.
//@ mismatched types
//@ found `Motion<

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let single = System::new(Pinned::origin(), rod, Free)?;
    let double = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let start = single.at_rest(&[0.0])?;
    double.simulate(start, Rk4::step(1e-3), 1.0, |_| ())?;
    Ok(())
}
