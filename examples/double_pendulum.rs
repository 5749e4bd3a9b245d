//! A double pendulum, released at rest: run it, read it, check it against a reference, draw it.
//!
//! ```text
//! cargo run --release --example double_pendulum
//! ```

mod common;

use catena::loading::Unloaded;
use catena::planar::*;
use common::film::{Film, Frame};
use common::{BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use std::error::Error;
use std::f64::consts::FRAC_PI_3;
use std::path::PathBuf;

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

    println!("\nPictures: {}", draw(&readings, &energies, run.steps)?.display());

    // Released from above, it does not swing but tumble.
    let mut places = Vec::new();
    let above = pendulum.at_rest(&[1.2, 2.4])?;
    pendulum.simulation(rule).every(0.025).run(above, 12.0, |now| {
        let place = |k| now.stations().get(k).map_or_else(Default::default, |s: &Station<f64>| s.frame.place);
        let (elbow, tip) = (place(1), now.stations().tip().frame.place);
        places.push(vec![vec![(0.0, 0.0), (elbow.x, elbow.y), (tip.x, tip.y)]]);
    })?;
    println!("          {}", film(&places)?.display());
    Ok(())
}

/// The pendulum as it moves, released from above.
fn film(frames: &[Frame]) -> Drawn<PathBuf> {
    let film = Film {
        title: "Double pendulum",
        subtitle: "Two uniform rods, 1 m and 1 kg each; the way of the tip.",
        view: (-2.2..2.2, -2.15..2.15),
        scale: 110.0,
        seconds: [12.0; 2],
        strokes: &[(BLUE, 7.0)],
        trace: (0, 2, ORANGE),
        ground: &[(0.0, 0.0)],
        floor: &[],
    };
    film.save("double_pendulum_moving", frames)
}

/// The path of the tip on the left; angles and energy error over time on the right.
fn draw(readings: &[Reading], energies: &[(f64, f64)], steps: usize) -> Drawn<PathBuf> {
    common::picture("double_pendulum", (1000, 560), |area| {
        let steps = format!("10 s in {steps} steps of DOP853, tolerance 1e-13.");
        let subtitle =
            format!("Two uniform rods, 1 m and 1 kg each, released at rest 60° below the horizontal. {steps}");
        let area = common::heading(area, "Double pendulum", &subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        // One metre is as long across as it is down.
        let mut path =
            common::chart(&left, "First swing (every 0.1 s) and path of the tip (m)", "", -1.1..1.1, -2.2..0.205)?;
        let swing: Vec<_> = readings.iter().take(111).step_by(10).collect();
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [elbow, tip] = reading.places;
            let colour = blend(FAINT, BLUE, 0.1 + 0.9 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), elbow, tip], line(colour, 3.5))?;
            common::dots(&mut path, [elbow, tip], 4.5, colour)?;
        }
        common::curve(&mut path, readings.iter().map(|reading| reading.places[1]), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let all = readings.iter().flat_map(|reading| reading.angles);
        let mut angles = common::chart(&upper, "Angles (rad)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &[("inner rod", BLUE), ("outer rod", ORANGE)])?;
        for (k, colour) in [BLUE, ORANGE].into_iter().enumerate() {
            common::curve(
                &mut angles,
                readings.iter().map(|reading| (reading.time, reading.angles[k])),
                line(colour, 1.8),
            )?;
        }

        let points = energies.iter().map(|(time, error)| (*time, error * 1e13));
        let range = common::range(points.clone().map(|(_, error)| error), 0.15);
        let mut error = common::chart(&lower, "Energy error (10⁻¹³ J)", "time (s)", 0.0..10.0, range)?;
        common::curve(&mut error, points, line(GREEN, 1.4))
    })
}
