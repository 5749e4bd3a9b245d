//! What a sweep does, by hand: one walk inward that keeps gains, one outward that reads accelerations from them.
//!
//! A double pendulum tumbles. At each instant the forty lines below find its accelerations as the library does, and are compared with it.
//!
//! ```text
//! cargo run --release --example two_walks
//! ```

mod common;
#[path = "pictures/two_walks.rs"]
mod pictures;

use catena::planar::*;
use nalgebra::{Matrix2, Vector2};
use std::error::Error;

type Vector = Vector2<f64>;

const LENGTH: f64 = 1.0; // (m)
const MASS: f64 = 1.0; // (kg)
const GRAVITY: Vector = Vector::new(0.0, -9.81); // (m/s²)

/// What lies outboard of a point: it takes the force S a + e to accelerate the point by a.
#[derive(Clone, Copy, Default)]
struct Relation {
    inertia: Matrix2<f64>, // S (kg)
    bias: Vector,          // e (N)
}

/// The gains of a pin: angular acceleration of its rod from the acceleration a of the pin, −(g·a + h).
#[derive(Clone, Copy, Default)]
struct Gains {
    linear: Vector, // g (rad/m)
    constant: f64,  // h (rad/s²)
}

/// A rod at an instant: its arm from pin to pin (m), that arm turned by a quarter, its angular velocity squared (rad²/s²).
fn posture([angle, rate]: [f64; 2]) -> (Vector, Vector, f64) {
    let arm = LENGTH * Vector::new(angle.cos(), angle.sin());
    (arm, Vector::new(-arm.y, arm.x), rate * rate)
}

/// The walk inward at a rod: from what lies outboard of its far end to what lies outboard of its near one.
fn inward(rod: [f64; 2], beyond: Relation) -> (Relation, Gains) {
    let (arm, turned, square) = posture(rod);
    let about_centre = MASS * LENGTH * LENGTH / 12.0; // (kg·m²)
    // Forces at the far end and in the mass centre, where nothing but ω² accelerates them.
    let far = beyond.bias - beyond.inertia * arm * square;
    let centre = -MASS * (0.5 * arm * square + GRAVITY);
    // The pin bears no torque: pivot α + row · a + rest = 0.
    let row = 0.5 * MASS * turned + beyond.inertia * turned;
    let pivot = about_centre + 0.25 * MASS * turned.dot(&turned) + turned.dot(&(beyond.inertia * turned));
    let rest = 0.5 * turned.dot(&centre) + turned.dot(&far);
    let gains = Gains { linear: row / pivot, constant: rest / pivot };
    let inertia = MASS * Matrix2::identity() + beyond.inertia - row * gains.linear.transpose();
    (Relation { inertia, bias: centre + far - row * gains.constant }, gains)
}

/// The walk outward at a rod: its angular acceleration and the acceleration of its far end from that of its near one.
fn outward(rod: [f64; 2], gains: Gains, near: Vector) -> (f64, Vector) {
    let (arm, turned, square) = posture(rod);
    let angular = -(gains.linear.dot(&near) + gains.constant);
    (angular, near + turned * angular - arm * square)
}

/// An instant with what both walks leave.
struct Sweep {
    angles: [f64; 2],
    /// Outboard of the root and of the elbow.
    relations: [Relation; 2],
    /// Of elbow and tip (m/s²).
    accelerations: [Vector; 2],
}

/// Both walks, and the angular accelerations of the rods (rad/s²).
fn sweep(rods: [[f64; 2]; 2]) -> (Sweep, [f64; 2]) {
    let (mut relation, mut relations, mut gains) =
        (Relation::default(), [Relation::default(); 2], [Gains::default(); 2]);
    for k in [1, 0] {
        (relation, gains[k]) = inward(rods[k], relation);
        relations[k] = relation;
    }
    let (mut at, mut angular, mut accelerations) = (Vector::zeros(), [0.0; 2], [Vector::zeros(); 2]); // the ground rests
    for k in [0, 1] {
        (angular[k], at) = outward(rods[k], gains[k], at);
        accelerations[k] = at;
    }
    (Sweep { angles: rods.map(|[angle, _]| angle), relations, accelerations }, angular)
}

fn main() -> Result<(), Box<dyn Error>> {
    let rod = Rod::uniform(LENGTH, MASS);
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(-GRAVITY.y);
    let start = pendulum.at_rest(&[1.2, 2.4])?;

    println!(
        "A double pendulum that tumbles: angular accelerations (rad/s²) by two walks, and what they differ from the library's.\n"
    );
    common::heads(&[
        ("time (s)", 8),
        ("inner rod", 12),
        ("outer rod", 12),
        ("difference", 10),
        ("least S (kg)", 12),
        ("most S (kg)", 11),
    ]);
    let (mut sweeps, mut most) = (vec![], 0.0_f64);
    pendulum.simulation(Dop853::tolerance(1e-12)).every(0.05).run(start, 6.0, |now| {
        let (first, ((), second, ())) = *now.motion().position();
        let (first_rate, ((), second_rate, ())) = *now.motion().rate();
        let (first_known, ((), second_known, ())) = *now.motion().acceleration();
        let (sweep, [inner, outer]) = sweep([[first, first_rate], [second, second_rate]]);
        let scale = 1.0 + first_known.abs().max(second_known.abs());
        let difference = (inner - first_known).abs().max((outer - second_known).abs()) / scale;
        most = most.max(difference);
        if sweeps.len() % 10 == 0 {
            let felt = sweep.relations[0].inertia.symmetric_eigenvalues();
            let time = now.time();
            println!(
                "  {time:8.2}  {inner:12.6}  {outer:12.6}  {difference:10.1e}  {:12.4}  {:11.4}",
                felt.min(),
                felt.max()
            );
        }
        sweeps.push(sweep);
    })?;
    println!("\nLargest relative difference of {} instants: {most:.1e}.", sweeps.len());
    if most > 1e-12 {
        return Err("the two walks by hand are not those of the library".into());
    }
    println!("Picture: {}", pictures::film(&sweeps)?.display());
    Ok(())
}
