//! Accelerations, and their readings.

use super::kit::{agree, fixed, floating, list, plain_fixed, plain_floating};
use catena::robot::*;
use catena::system::Rate;
use catena_oracle::Noise;

/// Efforts of joints, from the root's on: one of the ground, one that goes into body axes, the others.
fn efforts<const N: usize>(torques: &[f64]) -> [Effort<f64>; N] {
    std::array::from_fn(|k| Effort([k.checked_sub(2).map_or(0.0, |k| torques[k]), 0.0, 0.0]))
}

#[test]
fn accelerations_of_a_tree_on_the_ground() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(1));
    for _ in 0..100 {
        let [q, v, torques]: [[f64; 6]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        let start = scene.with_rates(start, &v)?;
        let moving = scene.with_accelerations(start, &Loads::none().efforts(efforts::<8>(&torques)))?;
        let (mut found, now) = (vec![], plain.at(&q, &v));
        moving.acceleration().visit(&mut |x: f64| found.push(x));
        agree(&found, plain.forward_dynamics(&q, &v, &torques).as_slice(), 1e-12);
        let budget = scene.budget(&moving)?;
        agree(&[budget.kinetic, budget.potential], &[now.kinetic, now.potential], 1e-13);
    }
    Ok(())
}

#[test]
fn accelerations_of_a_tree_that_floats() -> Result<(), catena::Error> {
    let (scene, mut noise) = (floating()?, Noise::new(2));
    for _ in 0..100 {
        let [q, v, torques]: [[f64; 5]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let [place, velocity, spin, angles]: [[f64; 3]; 4] = std::array::from_fn(|_| list(&mut noise, 1.0));
        let attitude = Rotation::from_angles(angles);
        let plain = plain_floating(place, &attitude, [velocity, spin]);
        let mut start = scene.motion();
        let coordinates: Vec<f64> = place.into_iter().chain(attitude.quaternion()).chain(q).collect();
        start.set_coordinates(&coordinates)?;
        let rates: Vec<f64> = velocity.into_iter().chain(spin).chain(v).collect();
        let start = scene.with_rates(start, &rates)?;
        let moving = scene.with_accelerations(start, &Loads::none().efforts(efforts::<7>(&torques)))?;
        let (mut found, now) = (vec![], plain.at(&q, &v));
        moving.acceleration().visit(&mut |x: f64| found.push(x));
        let forces: Vec<f64> = [0.0; 6].into_iter().chain(torques).collect();
        agree(&found, plain.forward_dynamics(&q, &v, &forces).as_slice(), 1e-11);
        let budget = scene.budget(&moving)?;
        agree(&[budget.kinetic, budget.potential], &[now.kinetic, now.potential], 1e-13);
    }
    Ok(())
}
