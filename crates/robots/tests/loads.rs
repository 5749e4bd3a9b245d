//! Loads on links in body axes, against Jacobians of a dense robot.

#[path = "../../../tests/it/robots/kit.rs"]
mod kit;

use catena::robot::*;
use catena::system::Rate;
use catena_oracle::Noise;
use catena_oracle::space::Vector;
use catena_oracle::space::robot::Instant;
use kit::{Drift, agree, drift, fixed, floating, list, plain_fixed};

/// A force and a torque (inertial axes) at the inboard end of each body.
fn wrenches<const N: usize>(noise: &mut Noise) -> [Wrench<f64>; N] {
    std::array::from_fn(|_| {
        let [force, torque]: [[f64; 3]; 2] = std::array::from_fn(|_| list(noise, 20.0));
        Wrench { force: force.into(), torque: torque.into() }
    })
}

/// Generalised forces of wrenches on all bodies, the base included.
fn generalised(now: &Instant, wrenches: &[Wrench<f64>]) -> Vec<f64> {
    let bodies = now.base.iter().chain(&now.bodies);
    let mut sum = vec![0.0; now.bias.len()];
    for (body, Wrench { force, torque }) in bodies.zip(wrenches) {
        let (force, torque) = (Vector::new(force.x, force.y, force.z), Vector::new(torque.x, torque.y, torque.z));
        let each = body.of_place.transpose() * force + body.of_turn.transpose() * torque;
        sum.iter_mut().zip(each.iter()).for_each(|(sum, x)| *sum += x);
    }
    sum
}

#[test]
fn wrenches_on_links_of_a_fixed_robot() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(11));
    for _ in 0..50 {
        let [q, v]: [[f64; 6]; 2] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let start = scene.at_joints(&q, &v)?;
        let wrenches = wrenches::<6>(&mut noise);
        let right = plain.forward_dynamics(&q, &v, &generalised(&plain.at(&q, &v), &wrenches));
        // Values handed in, and the same as a function of the motion.
        let listed = scene.with_accelerations(start, &Loads::none().wrenches(wrenches))?;
        let law = Loads::none().on_bodies(|_, body, _: &BodyMotion<f64>| wrenches[body]);
        let seen = scene.with_accelerations(start, &law)?;
        for moving in [listed, seen] {
            let mut found = vec![];
            moving.acceleration().visit(&mut |x: f64| found.push(x));
            agree(&found, right.as_slice(), 1e-12);
        }
        // Inverse dynamics by stations knows loads, too: nothing is left for the joints but what dampers say.
        let stations = scene.stations(&listed, &Loads::none().wrenches(wrenches))?;
        assert!(stations.root().internal.force.norm() > 1.0);
    }
    Ok(())
}

#[test]
fn wrenches_on_links_of_a_floating_robot() -> Result<(), catena::Error> {
    let (scene, mut noise) = (floating()?, Noise::new(12));
    for _ in 0..50 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let wrenches = wrenches::<6>(&mut noise);
        let right = plain.forward_dynamics(&q, &v, &generalised(&plain.at(&q, &v), &wrenches));
        let moving = scene.with_accelerations(start, &Loads::none().wrenches(wrenches))?;
        let mut found = vec![];
        moving.acceleration().visit(&mut |x: f64| found.push(x));
        agree(&found, right.as_slice(), 1e-11);
    }
    Ok(())
}
