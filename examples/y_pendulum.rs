//! A Y pendulum, released at rest: one rod hangs from a pin, and two others from its end by pins of their own.
//!
//! ```text
//! cargo run --release --example y_pendulum
//! ```

mod common;

use catena::loading::Unloaded;
use catena::planar::*;
use common::{BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use std::error::Error;
use std::f64::consts::{FRAC_PI_3, FRAC_PI_4, FRAC_PI_6};
use std::path::PathBuf;

/// Angles (rad) and force of the ground (N) at t = 2 s: an integration of order 8 at 1e-13 of the equations of all bodies with
/// multipliers.
const REFERENCE: [f64; 5] = [-1.117158663104, -1.647557714950, -0.196107593415, -7.562255601853, 18.156646042664];

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Angles of the rods from the horizontal (rad).
    angles: [f64; 3],
    /// Forces at the pins of the stem and of both arms (N).
    forces: [f64; 3],
    /// Places of the fork and of the ends of both arms (m).
    places: [(f64, f64); 3],
}

fn main() -> Result<(), Box<dyn Error>> {
    let (stem, long, short) = (Rod::uniform(1.0, 1.0), Rod::uniform(0.7, 0.8), Rod::uniform(0.5, 0.6)); // m, kg

    // The long arm leaves the chain at the end of the stem, where `Branch` stands; the chain goes on with the short one.
    let chain = (stem, Branch((Pin, long)), Pin, short);
    let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);

    // Bodies, joints and stations are numbered in this order too: stem, long arm, short arm.
    let start = pendulum.at_rest(&[-FRAC_PI_3, -FRAC_PI_6, -3.0 * FRAC_PI_4])?;
    let energy = pendulum.budget(&start)?.energy();

    let rule = Dop853::tolerance(1e-13);
    let mut readings = Vec::new();
    let mut largest = 0.0_f64; // deviation of the energy (J)
    pendulum.simulation(rule).every(0.01).run(start, 10.0, |now| {
        largest = largest.max((now.energy() - energy).abs());
        let motion = now.motion();
        // The root's pin, then the chain: nothing moves by itself in the rods, in the arm its pin does.
        let (first, ((), (second, ()), third, ())) = *motion.position();
        let (bodies, stations) = (now.bodies(), now.stations());
        let end = |k| {
            let place = bodies.get(k).map(|body| body.outboard().place);
            place.map_or((0.0, 0.0), |place| (place.x, place.y))
        };
        // Stations: 0 the stem's inboard end, 1 and 2 the arm's pin and rod, 3 and 4 those of the chain that goes on.
        let force = |k| stations.get(k).map_or(0.0, |station: &Station<f64>| station.internal.force.norm());
        readings.push(Reading {
            time: now.time(),
            angles: [first, second, third],
            forces: [force(0), force(1), force(3)],
            places: [end(0), end(1), end(2)],
        });
    })?;

    println!("Y pendulum: a stem (1 m, 1 kg) with two arms (0.7 m, 0.8 kg; 0.5 m, 0.6 kg), g = 9.81 m/s²\n");
    let heads = [("time (s)", 8), ("stem (rad)", 10), ("long arm (rad)", 14), ("short arm (rad)", 15)];
    common::heads(&[&heads[..], &[("stem (N)", 10), ("long arm (N)", 12), ("short arm (N)", 13)]].concat());
    for Reading { time, angles: [a, b, c], forces: [p, q, r], .. } in readings.iter().step_by(100) {
        println!("  {time:8.2}  {a:10.6}  {b:14.6}  {c:15.6}  {p:10.4}  {q:12.4}  {r:13.4}");
    }

    let run = pendulum.simulate(start, rule, 2.0, |_| ())?;
    let force = pendulum.stations(&run.motion, &Unloaded)?.root().internal.force;
    let angles = pendulum.angles(&run.motion)?;
    println!("\nAt t = 2 s              found                reference     error");
    let names = ["stem (rad)   ", "long arm     ", "short arm    ", "force x (N)  ", "force y (N)  "];
    for ((name, found), reference) in names.iter().zip(angles.iter().chain([&force.x, &force.y])).zip(REFERENCE) {
        println!("  {name}{found:20.12}  {reference:20.12}  {:8.1e}", found - reference);
    }
    println!("\nThe energy of {energy:.3} J is kept within {largest:.1e} J over 10 s.");
    println!("\nPicture: {}", draw(&readings)?.display());
    Ok(())
}

/// The first swing and the paths of both ends on the left; angles and forces over time on the right.
fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("y_pendulum", (1000, 560), |area| {
        let subtitle = "A stem of 1 m and 1 kg carries arms of 0.7 m, 0.8 kg and 0.5 m, 0.6 kg; released at rest.";
        let area = common::heading(area, "Y pendulum", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        // One metre is as long across as it is down.
        let title = "First swing (every 0.1 s) and paths of the ends, 4 s (m)";
        let mut path = common::chart(&left, title, "", -1.25..1.25, -2.3..0.433)?;
        let swing: Vec<_> = readings.iter().take(71).step_by(10).collect();
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [fork, long, short] = reading.places;
            let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), fork, long], line(colour, 3.5))?;
            common::links(&mut path, vec![fork, short], line(colour, 3.5))?;
            common::dots(&mut path, [fork, long, short], 4.5, colour)?;
        }
        for (end, colour) in [(1, ORANGE), (2, GREEN)] {
            let places = readings.iter().take(401).map(|reading| reading.places[end]);
            common::curve(&mut path, places, line(colour, 1.2))?;
        }
        common::dots(&mut path, [(0.0, 0.0)], 5.0, INK)?;

        let names = [("stem", BLUE), ("long arm", ORANGE), ("short arm", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.angles);
        let mut angles = common::chart(&upper, "Angles (rad)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &names)?;
        let all = readings.iter().flat_map(|reading| reading.forces);
        let mut forces =
            common::chart(&lower, "Forces at the pins (N)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut angles, readings.iter().map(|r| (r.time, r.angles[k])), line(colour, 1.6))?;
            common::curve(&mut forces, readings.iter().map(|r| (r.time, r.forces[k])), line(colour, 1.4))?;
        }
        Ok(())
    })
}
