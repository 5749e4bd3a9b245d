//! A heavy top, spinning fast: run it, check it against a reference, draw it.
//!
//! ```text
//! cargo run --release --example heavy_top
//! ```

mod common;
#[path = "pictures/heavy_top.rs"]
mod pictures;

use catena::spatial::*;
use nalgebra::Vector3;
use std::error::Error;

/// Place of the mass centre (m) at t = 2 s: an integration of order 8 at two tolerances that agree to 1e-11. The top is that of
/// O. Brüls, A. Cardona and M. Arnold (2012).
const REFERENCE: [f64; 3] = [-0.1504168227, -0.7241655916, -0.6730222696];

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Place of the mass centre (m).
    centre: Vector3<f64>,
    /// Force of the ground on the top (N).
    pivot: Vector3<f64>,
    /// Kinetic and potential energy (J).
    energy: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    // Mass (kg), inertia tensor about the mass centre (kg·m²), mass centre and outboard end (m), all in body axes: the top spins
    // about its y axis.
    let tensor = [[0.234375, 0.0, 0.0], [0.0, 0.46875, 0.0], [0.0, 0.0, 0.234375]];
    let body = RigidBody::new(15.0, tensor, [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]);
    // A root that is pinned is a ball joint: its position is an attitude, kept as a unit quaternion without singular places.
    let top = System::new(Pinned::origin(), body, Free)?.with_gravity([0.0, 0.0, -9.81]);
    // The axis lies horizontal and the top spins at 150 rad/s about it; rates are angular velocities in body axes.
    let start = top.with_rates(top.motion(), &[0.0, 150.0, -4.61538])?;

    let rule = Dop853::tolerance(1e-12);
    let mut readings = Vec::new();
    let run = top.simulation(rule).every(0.002).run(start, 2.0, |now| {
        let centre = now.bodies().get(0).map(|body| body.centre().place);
        readings.push(Reading {
            time: now.time(),
            centre: centre.unwrap_or_default(),
            pivot: now.stations().root().internal.force,
            energy: now.energy(),
        });
    })?;

    let initial = readings.first().ok_or("the start is always shown")?.energy;
    println!("Heavy top: 15 kg on an arm of 1 m, 150 rad/s about its axis, released horizontal, g = 9.81 m/s²");
    println!("DOP853, tolerance 1e-12: {} steps for 2 s\n", run.steps);
    let centre = [("time (s)", 8), ("centre x (m)", 12), ("y (m)", 10), ("z (m)", 10)];
    let force = [("force x (N)", 11), ("y (N)", 10), ("z (N)", 10), ("energy error (relative)", 23)];
    common::heads(&[centre, force].concat());
    for Reading { time, centre, pivot, energy } in readings.iter().step_by(100) {
        let [x, y, z]: [f64; 3] = (*centre).into();
        let [u, v, w]: [f64; 3] = (*pivot).into();
        let error = energy / initial - 1.0;
        println!("  {time:8.2}  {x:12.6}  {y:10.6}  {z:10.6}  {u:11.4}  {v:10.4}  {w:10.4}  {error:23.1e}");
    }

    let last = readings.last().ok_or("the end is always shown")?;
    println!("\nAt t = 2 s           found         reference     error");
    for ((name, found), reference) in ["x (m)", "y (m)", "z (m)"].iter().zip(last.centre.iter()).zip(REFERENCE) {
        println!("  {name}       {found:15.10}  {reference:15.10}  {:8.1e}", found - reference);
    }
    println!("\nPictures: {}", pictures::draw(&readings, initial, run.steps)?.display());
    println!("          {}", pictures::film(&readings)?.display());
    Ok(())
}
