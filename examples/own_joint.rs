//! A joint of one's own.

#[path = "elements/geared.rs"]
mod geared;

use catena::element::Unloaded;
use catena::planar::*;
use geared::Geared;

fn main() -> Result<(), catena::Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let motor = Geared { kinematics: Revolute::smooth(), rotor: 1e-4, ratio: 50.0, friction: 0.0 };
    let arm = System::new(Clamped::at(0.0, 0.0, 0.0), (motor, rod, motor, rod), Free)?.with_gravity(9.81);
    let start = arm.at_rest(&[-1.0, -0.5])?;
    let e0 = arm.budget(&start).energy();
    let mut worst: f64 = 0.0;
    arm.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| worst = worst.max((now.budget().energy() - e0).abs()))?;
    println!("{worst:e}");
    let rest = arm.at_rest(&[-1.5707963267948966, -1.5707963267948966])?;
    let modes = arm.modes(&rest, &Unloaded)?;
    println!("{:?}", modes.frequencies().collect::<Vec<_>>());

    spatial_arm()?;
    Ok(())
}
fn spatial_arm() -> Result<(), catena::Error> {
    use catena::spatial::*;
    let rod = Rod::uniform(1.0_f64, 0.1, 1.0);
    let motor = Geared { kinematics: Revolute::about([0.0, 0.0, 1.0]), rotor: 1e-4, ratio: 50.0, friction: 0.0 };
    let arm = System::new(Clamped::origin(), (motor, rod, motor, rod), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let start = arm.at_rest(&[-1.0, 0.5])?;
    let e0 = arm.budget(&start).energy();
    let mut worst: f64 = 0.0;
    arm.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| worst = worst.max((now.budget().energy() - e0).abs()))?;
    println!("{worst:e}");
    Ok(())
}
