//! Modes of vibration where something turns, slides or falls, and in single precision.

use catena::planar::*;
use catena::{Error, Fault, spatial};
use catena_oracle::near;
use std::f64::consts::FRAC_PI_2;

const G: f64 = 9.81;

/// A mass on springs along both axes of a platform that turns: its modes whirl at ω₀ ± Ω, and M and K know nothing of it.
#[test]
fn what_turns_is_refused_at_its_station() -> Result<(), Error> {
    let light = RigidBody::new(1e-6, 1e-6, [0.0; 2], [0.0; 2]);
    let mass = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let track = |angle| Slider::along(angle).with(Spring::new(50.0));
    let frame = (light, track(0.0), light, track(FRAC_PI_2), mass);
    for (rate, turns) in [(3.0, true), (0.0, false)] {
        let turn = Driven::new(Revolute::smooth(), move |t: f64| [rate * t, rate, 0.0]);
        let driven = System::new(Clamped::origin(), (turn, frame), Free)?;
        let found = driven.modes(&driven.motion(), &Unloaded);
        let turning = Turning(move |_: f64| [0.0, rate, 0.0]);
        let ground = System::new(Clamped::on([0.0; 2], turning), frame, Free)?;
        let under = ground.modes(&ground.motion(), &Unloaded);
        for found in [found, under] {
            match found {
                Ok(modes) if !turns => modes.frequencies().for_each(|w| near(w, 5.0, 1e-5)),
                Err(Error { fault: Fault::Unsupported { what }, place: Some(_), .. }) if turns => {
                    assert!(what.contains("drive"), "{what}");
                }
                other => panic!("{other:?}"),
            }
        }
    }
    // A winch: its rope dampens the swing.
    let winch = Driven::new(Slider::along(0.0), |t: f64| [0.1 * t, 0.1, 0.0]);
    let rope = System::new(Pinned::origin(), (light, winch, mass), Free)?.with_gravity(G);
    assert!(matches!(
        rope.modes(&rope.at_rest(&[-FRAC_PI_2])?, &Unloaded).unwrap_err().fault,
        Fault::Unsupported { .. }
    ));
    Ok(())
}

#[test]
fn what_moves_alike_at_all_places_has_modes() -> Result<(), Error> {
    let (rod, wheel) = (Rod::uniform(0.5, 1.0), RigidBody::new(2.0, 0.3, [0.0; 2], [0.0; 2]));
    let welded = System::new(Pinned::origin(), (rod, Weld::at(0.0), wheel), Free)?.with_gravity(G);
    let expected: Vec<f64> = welded.modes(&welded.at_rest(&[-FRAC_PI_2])?, &Unloaded)?.frequencies().collect();
    // On a cart at constant speed, with a wheel that a motor turns about its mass centre.
    let cart = Driven::new(Slider::along(0.0), |t: f64| [2.0 * t, 2.0, 0.0]);
    let motor = Driven::new(Revolute::smooth(), |t: f64| [30.0 * t, 30.0, 0.0]);
    let carried = (cart, RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]), Pin, rod, motor, wheel);
    let scene = System::new(Clamped::origin(), carried, Free)?.with_gravity(G);
    let found = scene.modes(&scene.at_rest(&[-FRAC_PI_2])?.at_time(0.7), &Unloaded)?;
    assert_eq!(found.len(), 1);
    found.frequencies().zip(&expected).for_each(|(found, expected)| near(found, *expected, 1e-12));
    Ok(())
}

#[test]
fn rotors_in_space_are_refused() -> Result<(), Error> {
    use spatial::*;
    let ring = RigidBody::new(0.5, [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.03]], [0.0; 3], [0.0; 3]);
    let hinge = |axis| Revolute::about(axis).with(Spring::new(4.0));
    for (rate, turns) in [(40.0, true), (0.0, false)] {
        let motor = Driven::new(Revolute::about([0.0, 0.0, 1.0]), move |t: f64| [rate * t, rate, 0.0]);
        let gimbal = (hinge([1.0, 0.0, 0.0]), ring, hinge([0.0, 1.0, 0.0]), ring, motor, ring);
        let scene = System::new(Clamped::origin(), gimbal, Free)?;
        let found =
            scene.modes(&scene.motion(), &spatial::Unloaded).map(|modes| modes.len()).map_err(|error| error.fault);
        assert_eq!(matches!(found, Err(Fault::Unsupported { .. })), turns, "{found:?}");
    }
    Ok(())
}

#[test]
fn what_falls_is_not_at_rest() -> Result<(), Error> {
    let rod = Rod::uniform(0.1, 0.1);
    let blade = System::new(Free, (rod, [(ElasticHinge::rotary(10.0), rod); 3]), Free)?;
    assert_eq!(blade.modes(&blade.at_rest(&[0.4; 4])?, &Unloaded)?.len(), 6);
    let falls = blade.with_gravity(G);
    let error = falls.modes(&falls.at_rest(&[0.4; 4])?, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::NotAtRest { distance: f64::INFINITY }), "{error}");
    // On level ground nothing falls.
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::origin(), (Slider::along(std::f64::consts::PI), block), Free)?.with_gravity(G);
    assert_eq!(scene.modes(&scene.motion(), &Unloaded)?.len(), 1);
    Ok(())
}

#[test]
fn single_precision_has_modes() -> Result<(), Error> {
    let (upper, lower) = (Rod::uniform(0.7, 1.3), Rod::uniform(0.45, 0.6));
    let pendulum = System::new(Pinned::origin(), (upper, Pin, lower), Free)?.with_gravity(G);
    let blade = (Rod::uniform(0.3, 1.0), [(ElasticHinge::rotary(10.0), Rod::uniform(1.7, 4.0)); 5]);
    let blade = System::new(Free, blade, Free)?;
    macro_rules! in_both {
        ($scene:expr, $rigid:literal, $($angle:expr),+) => {{
            let scene = &$scene;
            let exact = scene.modes(&scene.at_rest(&[$($angle),+])?, &Unloaded)?;
            let exact: Vec<f64> = exact.frequencies().collect();
            let single = scene.lift(|x| x as f32);
            let found = single.modes(&single.at_rest(&[$($angle as f32),+])?, &Unloaded)?;
            let largest = exact[exact.len() - 1];
            found.frequencies().take($rigid).for_each(|found| near(found, 0.0, 1e-3 * largest));
            found.frequencies().zip(&exact).skip($rigid).for_each(|(found, exact)| near(found, *exact, 1e-5 * largest));
        }};
    }
    in_both!(pendulum, 0, -FRAC_PI_2, -FRAC_PI_2);
    in_both!(blade, 3, 0.7, 0.7, 0.7, 0.7, 0.7, 0.7);
    let single = pendulum.lift(|x| x as f32);
    let off = single.modes(&single.at_rest(&[-1.5, -std::f32::consts::FRAC_PI_2])?, &Unloaded).unwrap_err();
    assert!(matches!(off.fault, Fault::NotAtRest { .. }), "{off}");
    Ok(())
}
