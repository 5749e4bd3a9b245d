//! Two arms that meet again hang from a rod, and swing from rest: a network of five rods.
//!
//! ```text
//! cargo run --release --example network
//! ```

mod common;
#[path = "pictures/network.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::planar::*;
use std::error::Error;
use std::f64::consts::{FRAC_PI_3, FRAC_PI_6};

/// Angles (rad) of stem, of the main and of the side arm's rods, force of the ground (N) at t = 2 s: an integration of order 8 at 1e-13 of
/// the equations of all bodies with multipliers.
const REFERENCE: [f64; 7] = [
    -1.263955149935,
    -0.769814426963,
    -1.812466841596,
    -1.572240409451,
    -0.968022549700,
    -13.346652854334,
    44.056027264111,
];
/// The station of the pin that closes the loop: after the stem, the four joints and rods of the arms.
const CLOSING: usize = 9;

/// What is kept of each instant.
struct Reading {
    time: f64,
    angles: [f64; 5],
    /// Forces at the pin of the stem, of both arms and in the pin where they meet (N).
    forces: [f64; 4],
    /// Ends of all rods (m).
    places: [(f64, f64); 5],
    /// Distance of the ends that the closing pin holds together (m).
    miss: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let rod = |length| Rod::uniform(length, length); // m, 1 kg/m

    // From the end of the stem two arms of two rods each; a pin joins the end of the second to that of the first.
    let (main, side) = ((Pin, rod(0.6), Pin, rod(0.5)), (Pin, rod(0.45), Pin, rod(0.55)));
    let net = System::new(Pinned::origin(), (rod(0.8), Network::new(main, side, Pin)), Free)?.with_gravity(9.81);

    // Bodies are numbered stem, main arm, side arm. The loop is closed to the last digit.
    let start = net.at_rest(&[-FRAC_PI_3, -FRAC_PI_6, -2.094395102393, -1.977311259432, -0.620259990849])?;
    let start = net.assembled(start, &Unloaded)?;
    let energy = net.budget(&start)?.energy();

    let rule = Dop853::tolerance(1e-13);
    let mut readings = Vec::new();
    let mut largest = 0.0_f64; // deviation of the energy (J)
    net.simulation(rule).every(0.01).run(start, 10.0, |now| {
        largest = largest.max((now.energy() - energy).abs());
        let (bodies, stations) = (now.bodies(), now.stations());
        let place = |k| bodies.get(k).map_or_else(Default::default, |body| body.outboard().place);
        let force = |k| stations.get(k).map_or(0.0, |station: &Station<f64>| station.internal.force.norm());
        let side = stations.get(CLOSING).map_or_else(Default::default, |station| station.frame.place);
        readings.push(Reading {
            time: now.time(),
            angles: std::array::from_fn(|k| bodies.get(k).map_or(f64::NAN, BodyMotion::angle)),
            forces: [force(0), force(1), force(5), force(CLOSING)],
            places: std::array::from_fn(|k| (place(k).x, place(k).y)),
            miss: (place(2) - side).norm(),
        });
    })?;

    println!("Network: a stem of 0.8 m, from its end arms of 0.6 + 0.5 m and 0.45 + 0.55 m that meet, 1 kg/m\n");
    let angles = [("time (s)", 8), ("stem (rad)", 10), ("main 1", 9), ("main 2", 9), ("side 1", 9), ("side 2", 9)];
    let forces = [("stem (N)", 9), ("main arm (N)", 12), ("side arm (N)", 12), ("closing (N)", 11)];
    common::heads(&[&angles[..], &forces[..]].concat());
    for Reading { time, angles: [a, b, c, d, e], forces: [p, q, r, s], .. } in readings.iter().step_by(100) {
        println!("  {time:8.2}  {a:10.5}  {b:9.5}  {c:9.5}  {d:9.5}  {e:9.5}  {p:9.3}  {q:12.3}  {r:12.3}  {s:11.3}");
    }

    let run = net.simulate(start, rule, 2.0, |_| ())?;
    let force = net.stations(&run.motion, &Unloaded)?.root().internal.force;
    let angles = net.angles(&run.motion)?;
    println!("\nAt t = 2 s              found                reference     error");
    let names = [
        "stem (rad)   ",
        "main, first  ",
        "main, second ",
        "side, first  ",
        "side, second ",
        "force x (N)  ",
        "force y (N)  ",
    ];
    for ((name, found), reference) in names.iter().zip(angles.iter().chain([&force.x, &force.y])).zip(REFERENCE) {
        println!("  {name}{found:20.12}  {reference:20.12}  {:8.1e}", found - reference);
    }
    let miss = readings.iter().fold(0.0_f64, |worst, reading| worst.max(reading.miss));
    println!(
        "\nOver 10 s the energy of {energy:.3} J is kept within {largest:.1e} J, the loop stays closed within {miss:.1e} m."
    );
    println!("\nPictures: {}", pictures::draw(&readings)?.display());
    println!("          {}", pictures::film(&readings)?.display());
    Ok(())
}
