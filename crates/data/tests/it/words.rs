//! Errors, and scenes with names: what has words is read from text that outlives it.

use catena::planar::*;
use catena::{Cause, Error, Fault, Place};

fn again(error: Error) {
    let text: &'static str = serde_json::to_string(&error).unwrap().leak();
    assert_eq!(serde_json::from_str::<Error>(text).unwrap(), error, "{text}");
}

#[test]
fn errors_are_data() -> Result<(), Error> {
    let refused = System::new(Pinned::origin(), Rod::uniform(-1.0, 1.0), Free).err().unwrap();
    again(refused);
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin.named("elbow"), rod), Free)?;
    again(scene.joint("a name that is longer than labels are").unwrap_err());
    again(scene.joint("knee").unwrap_err());
    again(Error::new(Fault::StepTooSmall { step: 1e-20, cause: Cause::SingularJoint }).at(Place::Tip).at_time(0.5));
    Ok(())
}

#[test]
fn names_are_read_with_their_scene() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin.named("elbow"), rod), Free)?;
    let text: &'static str = serde_json::to_string(&scene).unwrap().leak();
    let mut read = Some(scene);
    read = read.and(serde_json::from_str(text).unwrap());
    assert_eq!(read.unwrap().joint("elbow")?.joint, 1);
    Ok(())
}
