//! The joint of a base takes inertial axes for those of what it bears, which a clamp may turn.
//@ an element of inertial axes meets
//@ `BodyAxes` leads there, first in the chain on a `Clamped` root, tilted or not

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let wall = Clamped::at([0.0; 3], Rotation::from_angles([0.3, 0.0, 0.0]));
    System::new(wall, (Upright, Hinge::level().grounded(), link), Free)?;
    Ok(())
}
