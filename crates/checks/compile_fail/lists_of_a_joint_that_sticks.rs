//! Functions of lists know no modes of joints.
//@ functions of lists do not know it
//@ Guarded<
//@ joints that are driven or have modes they do not

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let elbow = Coulomb::new(Hinge::at::<4>([0.0, 0.0, 0.4]), 1.0);
    let arm = System::new(Base::origin(), (Hinge::level(), link, elbow, link), Free)?;
    arm.forward_dynamics(&[0.0; 2], &[0.0; 2], &[0.0; 2])?;
    Ok(())
}
