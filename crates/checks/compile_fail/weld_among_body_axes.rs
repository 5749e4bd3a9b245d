//! Among body axes bodies are turned by the joints that carry them: a sweep would not see the turn of a weld.
//@ an element of inertial axes meets
//@ among body axes joints say themselves how they are turned on their parent: `Hinge::turned`

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let turn = Weld::at(Rotation::from_angles([0.3, 0.0, 0.0]));
    System::new(Base::origin(), (Hinge::level(), link, turn, Hinge::at::<4>([0.0, 0.0, 0.4]), link), Free)?;
    Ok(())
}
