//! Joints that strike stops close no loop, in axes of bodies as elsewhere.
//@ cannot close a loop
//@ Guarded<Axis<
//@ Range<

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let hinge = Hinge::at::<4>([0.0, 0.0, 0.4]);
    let (arm, closing) = ((Hinge::level(), link, hinge, link), HardStops::between(hinge, [-1.0, 1.0]));
    System::new(Base::origin(), (Hinge::level(), link, Network::new(arm, arm, closing)), Free)?;
    Ok(())
}
