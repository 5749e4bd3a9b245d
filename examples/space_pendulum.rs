//! Three bodies hang on ball joints, Example 5 of the paper with bodies of general shape: run them, read them, check them, draw them.
//!
//! ```text
//! cargo run --release --example space_pendulum
//! ```

mod common;

use catena::spatial::*;
use common::{BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use nalgebra::Vector3;
use std::error::Error;
use std::path::PathBuf;

/// Forces in the three balls (N) at t = 2 s: an articulated-body code and a dense system of Newton-Euler equations at tolerance 1e-13,
/// agreeing to 4e-13.
const REFERENCE: [[f64; 3]; 3] = [
    [8.444353526855, 19.407475672093, 1.443089721714],
    [10.305119280157, 6.702369411809, -0.408275411505],
    [6.937283602482, -4.139942244478, -0.856349536214],
];

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Angles 1-2-3 of the bodies (rad).
    angles: [[f64; 3]; 3],
    /// Places of the balls between the bodies and of the tip (m).
    places: [Vector3<f64>; 3],
    /// Kinetic and potential energy (J).
    energy: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    // Mass (kg), inertia tensor about the mass centre (kg·m²), mass centre beside the line between the joints (m).
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let chain = (body, Ball, body, Ball, body);
    let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0]);
    // All along x, with a little turn of the last body about y: rates are angular velocities in axes of the bodies.
    let start = pendulum.with_rates(pendulum.motion(), &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0])?;

    let rule = Dop853::tolerance(1e-13);
    let mut readings: Vec<Reading> = Vec::new();
    let run = pendulum.simulation(rule).every(0.01).run(start, 2.0, |now| {
        let before = readings.last().map_or([[0.0; 3]; 3], |last| last.angles);
        let (mut angles, mut places) = (before, [Vector3::zeros(); 3]);
        for (k, body) in now.bodies().iter().enumerate() {
            // Attitudes are quaternions; the paper's angles are read off them, nearest to those before.
            angles[k] = body.attitude().angles_near(before[k]);
            places[k] = body.outboard().place;
        }
        readings.push(Reading { time: now.time(), angles, places, energy: now.energy() });
    })?;

    let initial = readings.first().ok_or("the start is always shown")?.energy;
    println!("Three bodies on balls, released along x, g = 9.81 m/s² along −y");
    println!("DOP853, tolerance 1e-13: {} steps for 2 s\n", run.steps);
    let angles = [("time (s)", 8), ("θ₁ of body 2 (rad)", 18), ("θ₂ (rad)", 10), ("θ₃ (rad)", 10)];
    let tip = [("tip x (m)", 10), ("y (m)", 10), ("z (m)", 10), ("energy error (J)", 16)];
    common::heads(&[angles, tip].concat());
    for Reading { time, angles, places, energy } in readings.iter().step_by(20) {
        let ([a, b, c], tip) = (angles[2], places[2]);
        let error = energy - initial;
        let [x, y, z] = [tip.x, tip.y, tip.z];
        println!("  {time:8.2}  {a:18.6}  {b:10.6}  {c:10.6}  {x:10.6}  {y:10.6}  {z:10.6}  {error:16.1e}");
    }

    let stations = pendulum.stations(&run.motion, &Unloaded)?;
    println!("\nForces in the balls at t = 2 s (N)            found            reference     error");
    for (k, reference) in REFERENCE.iter().enumerate() {
        let force = stations.get(2 * k).ok_or("every body has an inboard end")?.internal.force;
        for ((name, found), reference) in ["x", "y", "z"].iter().zip(force.iter()).zip(reference) {
            println!(
                "  ball {k}, {name}                      {found:18.12}  {reference:18.12}  {:8.1e}",
                found - reference
            );
        }
    }
    println!("\nPicture: {}", draw(&readings, initial, run.steps)?.display());
    Ok(())
}

/// The fall from the side on the left; what leaves the plane, and the energy error on the right.
fn draw(readings: &[Reading], initial: f64, steps: usize) -> Drawn<PathBuf> {
    common::picture("space_pendulum", (1000, 560), |area| {
        let subtitle = format!("Three bodies, released along x. 2 s in {steps} steps of DOP853, tolerance 1e-13.");
        let area = common::heading(area, "Three bodies on ball joints", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(490.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "From the side, x and y (m), every 0.1 s of the first";
        let mut path = common::chart(&left, title, "", -3.2..3.2, -3.2..3.2)?;
        let fall: Vec<_> = readings.iter().take(101).step_by(10).collect();
        for (k, now) in fall.iter().enumerate() {
            let share = k as f64 / (fall.len() - 1) as f64;
            let colour = blend(FAINT, BLUE, 0.1 + 0.9 * share * share);
            let points = now.places.map(|place| (place.x, place.y));
            common::links(&mut path, [(0.0, 0.0)].into_iter().chain(points).collect(), line(colour, 3.0))?;
            common::dots(&mut path, points, 4.0, colour)?;
        }
        common::curve(&mut path, readings.iter().map(|now| (now.places[2].x, now.places[2].y)), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let all = readings.iter().flat_map(|now| now.places.map(|place| place.z));
        let title = "Out of the plane, z (m)";
        let mut depth = common::chart(&upper, title, "time (s)", 0.0..2.0, common::range(all, 0.08))?;
        common::legend(&upper, &[("second ball", BLUE), ("tip", ORANGE)])?;
        for (k, colour) in [(1, BLUE), (2, ORANGE)] {
            common::curve(&mut depth, readings.iter().map(|now| (now.time, now.places[k].z)), line(colour, 1.8))?;
        }

        let points = readings.iter().map(|now| (now.time, (now.energy - initial) * 1e12));
        let range = common::range(points.clone().map(|(_, error)| error), 0.15);
        let mut error = common::chart(&lower, "Energy error (10⁻¹² J)", "time (s)", 0.0..2.0, range)?;
        common::curve(&mut error, points, line(GREEN, 1.4))
    })
}
