//! A double pendulum, released at rest: run it, read it, check it against a reference, draw it.
//!
//! ```text
//! cargo run --release --example double_pendulum
//! ```

mod common;
#[path = "pictures/double_pendulum.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::planar::*;
use std::error::Error;
use std::f64::consts::FRAC_PI_3;

/// Angles (rad) and force of the ground on the first rod (N) at t = 2 s: an integration of order 8 that agrees with a
/// Taylor series of 30 digits.
const REFERENCE: [f64; 4] = [-1.3564198519106136, -1.1306522396578225, -3.354922171594491, 20.855383568488572];

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Angles of the rods from the horizontal (rad).
    angles: [f64; 2],
    /// Force of the ground on the first rod (N).
    pivot: [f64; 2],
    /// Places of the elbow and the tip (m).
    places: [(f64, f64); 2],
    /// Kinetic and potential energy (J).
    energy: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    // A scene goes from its root to its tip: held by a pin at the origin, a rod, a pin, a rod, nothing beyond. Its type
    // says all of that, so the compiler lays out and unrolls everything, and a run allocates nothing of its own.
    let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
    let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);

    // The scene holds parameters only. Its motion is a value apart: here at rest, both rods 60° below the horizontal.
    let start = pendulum.at_rest(&[-FRAC_PI_3; 2])?;

    // Steps are as large as the tolerance allows. The motion is shown every 10 ms, whatever the steps. To keep a motion
    // is to keep everything: all that can be measured is read from it later.
    let rule = Dop853::tolerance(1e-13);
    let mut motions = Vec::new();
    let run = pendulum.simulation(rule).every(0.01).run(start, 10.0, |now| motions.push(*now.motion()))?;

    let mut readings = Vec::new();
    for motion in &motions {
        // A motion has the shape of its scene: the root's pin, then the chain, of which only the pin in the middle moves
        // by itself.
        let (first, ((), second, ())) = *motion.position();
        // The force and torque inside every joint come from the motion alone.
        let stations = pendulum.stations(motion, &Unloaded)?;
        let pivot = stations.root().internal.force;
        let elbow = stations.get(1).ok_or("station 1 is the inboard end of the pin")?.frame.place;
        let tip = stations.tip().frame.place;
        let budget = pendulum.budget(motion)?;
        readings.push(Reading {
            time: motion.time(),
            angles: [first, second],
            pivot: [pivot.x, pivot.y],
            places: [(elbow.x, elbow.y), (tip.x, tip.y)],
            energy: budget.kinetic + budget.potential,
        });
    }

    let initial = readings.first().ok_or("the start is always shown")?.energy;
    println!("Double pendulum: two uniform rods (1 m, 1 kg), released at rest at −60°, g = 9.81 m/s²");
    println!("DOP853, tolerance 1e-13: {} steps for 10 s\n", run.steps);
    let heads = [("time (s)", 8), ("θ₁ (rad)", 10), ("θ₂ (rad)", 10), ("force x (N)", 11), ("force y (N)", 11)];
    common::heads(&[&heads[..], &[("energy error (J)", 16)]].concat());
    for Reading { time, angles, pivot, energy, .. } in readings.iter().step_by(100) {
        let [first, second] = angles;
        let [x, y] = pivot;
        let error = energy - initial;
        println!("  {time:8.2}  {first:10.6}  {second:10.6}  {x:11.5}  {y:11.5}  {error:16.1e}");
    }

    // The reference is for t = 2 s, so this run ends there: the last step always lands on the end.
    let motion = pendulum.simulate(start, rule, 2.0, |_| ())?.motion;
    let (first, ((), second, ())) = *motion.position();
    let force = pendulum.stations(&motion, &Unloaded)?.root().internal.force;
    println!("\nAt t = 2 s              found                reference     error");
    let names = ["θ₁ (rad)     ", "θ₂ (rad)     ", "force x (N)  ", "force y (N)  "];
    for ((name, found), reference) in names.iter().zip([first, second, force.x, force.y]).zip(REFERENCE) {
        println!("  {name}{found:20.15}  {reference:20.15}  {:8.1e}", found - reference);
    }

    // Without `every` the motion is shown at the end of each step. Energy is drawn from these: between them motions are
    // interpolated, to an order less than that of the steps.
    let mut energies = Vec::new();
    pendulum.simulate(start, rule, 10.0, |now| energies.push((now.time(), now.energy() - initial)))?;

    println!("\nPictures: {}", pictures::draw(&readings, &energies, run.steps)?.display());

    // Released from above, it does not swing but tumble.
    let mut places = Vec::new();
    let above = pendulum.at_rest(&[1.2, 2.4])?;
    pendulum.simulation(rule).every(0.025).run(above, 12.0, |now| {
        let place = |k| now.stations().get(k).map_or_else(Default::default, |s: &Station<f64>| s.frame.place);
        let (elbow, tip) = (place(1), now.stations().tip().frame.place);
        places.push(vec![vec![(0.0, 0.0), (elbow.x, elbow.y), (tip.x, tip.y)]]);
    })?;
    println!("          {}", pictures::film(&places)?.display());
    Ok(())
}
