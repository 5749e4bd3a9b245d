//! No Taylor series of loads that see a motion is known.
//@ `Taylor<12>` makes no steps of
//@ values or functions of time

use catena::planar::*;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    let brake = Loads::none().in_joints(|_, _, joint: &JointMotion<f64>| -joint.rate());
    scene.simulation(Taylor::<12>::tolerance(1e-9)).loads(&brake).run(scene.at_rest(&[0.0; 2])?, 1.0, |_| ())?;
    Ok(())
}
