//! Series of joint forces, from the series of a motion, against readings of runs by another rule.

use catena::scalar::{Powers, Scalar};
use catena::{Error, planar, spatial};

const P: usize = 24;
const STEP: f64 = 0.04; // (s)

/// The sum of a series at a time (s).
fn at(series: Powers<f64, P>, time: f64) -> f64 {
    series.terms().iter().rev().fold(0.0, |sum, term| sum * time + term)
}

/// The largest difference of forces and torques at all stations, relative to the largest: by series of a step, and by a run of the other rule.
macro_rules! off {
    ($space:ident, $scene:expr, $start:expr, |$internal:ident| $list:expr) => {{
        let (scene, start) = ($scene, $start);
        let (mut stepper, mut end) = (scene.stepper($space::Taylor::<P>), start.clone());
        Stepper::step(&mut stepper, &start, &Unloaded, STEP, &mut end)?;
        let lifted = scene.lift(Powers::<f64, P>::constant);
        let motion = lifted.with_accelerations(stepper.motion_series(), &Unloaded)?;
        let series: Vec<Powers<f64, P>> = lifted
            .stations(&motion, &Unloaded)?
            .iter()
            .flat_map(|station| {
                let $internal = station.internal;
                $list
            })
            .collect();
        let (mut worst, mut largest) = (0.0_f64, 1.0_f64);
        for share in [0.0, 0.5, 1.0] {
            let rule = $space::Dop853::tolerance(1e-14);
            let other = scene.simulation(rule).run(start.clone(), share * STEP, |_| ())?.motion;
            let found = scene.stations(&other, &Unloaded)?;
            let right = found.iter().flat_map(|station| {
                let $internal = station.internal;
                $list
            });
            for (series, right) in series.iter().zip(right) {
                worst = worst.max((at(*series, share * STEP) - right).abs());
                largest = largest.max(right.abs());
            }
        }
        println!("{worst:.1e} of {largest:.1e}"); // bounds are some thousand roundings, and what the other run errs by
        worst / largest
    }};
}

#[test]
fn of_pins_in_the_plane() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0, 1.0);
    let chain = (rod, Branch((Pin, rod)), Pin, rod);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.with_rates(scene.at_rest(&[-0.3, 0.4, 0.2])?, &[1.0, -2.0, 0.5])?;
    let off = off!(planar, scene, start, |internal| [internal.force.x, internal.force.y, internal.torque]);
    assert!(off < 1e-12);
    Ok(())
}

#[test]
fn of_a_tip_that_is_held() -> Result<(), Error> {
    use planar::*;
    let rod = |length| Rod::uniform(length, 1.0);
    let scene = System::new(Pinned::origin(), (rod(0.5), Pin, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    let scene = scene.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[1.0, 0.3, -2.0])?, &Unloaded)?;
    let off = off!(planar, scene, start, |internal| [internal.force.x, internal.force.y, internal.torque]);
    assert!(off < 1e-11);
    Ok(())
}

#[test]
fn of_balls_and_revolutes_in_space() -> Result<(), Error> {
    use spatial::*;
    let (rod, hinge) = (Rod::uniform(0.8, 0.05, 1.0), Revolute::about([0.3, 0.8, 0.5]));
    let scene = System::new(Pinned::origin(), (rod, Ball, rod, hinge, rod), Free)?.with_gravity([0.0, 0.0, -9.81]);
    let mut start = scene.at_rest(&[0.3, -0.2, 0.4, 0.5, 0.1, -0.3, 0.6])?;
    start.set_rates(&[1.0, -0.5, 0.7, 0.3, 0.9, -1.1, 0.8])?;
    let off = off!(spatial, scene, start, |internal| {
        let (force, torque) = (internal.force, internal.torque);
        [force.x, force.y, force.z, torque.x, torque.y, torque.z]
    });
    assert!(off < 1e-12);
    Ok(())
}
