//! A driven joint of a robot carries a link.
//@ a joint in body axes needs a `Link` on its outboard side
//@ Empty

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let wrist = Driven::new(Hinge::at::<4>([0.0, 0.0, 0.4]), |time: f64| [time, 1.0, 0.0]);
    System::new(Base::origin(), (Hinge::level(), link, wrist), Free)?;
    Ok(())
}
