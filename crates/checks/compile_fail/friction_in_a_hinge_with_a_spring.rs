//! Beside friction, springs are those of the joint with friction: a sweep would not know which of both laws acts while it sticks.
//@ is no joint that can be driven, stick or strike stops
//@ Axis<
//@ springs, dampers and laws go beside friction and stops

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let hinge = Hinge::at::<4>([0.0, 0.0, 0.4]).with(Spring::damping(0.5));
    System::new(Base::origin(), (Hinge::level(), link, Coulomb::new(hinge, 1.0), link), Free)?;
    Ok(())
}
