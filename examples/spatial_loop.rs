//! A spatial four-bar linkage, released at rest: a crank and a rocker that turn about skew axes, and a coupler between two balls.
//!
//! ```text
//! cargo run --release --example spatial_loop
//! ```

mod common;

use catena::loading::Unloaded;
use catena::spatial::*;
use common::film::Film;
use common::{BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use nalgebra::Vector3;
use std::error::Error;
use std::path::PathBuf;

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
    println!("\nPictures: {}", draw(&readings)?.display());
    println!("          {}", film(&readings)?.display());
    Ok(())
}

/// A place as seen from a height, aslant.
fn seen(place: &Vector3<f64>) -> (f64, f64) {
    (0.95 * place.x - 0.3 * place.y, 0.9 * place.z + 0.15 * place.x + 0.4 * place.y)
}

/// The linkage and the paths of its balls on the left; rates and forces over time on the right.
fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("spatial_loop", (1000, 560), |area| {
        let subtitle = "A crank about z, a coupler between two balls, a rocker about a skew axis; released at rest.";
        let area = common::heading(area, "Spatial four-bar linkage", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let all = readings.iter().flat_map(|reading| reading.places.iter().map(seen)).chain([(0.0, 0.0)]);
        let (xs, ys): (Vec<_>, Vec<_>) = all.unzip();
        let (xs, ys) = (common::range(xs, 0.1), common::range(ys, 0.1));
        let mut path = common::chart(&left, "First second (every 0.1 s) and paths of balls, aslant (m)", "", xs, ys)?;
        let swing: Vec<_> = readings.iter().take(101).step_by(10).collect();
        let far = seen(&Vector3::from(FAR));
        for (k, reading) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            let [crank, coupler] = reading.places.each_ref().map(seen);
            let colour = blend(FAINT, INK, 0.1 + 0.7 * share * share);
            common::links(&mut path, vec![(0.0, 0.0), crank, coupler, far], line(colour, 3.0))?;
            common::dots(&mut path, [crank, coupler], 4.0, colour)?;
        }
        for (end, colour) in [(0, ORANGE), (1, GREEN)] {
            let places = readings.iter().map(|reading| seen(&reading.places[end]));
            common::curve(&mut path, places, line(colour, 1.2))?;
        }
        common::dots(&mut path, [(0.0, 0.0), far], 5.0, INK)?;

        let names = [("crank", BLUE), ("rocker", ORANGE)];
        let all = readings.iter().flat_map(|reading| reading.rates);
        let mut rates = common::chart(&upper, "Rates (rad/s)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&upper, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut rates, readings.iter().map(|r| (r.time, r.rates[k])), line(colour, 1.6))?;
        }
        let names = [("hinge of the crank", BLUE), ("hinge of the rocker", ORANGE), ("closing ball", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.forces);
        let mut forces = common::chart(&lower, "Forces (N)", "time (s)", 0.0..10.0, common::range(all, 0.08))?;
        common::legend(&lower, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut forces, readings.iter().map(|r| (r.time, r.forces[k])), line(colour, 1.2))?;
        }
        Ok(())
    })
}

/// The linkage as it moves, seen aslant.
fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .take(801)
        .step_by(4)
        .map(|now| {
            let [crank, coupler] = now.places.each_ref().map(seen);
            vec![vec![(0.0, 0.0), crank], vec![crank, coupler], vec![coupler, seen(&Vector3::from(FAR))]]
        })
        .collect();
    let film = Film {
        title: "Spatial four-bar linkage",
        subtitle: "Crank, coupler between two balls, rocker about a skew axis.",
        view: (-0.6..1.6, -0.75..1.05),
        scale: 220.0,
        seconds: [8.0; 2],
        strokes: &[(BLUE, 7.0), (INK, 7.0), (GREEN, 7.0)],
        trace: (1, 1, ORANGE),
        ground: &[(0.0, 0.0), seen(&Vector3::from(FAR))],
        floor: &[],
    };
    film.save("spatial_loop_moving", &frames)
}
