//! Functions of lists take the base as fixed: they do not know a robot that floats.
//@ not a fixed base
//@ they know `Base`, and `Clamped` where `BodyAxes` comes first in the chain

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    let robot = System::new(Free, (BodyAxes, link, Hinge::at::<4>([0.0, 0.0, 0.4]), link), Free)?;
    let _ = robot.forward_dynamics(&[0.3], &[0.0], &[1.0])?;
    Ok(())
}
