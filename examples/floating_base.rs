//! A satellite turns itself around with its arm: nothing holds it, nothing pushes it, and when the arm has gone its round, the hub
//! has turned.
//!
//! ```text
//! cargo run --release --example floating_base
//! ```

mod common;
#[path = "pictures/floating_base.rs"]
mod pictures;

use catena::planar::*;
use nalgebra::Vector2;
use std::error::Error;
use std::f64::consts::TAU;

/// Rounds of the arm, how long each takes (s), and how far its joints swing (rad).
const ROUNDS: usize = 8;
const ROUND: f64 = 3.0;
const SWING: f64 = 1.3;
/// The hub's rim (m); masses (kg) and moments of inertia (kg·m²) of the hub, a disc, and of both rods of the arm, 1 m each.
const RIM: f64 = 0.4;
const MASSES: [f64; 3] = [40.0, 8.0, 8.0];
const INERTIAS: [f64; 3] = [3.2, 8.0 / 12.0, 8.0 / 12.0];
/// Motors of both joints: stiffness (N·m/rad) and damping (N·m·s/rad) about the path asked for.
const MOTORS: [f64; 2] = [400.0, 40.0];

/// Angles asked for, and their rates: each round begins and ends at rest, straight (rad, rad/s).
fn asked(time: f64, joint: usize) -> [f64; 2] {
    let share = (time / ROUND).fract();
    let (way, rate) = (share - (TAU * share).sin() / TAU, (1.0 - (TAU * share).cos()) / ROUND);
    let (sin, cos) = (TAU * way).sin_cos();
    if joint == 1 { [SWING * sin, SWING * cos * TAU * rate] } else { [SWING * (1.0 - cos), SWING * sin * TAU * rate] }
}

/// Torque of a motor (N·m) at this angle (rad) and rate (rad/s) of its joint.
fn motor(time: f64, joint: usize, angle: f64, rate: f64) -> f64 {
    let [wanted, wanted_rate] = asked(time, joint);
    MOTORS[0] * (wanted - angle) + MOTORS[1] * (wanted_rate - rate)
}

/// What is kept of an instant.
struct Reading {
    time: f64,
    /// Angle of the hub, and of the joints (rad); the hub's rate by what must stay (rad/s).
    hub: f64,
    joints: [f64; 2],
    conserved: f64,
    /// Centre of the hub, shoulder, elbow and hand (m).
    places: [(f64, f64); 4],
    /// Linear (kg·m/s) and angular momentum (kg·m²/s): nothing changes either.
    momenta: [f64; 2],
}

/// Rate of the hub (rad/s) at which angular momentum about the mass centre is none, from places and velocities of the three centres.
fn conserved([shoulder, elbow]: [f64; 2], [first, second]: [f64; 2]) -> f64 {
    let half = |angle: f64| 0.5 * Vector2::new(angle.cos(), angle.sin());
    let moved = |arm: Vector2<f64>, rate: f64| rate * Vector2::new(-arm.y, arm.x);
    let (upper, fore, rim) = (half(shoulder), half(shoulder + elbow), Vector2::new(RIM, 0.0));
    let (swung, both) = (moved(upper, first), first + second);
    let places = [Vector2::zeros(), rim + upper, rim + 2.0 * upper + fore];
    let velocities = [Vector2::zeros(), swung, 2.0 * swung + moved(fore, both)];
    let mean = |all: [Vector2<f64>; 3]| {
        all.into_iter().zip(MASSES).map(|(x, mass)| mass * x).sum::<Vector2<f64>>() / MASSES.iter().sum::<f64>()
    };
    let (centre, drift) = (mean(places), mean(velocities));
    let (mut momentum, mut inertia) = (0.0, 0.0);
    for (k, rate) in [0.0, first, both].into_iter().enumerate() {
        let (place, velocity) = (places[k] - centre, velocities[k] - drift);
        momentum += MASSES[k] * place.perp(&velocity) + INERTIAS[k] * rate;
        inertia += MASSES[k] * place.norm_squared() + INERTIAS[k];
    }
    -momentum / inertia
}

fn main() -> Result<(), Box<dyn Error>> {
    // The hub, a disc whose rim carries the arm, two rods. A root that is free gives the first body two coordinates and an angle.
    let hub = RigidBody::new(MASSES[0], INERTIAS[0], [0.0; 2], [RIM, 0.0]).named("hub");
    let [upper, fore] = [MASSES[1], MASSES[2]].map(|mass| Rod::uniform(1.0, mass));
    let satellite = System::new(Free, (hub, Pin.named("shoulder"), upper, Pin.named("elbow"), fore), Free)?;
    println!("{}\n", satellite.describe());
    let motors = Loads::none().in_joints(|time: f64, joint, motion: &JointMotion<f64>| match joint {
        0 => 0.0, // the hub floats
        _ => motor(time, joint - 1, motion.angle(), motion.rate()),
    });

    let mut readings: Vec<Reading> = vec![];
    let simulation = satellite.simulation(Dop853::tolerance(1e-9)).loads(&motors).every(0.05);
    simulation.run(satellite.motion(), ROUND * ROUNDS as f64, |now| {
        let (bodies, budget, rates) = (now.bodies(), now.budget(), now.motion().rates());
        let angle = |k: usize| now.angles().get(k).copied().unwrap_or(f64::NAN);
        let place = |k: usize, at: [f64; 2]| {
            let point = bodies.get(k).map_or_else(Default::default, |body| body.point(at).place);
            (point.x, point.y)
        };
        let joints = [angle(1) - angle(0), angle(2) - angle(1)];
        readings.push(Reading {
            time: now.time(),
            hub: angle(0),
            joints,
            conserved: conserved(joints, [rates[3] - rates[2], rates[4] - rates[3]]),
            places: [place(0, [0.0; 2]), place(0, [RIM, 0.0]), place(1, [1.0, 0.0]), place(2, [1.0, 0.0])],
            momenta: [budget.momentum.norm(), budget.angular_momentum],
        });
    })?;

    let arm = [("rounds", 6), ("shoulder (mrad)", 15), ("elbow (mrad)", 12), ("hub turned (°)", 14)];
    let kept = [("by momentum (°)", 15), ("momentum (kg·m/s)", 17), ("angular (kg·m²/s)", 17)];
    common::heads(&[&arm[..], &kept].concat());
    let mut turned = 0.0; // trapezes, which of rates that end where they began have no error to speak of
    for (k, now) in readings.iter().enumerate() {
        turned += 0.025 * (now.conserved + readings[k.saturating_sub(1)].conserved);
        if k > 0 && k % 60 == 0 {
            let ([shoulder, elbow], [p, l]) = (now.joints.map(|angle| 1e3 * angle), now.momenta);
            let (hub, sum) = (now.hub.to_degrees(), turned.to_degrees());
            println!("  {:6}  {shoulder:15.3}  {elbow:12.3}  {hub:14.5}  {sum:15.5}  {p:17.0e}  {l:17.0e}", k / 60);
        }
    }
    println!("\nPictures: {}", pictures::draw(&readings)?.display());
    println!("          {}", pictures::film(&readings)?.display());
    Ok(())
}
