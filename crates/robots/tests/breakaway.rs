//! Joints with Coulomb's friction: lists of torques reach them, many break away at once, and rates set by hand change their modes.

use catena::planar::*;
use catena::{Error, Fault, Place, robot::Torques, spatial};
use catena_oracle::near;
use std::f64::consts::FRAC_PI_2;

#[test]
fn lists_of_torques_reach_joints_that_stick_and_slip() -> Result<(), Error> {
    use spatial::*;
    let body =
        RigidBody::new(2.0, [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]], [0.3, 0.0, 0.0], [0.6, 0.0, 0.0]);
    let hinge = Revolute::about([0.0, 0.0, 1.0]);
    let rubbing = System::new(Clamped::origin(), (Coulomb::new(hinge, 0.5), body, hinge, body), Free)?;
    let smooth = System::new(Clamped::origin(), (hinge, body, hinge, body), Free)?;
    let rates = [0.3, -0.2];
    let found = rubbing.with_accelerations(rubbing.with_rates(rubbing.motion(), &rates)?, &Torques([2.0, 1.0]))?;
    let expected = smooth.with_accelerations(smooth.with_rates(smooth.motion(), &rates)?, &Torques([1.5, 1.0]))?;
    found.accelerations().iter().zip(expected.accelerations()).for_each(|(a, b)| near(*a, b, 1e-13));
    let short = rubbing.with_accelerations(rubbing.motion(), &Torques([2.0])).unwrap_err();
    assert_eq!(short.fault, Fault::Count { list: "torques", expected: 2, given: 1 });
    // What is not finite is named, in a joint that sticks and beyond it.
    for (torques, place) in [([0.0, f64::NAN], Place::Station(2)), ([f64::NAN, 0.0], Place::Station(0))] {
        let error = rubbing.with_accelerations(rubbing.motion(), &Torques(torques)).unwrap_err();
        assert_eq!((error.fault, error.place), (Fault::NonFiniteLoad, Some(place)));
    }
    Ok(())
}

/// Blocks side by side that gravity draws down their tracks.
#[test]
fn a_hundred_joints_break_away_at_once() -> Result<(), Box<dyn std::error::Error>> {
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let track = Coulomb::new(Slider::along(FRAC_PI_2), 10.0).breaking_away(12.0);
    let frame = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let chain = (Weld::at(0.0), frame, vec![Branch((track, block)); 100]);
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity(9.81);
    let end = scene.simulation(Dop853::tolerance(1e-9)).run(scene.motion(), 0.5, |_| ())?.motion;
    end.coordinates().iter().for_each(|place| near(*place, -0.5 * (9.81 - 5.0) * 0.25, 1e-12));
    Ok(())
}

/// Drawn by a force that grows as fast as friction is used up just where a step of many sizes ends.
#[test]
fn a_joint_breaks_away_where_a_step_ends() -> Result<(), Box<dyn std::error::Error>> {
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    for (breaking, from) in [(3.6, 0.72), (3.0, 0.6)] {
        let track = Coulomb::new(Slider::along(0.0), 3.0).breaking_away(breaking);
        let scene = System::new(Clamped::origin(), (track, block), Free)?;
        let pull = |time: f64, joint: usize, _: &JointMotion<f64>| if joint == 1 { 5.0 * time } else { 0.0 };
        let loads = Loads::none().in_joints(pull);
        let pulled = 1.5_f64.powi(3) / 6.0 - 0.75 * from * from + from.powi(3) / 3.0;
        let place = (5.0 * pulled - 1.5 * (1.5 - from) * (1.5 - from)) / 2.0;
        macro_rules! runs {
            ($($rule:expr, $bound:expr);*) => {$(
                let end = scene.simulation($rule).loads(&loads).run(scene.motion(), 1.5, |_| ())?.motion;
                near(end.coordinates()[0], place, $bound);
            )*};
        }
        for step in [0.02, 0.01, 0.008, 0.007, 1e-3] {
            runs!(Rk4::step(step), 1e-12; Dopri5::step(step), 1e-12; Sdirk4::new().step(step), 1e-12);
            runs!(GeneralizedAlpha::new(0.8).step(step), 1e-3; Adams::step(step), 1e-12);
        }
        runs!(Dop853::tolerance(1e-9), 1e-12; Vcabm::new().tolerance(1e-9), 1e-11);
    }
    Ok(())
}

#[test]
fn friction_never_drives() -> Result<(), Box<dyn std::error::Error>> {
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let track = Coulomb::new(Slider::along(0.0), 10.0).breaking_away(12.0).with(Spring::new(200.0));
    let scene = System::new(Clamped::origin(), (track, block), Free)?;
    let start = scene.with_rates(scene.motion(), &[3.0])?;
    let end = scene.simulation(Dop853::tolerance(1e-9)).run(start, 0.05, |_| ())?.motion;
    assert!(end.rates()[0] > 1.0);
    // It slips forward; set by hand it slips back.
    let x = end.coordinates()[0];
    let mut turned = [end; 3];
    turned[0].set_rates(&[-1.0])?;
    *turned[1].rate_mut() = *scene.with_rates(scene.motion(), &[-1.0])?.rate();
    turned[2] = scene.with_rates(end, &[-1.0])?;
    for motion in turned {
        near(scene.with_accelerations(motion, &Unloaded)?.accelerations()[0], -100.0 * x + 5.0, 1e-12);
    }
    // Stepped by hand past the place where it comes to rest it is refused.
    let (mut stepper, mut now, mut next, mut steps) = (scene.stepper(Rk4), end, end, 0);
    let refused = loop {
        if let Err(error) = stepper.step(&now, &Unloaded, 0.02, &mut next) {
            break error;
        }
        std::mem::swap(&mut now, &mut next);
        steps += 1;
        assert!(steps < 100, "nothing was refused");
    };
    assert!(now.rates()[0] < 0.0);
    assert!(matches!(refused.fault, Fault::Unsupported { what } if what.contains("dry friction")), "{refused}");
    // A run goes on from there.
    let rest = scene.simulation(Dop853::tolerance(1e-9)).run(now, 9.0, |_| ())?.motion;
    assert_eq!(rest.rates(), [0.0]);
    Ok(())
}
