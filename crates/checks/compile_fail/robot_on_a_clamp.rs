//! On a clamp a robot begins with `BodyAxes`.
//@ a root cannot hold
//@ a robot begins with `BodyAxes`, unless it stands on a `Base`

use catena::robot::*;

fn main() -> Result<(), catena::Error> {
    let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    System::new(Clamped::origin(), (Hinge::level(), link), Free)?;
    Ok(())
}
