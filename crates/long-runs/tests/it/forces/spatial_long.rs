//! Long chains in space: half the digits against all of them.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::{Error, Scalar};
use nalgebra::Vector3;

const N: usize = 10_000;

/// Accelerations of all bodies: of their mass centres, and angular ones in body axes.
struct Found {
    linear: Vec<Vector3<f64>>,
    angular: Vec<Vector3<f64>>,
    /// The largest force in a ball (N).
    force: f64,
}

/// A chain on balls that moves, with smooth bends or as a zigzag. All parameters, angles and rates are exact in `f32`.
fn found<T: Scalar>(zigzag: bool) -> Result<Found, Error> {
    let number = |x: f64| T::literal(f64::from(x as f32));
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(
        number(1.0),
        tensor.map(|row| row.map(number)),
        [0.5, 0.03, -0.02].map(number),
        [1.0, 0.0, 0.0].map(number),
    );
    let scene = System::new(Pinned::origin(), (body, vec![(Ball, body); N - 1]), Free)?
        .with_gravity([0.0, -9.81, 0.0].map(number));
    let (mut angles, mut rates) = (vec![], vec![]);
    for k in 0..N {
        let x = if zigzag { k as f64 } else { core::f64::consts::TAU * k as f64 / N as f64 };
        if zigzag {
            angles.extend([0.7 * (1.3 * x).sin(), 0.6 * (0.7 * x).cos(), -0.3 + 0.5 * x.sin()].map(number));
            rates.extend([0.8 * (0.9 * x).cos(), 0.4 * (1.7 * x).sin(), 0.5 * x.cos()].map(number));
        } else {
            let bent = [0.3 * (2.0 * x).sin(), 0.8 * (3.0 * x).sin() + 0.1 * x.cos(), -1.5 + 0.7 * (5.0 * x).cos()];
            angles.extend(bent.map(number));
            rates.extend([0.0, 0.02 * (2.0 * x).cos(), 0.01 * (3.0 * x).sin()].map(number));
        }
    }
    let motion = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let motion = scene.with_accelerations(motion, &Unloaded)?;
    let read = |v: Vector3<T>| v.map(|x| catena::Real::as_f64(x.real()));
    let bodies = scene.body_motions(&motion)?;
    let stations = scene.stations(&motion, &Unloaded)?;
    Ok(Found {
        linear: bodies.iter().map(|body| read(body.centre().acceleration.linear)).collect(),
        angular: bodies.iter().map(|body| read(Vector3::from(body.angular_acceleration()))).collect(),
        force: stations.iter().map(|station| read(station.internal.force).norm()).fold(0.0, f64::max),
    })
}

/// The largest difference of vectors, in parts of the largest of them.
fn apart(single: &[Vector3<f64>], double: &[Vector3<f64>]) -> [f64; 2] {
    let largest = double.iter().fold(0.0_f64, |most, v| most.max(v.norm()));
    let worst = single.iter().zip(double).fold(0.0_f64, |most, (a, b)| most.max((a - b).norm()));
    [worst / largest, largest]
}

#[test]
fn single_precision_serves_ten_thousand_bodies() -> Result<(), Error> {
    for (name, zigzag) in [("zigzag", true), ("smooth", false)] {
        let (single, double) = (found::<f32>(zigzag)?, found::<f64>(zigzag)?);
        let [linear, a] = apart(&single.linear, &double.linear);
        let [angular, alpha] = apart(&single.angular, &double.angular);
        println!("{name}: {N} bodies of 1 kg and 1 m, forces to {:.1e} N", double.force);
        println!("  accelerations to {a:.2e} m/s², f32 off by {linear:.1e} of it");
        println!("  angular accelerations to {alpha:.2e} rad/s², f32 off by {angular:.1e} of it");
        // A body's moment of inertia is some 0.1 kg·m²: what the largest force could do to it.
        let share = angular * alpha * 0.1 / double.force;
        println!("  and by {share:.1e} of what the largest force would cause at an arm of 1 m");
        // Where the chain pulls hard, rounding of the pull is all that is left of small accelerations.
        assert!(linear < 1e-4 && (angular < 1e-4 || !zigzag) && share < 1e-5, "{name}");
    }
    Ok(())
}
