//! Functions of lists have no time that a driven joint could show.
//@ functions of lists do not know it
//@ Driven<
//@ joints that are driven or have modes they do not

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let elbow = Driven::new(Hinge::at::<4>([0.0, 0.0, 0.4]), |time: f64| [time, 1.0, 0.0]);
    let arm = System::new(Base::origin(), (Hinge::level(), link, elbow, link), Free)?;
    arm.forward_dynamics(&[0.0], &[0.0], &[0.0])?;
    Ok(())
}
