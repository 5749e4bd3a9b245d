//! A spatial four-bar linkage, released at rest: a crank and a rocker that turn about skew axes, and a coupler between two balls.
//!
//! ```text
//! cargo run --release --example spatial_loop
//! ```

mod common;
#[path = "pictures/spatial_loop.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::spatial::*;
use nalgebra::Vector3;
use std::error::Error;

/// Place of the rocker's hinge (m), and its axis; the crank turns about z at the origin.
const FAR: [f64; 3] = [0.7, 0.1, 0.3];
const AXIS: [f64; 3] = [0.3, 1.0, 0.2];
/// Lengths (m) of crank, coupler and rocker.
const LENGTHS: [f64; 3] = [0.3, 0.9, 0.8];
/// Gravity (m/s²), across both axes.
const GRAVITY: [f64; 3] = [0.5, -2.0, -9.0];

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Rates of crank and rocker about their axes (rad/s).
    rates: [f64; 2],
    /// Forces of the ground on crank and rocker, and in the ball that closes the loop (N).
    forces: [f64; 3],
    /// Ends of crank and coupler (m).
    places: [Vector3<f64>; 2],
    /// Distance of the ends that the ball holds together (m).
    miss: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let rod = |k: usize| Rod::uniform(LENGTHS[k], 0.02, LENGTHS[k]); // length, radius (m), 1 kg/m
    let crank_hinge = Revolute::about([0.0, 0.0, 1.0]).named("crank");
    let rocker_hinge = Revolute::about(AXIS).named("rocker");
    let reach = RigidBody::massless(FAR);

    // Two arms from the origin: crank and coupler, and a rocker whose hinge stands elsewhere. They end in one ball.
    let main = (crank_hinge, rod(0), Ball, rod(1));
    let net = Network::new(main, (reach, rocker_hinge, rod(2)), Ball);
    let linkage = System::new(Clamped::origin(), net, Free)?.with_gravity(GRAVITY);
    // Crank, coupler (angles 1-2-3) and rocker as a rough guess (rad), which is then closed by the least correction.
    let start = linkage.assembled(linkage.at_rest(&[0.4, 0.0, -0.5, 0.3, -1.1])?, &Unloaded)?;
    let energy = linkage.budget(&start)?.energy();

    let rule = Dop853::tolerance(1e-12);
    let mut readings = Vec::new();
    let mut largest = 0.0_f64; // deviation of the energy (J)
    let run = linkage.simulation(rule).every(0.01).run(start, 10.0, |now| {
        largest = largest.max((now.energy() - energy).abs());
        let (bodies, stations) = (now.bodies(), now.stations());
        let place = |k| bodies.get(k).map_or_else(Default::default, |body: &BodyMotion<f64>| body.outboard().place);
        let spin = |k| bodies.get(k).map_or_else(Default::default, |body: &BodyMotion<f64>| body.inboard.turn.spin);
        let force = |k| stations.get(k).map_or(0.0, |station: &Station<f64>| station.internal.force.norm());
        let (crank, coupler, rocker) = (place(0), place(1), place(3));
        readings.push(Reading {
            time: now.time(),
            rates: [spin(0).z, spin(3).dot(&Vector3::from(AXIS).normalize())],
            forces: [force(0), force(5), force(7)],
            places: [crank, coupler],
            miss: (coupler - rocker).norm(),
        });
    })?;

    println!(
        "Spatial four-bar linkage: crank 0.3 m about z, coupler 0.9 m between balls, rocker 0.8 m about {AXIS:?}\n"
    );
    let rates = [("time (s)", 8), ("crank (rad/s)", 13), ("rocker (rad/s)", 14)];
    common::heads(&[rates, [("crank's hinge (N)", 17), ("rocker's hinge (N)", 18), ("closing ball (N)", 16)]].concat());
    for Reading { time, rates: [a, b], forces: [p, q, r], .. } in readings.iter().step_by(100) {
        println!("  {time:8.2}  {a:13.6}  {b:14.6}  {p:17.4}  {q:18.4}  {r:16.4}");
    }

    // The same linkage, cut at its other ball: the coupler hangs from the rocker.
    let side = (reach, rocker_hinge, rod(2), Ball, rod(1));
    let other = System::new(Clamped::origin(), Network::new((crank_hinge, rod(0)), side, Ball), Free)?;
    let other = other.with_gravity(GRAVITY);
    let [p, q] = readings.first().map_or_else(Default::default, |reading| reading.places);
    let back = (p - q).normalize();
    let angles = [0.0, -back.z.asin(), back.y.atan2(back.x)];
    let [crank] = start.coordinates_of(linkage.joint("crank")?)?;
    let [rocker] = start.coordinates_of(linkage.joint("rocker")?)?;
    let begin = other.assembled(other.at_rest(&[crank, rocker, angles[0], angles[1], angles[2]])?, &Unloaded)?;
    let again = other.simulate(begin, rule, 10.0, |_| ())?.motion;
    let ends = |bodies: [Option<Vector3<f64>>; 2]| bodies.map(Option::unwrap_or_default);
    let (bodies, twins) = (linkage.body_motions(&run.motion)?, other.body_motions(&again)?);
    let [found, reference] = [
        ends([0, 3].map(|k| bodies.get(k).map(|body| body.outboard().place))),
        ends([0, 2].map(|k| twins.get(k).map(|body| body.outboard().place))),
    ];
    let apart = (found[0] - reference[0]).norm().max((found[1] - reference[1]).norm());
    println!("\nCut at its other ball, the linkage is found {apart:.1e} m from there after 10 s.");
    let miss = readings.iter().fold(0.0_f64, |worst, reading| worst.max(reading.miss));
    let ends = ends([1, 3].map(|k| bodies.get(k).map(|body| body.outboard().place)));
    println!(
        "The energy of {energy:.3} J is kept within {largest:.1e} J. The loop is closed within {miss:.1e} m between steps,"
    );
    println!("where it is only read, and within {:.1e} m after the last one.", (ends[0] - ends[1]).norm());
    println!("\nPictures: {}", pictures::draw(&readings)?.display());
    println!("          {}", pictures::film(&readings)?.display());
    Ok(())
}
