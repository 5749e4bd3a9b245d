//! A heavy top, spinning fast: run it, check it against a reference, draw it.
//!
//! ```text
//! cargo run --release --example heavy_top
//! ```

mod common;

use catena::spatial::*;
use common::film::Film;
use common::{BLUE, Drawn, GREEN, INK, ORANGE, line};
use nalgebra::Vector3;
use std::error::Error;
use std::path::PathBuf;

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
    println!("\nPictures: {}", draw(&readings, initial, run.steps)?.display());
    println!("          {}", film(&readings)?.display());
    Ok(())
}

/// The path of the mass centre from above and its height; the energy error.
fn draw(readings: &[Reading], initial: f64, steps: usize) -> Drawn<PathBuf> {
    common::picture("heavy_top", (1000, 560), |area| {
        let subtitle = format!(
            "15 kg on an arm of 1 m, 150 rad/s about its axis. 2 s in {steps} steps of DOP853, tolerance 1e-12."
        );
        let area = common::heading(area, "Heavy top", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(490.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "Mass centre from above, x and y (m)";
        let mut path = common::chart(&left, title, "", -1.12..1.12, -1.12..1.12)?;
        common::curve(&mut path, readings.iter().map(|now| (now.centre.x, now.centre.y)), line(BLUE, 1.4))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let heights = readings.iter().map(|now| now.centre.z);
        let mut height = common::chart(&upper, "Height (m)", "time (s)", 0.0..2.0, common::range(heights, 0.08))?;
        common::curve(&mut height, readings.iter().map(|now| (now.time, now.centre.z)), line(ORANGE, 1.6))?;

        let points = readings.iter().map(|now| (now.time, (now.energy / initial - 1.0) * 1e12));
        let range = common::range(points.clone().map(|(_, error)| error), 0.15);
        let mut error = common::chart(&lower, "Energy error (10⁻¹² of the energy)", "time (s)", 0.0..2.0, range)?;
        common::curve(&mut error, points, line(GREEN, 1.4))
    })
}

/// The axis of the top as it moves, seen aslant and slowed down.
fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .step_by(5)
        .map(|now| {
            let p = now.centre;
            vec![vec![(0.0, 0.0), (0.8 * p.x - 0.6 * p.y, p.z + 0.3 * p.x + 0.4 * p.y)]]
        })
        .collect();
    let film = Film {
        title: "Heavy top",
        subtitle: "15 kg on an arm of 1 m, spinning at 150 rad/s, from the horizontal.",
        view: (-1.3..1.3, -1.35..0.9),
        scale: 190.0,
        seconds: [2.0, 10.0],
        strokes: &[(BLUE, 9.0)],
        trace: (0, 1, ORANGE),
        ground: &[(0.0, 0.0)],
        floor: &[],
    };
    film.save("heavy_top_moving", &frames)
}
