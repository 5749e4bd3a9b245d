//! The plain product of transfer matrices against the Riccati sweep, on short chains.

use catena::loading::Unloaded;
use catena::planar::index::{M, QX, QY, THETA, X, Y};
use catena::planar::*;
use catena::{Error, Fault, Place, TransferMatrix};

/// A chain with bodies of every kind but point masses, which have no transfer matrix behind a pin.
macro_rules! scene {
    () => {{
        let rod = Rod::new(0.8, 1.3, 0.3, 0.07);
        let plate = RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]);
        let ground = Moving(|t: f64| GroundMotion { place: [t, 0.0], velocity: [1.0, 0.0], acceleration: [0.3, -0.7] });
        System::new(Pinned::on(ground), (rod, Pin, plate, rod, Pin, plate), Free)
    }};
}

#[test]
fn product_and_sweep_agree() -> Result<(), Error> {
    let scene = scene!()?.with_gravity(9.81);
    let motion = scene.at_rest(&[-0.3, 0.9, 0.2])?;
    let motion = scene.with_rates(motion, &[1.0, -2.0, 0.7])?;
    let loads = Loads::none()
        .in_joints(|_, joint, _: &JointMotion<f64>| [0.3, -0.8, 0.5][joint])
        .on_bodies(|_, body, motion: &BodyMotion<f64>| motion.force_at([0.1, 0.2], [1.0 + body as f64, -0.5]));
    let motion = scene.with_accelerations(motion, &loads)?;
    let swept = scene.stations(&motion, &loads)?.get(0).unwrap().acceleration_state();
    let multiplied = scene.root_state(&motion, &loads)?;
    for index in [X, Y, THETA, M, QX, QY] {
        // Entries of the product of six matrices reach 1e2, so some digits go.
        assert!((swept[index] - multiplied[index]).abs() < 1e-11, "{index}: {} {}", swept[index], multiplied[index]);
    }
    Ok(())
}

#[test]
fn body_matrices_have_determinant_one_and_pin_matrices_none() -> Result<(), Error> {
    let scene = scene!()?.with_gravity(9.81);
    let motion = scene.with_rates(scene.at_rest(&[-0.3, 0.9, 0.2])?, &[1.0, -2.0, 0.7])?;
    scene.transfer_matrix(&motion, &Unloaded, |element, u: &TransferMatrix<f64, 7>| {
        let is_pin = element == 1 || element == 4;
        // Seven rows of order one: round-off.
        assert!((u.as_matrix().determinant() - if is_pin { 0.0 } else { 1.0 }).abs() < 1e-13, "{element}");
    })?;
    Ok(())
}

#[test]
fn matrices_transfer_the_states_of_a_sweep() -> Result<(), Error> {
    let scene = scene!()?.with_gravity(9.81);
    let motion = scene.with_rates(scene.at_rest(&[-0.3, 0.9, 0.2])?, &[1.0, -2.0, 0.7])?;
    let motion = scene.with_accelerations(motion, &Unloaded)?;
    let stations = scene.stations(&motion, &Unloaded)?;
    scene.transfer_matrix(&motion, &Unloaded, |element, u| {
        let state = |k: usize| stations.get(k).unwrap().acceleration_state();
        let (inboard, outboard) = (state(element), state(element + 1));
        let transferred = *u * inboard;
        for index in [X, Y, THETA, M, QX, QY] {
            let difference = (transferred[index] - outboard[index]).abs();
            assert!(difference < 1e-11, "element {element}, entry {index}: {difference:e}"); // round-off of forces of 1e2
        }
    })?;
    Ok(())
}

#[test]
fn point_masses_behind_pins_have_no_matrix() -> Result<(), Error> {
    let bob = PointMass::new(1.0, 1.0);
    let chain = System::new(Pinned::origin(), (bob, Pin, bob), Free)?;
    let motion = chain.at_rest(&[0.0, 0.0])?;
    let error = chain.transfer_matrix(&motion, &Unloaded, |_, _: &TransferMatrix<f64, 7>| ()).unwrap_err();
    assert_eq!((error.fault, error.place), (Fault::SingularTransfer, Some(Place::Station(1))));
    Ok(())
}

/// Sliders and hinges with linear springs along each kind of axes, on a root that is guided and on one that floats.
#[test]
fn joints_that_slide_have_matrices_too() -> Result<(), Error> {
    let (rod, plate) = (Rod::new(0.8, 1.3, 0.3, 0.07), RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]));
    let spring = Spring::new(60.0).damped(0.8).resting_at(0.1);
    let hinge = ElasticHinge::rotary(3.0).damped(0.2).with_linear(spring, spring);
    let slider = Slider::along(0.3).with(spring);
    macro_rules! agree {
        ($root:expr, $chain:expr) => {{
            let scene = System::new($root, $chain, Free)?.with_gravity(9.81);
            let (mut motion, mut k) = (scene.motion(), 0.0);
            let mut next = |_| {
                k += 1.0;
                0.3 * f64::sin(7.0 * k)
            };
            catena::system::Position::replace(motion.position_mut(), &mut next);
            catena::system::Rate::replace(motion.rate_mut(), &mut next);
            let motion = scene.with_accelerations(motion, &Unloaded)?;
            let stations = scene.stations(&motion, &Unloaded)?;
            let swept = stations.get(0).unwrap().acceleration_state();
            let multiplied = scene.root_state(&motion, &Unloaded)?;
            for index in [X, Y, THETA, M, QX, QY] {
                let (found, expected) = (multiplied[index], swept[index]);
                assert!((found - expected).abs() < 1e-10, "{index}: {found} {expected}"); // forces of 1e2
            }
        }};
    }
    agree!(Pinned::origin(), (rod, slider, plate));
    agree!(Pinned::origin(), (rod, hinge, plate, Pin, rod));
    agree!(Free, (rod, hinge.in_unbalanced_axes(), plate));
    agree!(Guided::at(0.0, 0.0, 0.4), (rod, Pin, plate));
    Ok(())
}
