//! A base is not tilted by a weld: that is a clamp, from which `BodyAxes` lead.
//@ an element of inertial axes meets
//@ `BodyAxes` leads there, first in the chain on a `Clamped` root, tilted or not

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let tilt = Weld::at(Rotation::from_angles([0.3, 0.0, 0.0]));
    System::new(Base::origin(), (tilt, Hinge::level().grounded(), link), Free)?;
    Ok(())
}
