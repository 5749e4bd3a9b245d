//! A four-bar linkage, released at rest: a crank, a coupler and a rocker that begins at the ground.
//!
//! ```text
//! cargo run --release --example four_bar
//! ```

mod common;
#[path = "pictures/four_bar.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::observe::PerBody;
use catena::planar::*;
use std::error::Error;

/// Angles of crank, coupler and rocker (rad), force of the ground on the crank (N) at t = 2 s: an integration of order 8 at 1e-13 of the
/// equations of all bodies with multipliers.
const REFERENCE: [f64; 5] = [-0.342364504144, 1.096726672754, 1.549911665285, -5.124790931801, 4.072642240546];
/// Numbers of crank, coupler and rocker: the body between them reaches from the origin to the rocker's pin.
const BODIES: [usize; 3] = [0, 1, 3];
/// The station of the pin that closes the loop.
const CLOSING: usize = 7;

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Angles of crank, coupler and rocker (rad).
    angles: [f64; 3],
    /// Forces of the ground on crank and rocker, and in the pin between coupler and rocker (N).
    forces: [f64; 3],
    /// Ends of crank and coupler (m).
    places: [(f64, f64); 2],
    /// Distance of the ends that the pin holds together (m).
    miss: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let rod = |length| Rod::uniform(length, length); // m, 1 kg/m

    // Two arms from the origin: crank and coupler, and a rocker whose pin stands 1 m to the right. They end in one pin.
    let main = (Pin, rod(0.5), Pin, rod(1.2));
    let side = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9));
    let linkage = System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(main, side, Pin), Free)?.with_gravity(9.81);

    // A crank at 60°, and rough guesses of the others: the loop is closed by the least correction that does it. Four digits more of the
    // same start, to compare with the reference.
    let rough = linkage.assembled(linkage.at_rest(&[std::f64::consts::FRAC_PI_3, 0.2, 1.3])?, &Unloaded)?;
    let angles = |all: PerBody<'_, _, _, f64>| BODIES.map(|k| all.get(k).copied().unwrap_or(f64::NAN));
    let start = linkage.at_rest(&[std::f64::consts::FRAC_PI_3, 0.321105014831, 1.124253820218])?;
    let start = linkage.assembled(start, &Unloaded)?;
    let energy = linkage.budget(&start)?.energy();

    let rule = Dop853::tolerance(1e-13);
    let mut readings = Vec::new();
    let mut largest = 0.0_f64; // deviation of the energy (J)
    linkage.simulation(rule).every(0.01).run(start, 10.0, |now| {
        largest = largest.max((now.energy() - energy).abs());
        let (bodies, stations) = (now.bodies(), now.stations());
        let place = |k| bodies.get(k).map_or_else(Default::default, |body| body.outboard().place);
        let force = |k| stations.get(k).map_or(0.0, |station: &Station<f64>| station.internal.force.norm());
        let rocker = stations.get(CLOSING).map_or_else(Default::default, |station| station.frame.place);
        let (crank, coupler) = (place(BODIES[0]), place(BODIES[1]));
        readings.push(Reading {
            time: now.time(),
            angles: angles(now.angles()),
            forces: [force(0), force(5), force(CLOSING)],
            places: [(crank.x, crank.y), (coupler.x, coupler.y)],
            miss: (coupler - rocker).norm(),
        });
    })?;

    println!("Four-bar linkage: crank 0.5 m, coupler 1.2 m, rocker 0.9 m, 1 kg/m, ground 1 m, g = 9.81 m/s²\n");
    let [a, b, c] = angles(linkage.angles(&rough)?);
    println!("The guess (π/3, 0.2, 1.3) closes as ({a:.6}, {b:.6}, {c:.6}) rad.\n");
    let angles_of = [("time (s)", 8), ("crank (rad)", 11), ("coupler (rad)", 13), ("rocker (rad)", 12)];
    let forces = [("crank's pin (N)", 15), ("rocker's pin (N)", 16), ("closing pin (N)", 15)];
    common::heads(&[&angles_of[..], &forces[..]].concat());
    for Reading { time, angles: [a, b, c], forces: [p, q, r], .. } in readings.iter().step_by(100) {
        println!("  {time:8.2}  {a:11.6}  {b:13.6}  {c:12.6}  {p:15.4}  {q:16.4}  {r:15.4}");
    }

    let run = linkage.simulate(start, rule, 2.0, |_| ())?;
    let stations = linkage.stations(&run.motion, &Unloaded)?;
    let force = stations.get(0).map_or_else(Default::default, |station| station.internal.force);
    let [a, b, c] = angles(linkage.angles(&run.motion)?);
    println!("\nAt t = 2 s              found                reference     error");
    let names = ["crank (rad)  ", "coupler      ", "rocker       ", "force x (N)  ", "force y (N)  "];
    for ((name, found), reference) in names.iter().zip([a, b, c, force.x, force.y]).zip(REFERENCE) {
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
