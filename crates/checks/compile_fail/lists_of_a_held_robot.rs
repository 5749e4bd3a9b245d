//! Functions of lists are those of open robots: what holds a tip they do not know.
//@ functions of lists do not know it
//@ Flange<

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let elbow = Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>);
    let chain = (Hinge::level(), link, elbow, link, elbow, link, elbow, link, Flange::at([0.0, 0.0, 0.4]));
    let arm = System::new(Base::origin(), chain, Pinned::at([0.0, 0.0, 1.0]))?;
    arm.forward_dynamics(&[0.0; 4], &[0.0; 4], &[0.0; 4])?;
    Ok(())
}
