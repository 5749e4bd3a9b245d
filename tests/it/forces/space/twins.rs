//! Bodies in general position for the library and for the dense system, and what differs between the two.

use catena::loading::Loading;
use catena::spatial::*;
use catena::system::{Element, Root, Runs, Tip};
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use catena_oracle::space::{Answer, Vector};

/// Relative to the largest acceleration or reaction.
pub const TOLERANCE: f64 = 1e-11;

/// A body in general position, for both sides.
pub fn body(noise: &mut Noise) -> (RigidBody<f64>, oracle::Body) {
    let mass = noise.between(0.5, 2.0);
    let axes = oracle::angles([noise.next(), noise.next(), noise.next()]);
    // Moments from second moments of mass, so that they are possible.
    let [a, b, c] = [noise.between(0.01, 0.1), noise.between(0.01, 0.1), noise.between(0.01, 0.1)];
    let inertia = axes * oracle::Matrix::from_diagonal(&Vector::new(b + c, a + c, a + b)) * axes.transpose();
    let inertia = (inertia + inertia.transpose()) * 0.5;
    let centre = Vector::new(noise.between(0.2, 0.6), noise.between(-0.2, 0.2), noise.between(-0.2, 0.2));
    let outboard = Vector::new(noise.between(0.5, 1.0), noise.between(-0.3, 0.3), noise.between(-0.3, 0.3));
    let o = Vector::zeros();
    let twin = oracle::Body { mass, inertia, centre, outboard, force: o, at: o, torque: o };
    let tensor = core::array::from_fn(|i| core::array::from_fn(|j| inertia[(i, j)]));
    (RigidBody::new(mass, tensor, centre.into(), outboard.into()), twin)
}

pub fn vector(noise: &mut Noise) -> Vector {
    Vector::new(noise.next(), noise.next(), noise.next())
}

/// The largest difference between a scene's accelerations and reactions and the oracle's, relative to their size.
pub fn difference<R, C, P, L>(
    system: &System<f64, R, C, P>,
    motion: &catena::system::MotionOf<Spatial<f64>, R, C, P>,
    loads: &L,
    answer: &Answer,
) -> f64
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
    P: Tip<Spatial<f64>>,
    L: Loading<Spatial<f64>>,
    System<f64, R, C, P>: Runs<L, Spatial<f64>, R, C, P>,
{
    let size = answer.linear.iter().chain(&answer.angular).chain(&answer.forces).chain(&answer.torques);
    let size = size.fold(1.0_f64, |size, v| size.max(v.amax()));
    let mut worst = 0.0_f64;
    let mut note = |found: Vector, expected: Vector| worst = worst.max((found - expected).amax() / size);
    for (k, body) in system.body_motions(motion).unwrap().iter().enumerate() {
        note(body.centre().acceleration.linear, answer.linear[k]);
        note(body.inboard.acceleration.angular, answer.angular[k]);
    }
    let stations = system.stations(motion, loads).unwrap();
    for k in 0..system.bodies() {
        // Bodies and joints alternate: station 2 k is the inboard end of body k.
        if let Some(station) = stations.get(2 * k) {
            note(station.internal.force, answer.forces[k]);
            note(station.torque_outboard(), answer.torques[k]);
        }
    }
    note(-stations.tip().internal.force, answer.tip[0]);
    note(stations.tip().internal.torque, answer.tip[1]);
    worst
}
