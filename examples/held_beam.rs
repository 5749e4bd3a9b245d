//! A strip of steel, clamped at both ends and struck in the middle: a beam that bends little and stretches for it.
//!
//! ```text
//! cargo run --release --example held_beam
//! ```

mod common;
#[path = "pictures/held_beam.rs"]
mod pictures;

use catena::loading::Loading;
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Runs;
use catena::system::Tip;
use catena::time::Rule;
use std::error::Error;
use std::f64::consts::PI;
use std::time::{Duration, Instant};

/// Segments; their number is even, so that the middle of a rod is the middle of the beam.
const K: usize = 30;
/// Length (m).
const LENGTH: f64 = 1.0;
/// The blow: half a sine of time, its duration (s) and largest force (N).
const BLOW: [f64; 2] = [2e-3, 30.0];
/// End of the run and step (s).
const TIMES: [f64; 2] = [0.1, 1e-4];

/// What is kept of an instant.
struct Reading {
    time: f64,
    /// Deflection of the middle (m).
    middle: f64,
    /// Force of the ground on the root and on the tip (N).
    ends: [[f64; 2]; 2],
    /// Places of the rods' inboard ends and of the tip (m).
    shape: Vec<(f64, f64)>,
}

/// A run, and what it took.
struct Record {
    readings: Vec<Reading>,
    sweeps: usize,
    wall: Duration,
}

type Root = Clamped<[f64; 2], f64>;
type Chain = Segments<f64, [(Slider<f64, Spring<f64, f64>>, ElasticHinge<Spring<f64, f64>>, Rod<f64>); K]>;
/// The strip, its far end held in one way or another.
type Strip<P> = System<f64, Root, Chain, P>;

fn main() -> Result<(), Box<dyn Error>> {
    // Spring steel, 10 mm wide and 1 mm thick: E A and E I with E = 210 GPa, and ρ A with ρ = 7850 kg/m³. Dampers in proportion
    // to the springs take a little from the lowest mode and much from fast ones.
    let beam = Beam::new(LENGTH, 0.175, 0.0785).with_extension(2.1e6).damped(1e-5);
    let chain = beam.segments::<K>();
    let root = Clamped::at(0.0, 0.0, 0.0);

    // Straight and unstretched between its clamps. Without E A its length would be given twice, by the rods and by the clamps,
    // and the scene be refused. Three forces hold the tip; they are found in the same sweep as the accelerations.
    let held = System::new(root, chain, Clamped::at(LENGTH, 0.0, 0.0))?;
    // The same strip with an end that may come nearer.
    let sliding = System::new(root, chain, Guided::at(LENGTH, 0.0, 0.0))?;

    // Hinges and sliders are stiff, up to 3e5 rad/s, so rules are implicit.
    let [_, step] = TIMES;
    let [duration, force] = BLOW;
    let at = [0.5 * LENGTH / K as f64, 0.0]; // the middle of a rod
    let blow = Loads::none().on_bodies(|time: f64, body, motion: &BodyMotion<f64>| {
        let now = if body == K / 2 && time < duration { force * (PI * time / duration).sin() } else { 0.0 };
        motion.force_at(at, [0.0, now])
    });
    let record = run(&held, &blow, Sdirk4::new().step(step))?;
    let free = run(&sliding, &blow, Sdirk4::new().step(step))?;

    let impulse = 2.0 / PI * force * duration;
    println!("Steel strip of 1 m × 10 mm × 1 mm in {K} segments, clamped at both ends,");
    println!("struck in the middle: {force} N for {} ms, an impulse of {:.1} mN·s\n", duration * 1e3, impulse * 1e3);
    // The blow is short, so waves are short: after some 20 ms numbers depend on how many segments there are.
    println!("SDIRK4, steps of {} ms; forces are of the ground on the strip", step * 1e3);
    let heads = [("time (ms)", 9), ("middle (mm)", 12), ("left x (N)", 10), ("left y (N)", 10)];
    common::heads(&[&heads[..], &[("right x (N)", 11), ("right y (N)", 11)]].concat());
    for reading in record.readings.iter().step_by(100) {
        let Reading { time, middle, ends: [left, right], .. } = reading;
        print!("  {:9.1}  {:12.6}", time * 1e3, middle * 1e3);
        println!("  {:10.4}  {:10.4}  {:11.4}  {:11.4}", left[0], left[1], right[0], right[1]);
    }

    let most = |record: &Record| record.readings.iter().fold(0.0, |most: f64, now| most.max(now.middle.abs()));
    println!(
        "\nLargest deflection: {:.2} mm; with an end that slides {:.2} mm",
        most(&record) * 1e3,
        most(&free) * 1e3
    );

    println!("\nOther rules                       sweeps   wall time     middle at the end (mm)");
    let show = |name: &str, record: &Record| {
        let middle = record.readings.last().map_or(f64::NAN, |now| now.middle);
        println!("  {name:28} {:9} {:8.1} ms  {:12.6}", record.sweeps, record.wall.as_secs_f64() * 1e3, middle * 1e3);
    };
    show("SDIRK4, 0.1 ms", &record);
    show("SDIRK4, tolerance 1e-6", &run(&held, &blow, Sdirk4::new().tolerance(1e-6))?);
    show("generalised-alpha, 0.1 ms", &run(&held, &blow, GeneralizedAlpha::new(0.8).step(step))?);
    show("generalised-alpha, 0.02 ms", &run(&held, &blow, GeneralizedAlpha::new(0.8).step(0.2 * step))?);
    eprintln!("  (an explicit rule follows every vibration, which takes it a second or two)");
    show("DOP853, tolerance 1e-10", &run(&held, &blow, Dop853::tolerance(1e-10))?);

    println!("\nPicture: {}", pictures::draw(&record, &free)?.display());
    Ok(())
}

/// Runs a strip under a blow, and reads it every 0.1 ms.
fn run<P, L, M>(strip: &Strip<P>, blow: &L, rule: Rule<M, f64>) -> Result<Record, catena::Error>
where
    P: Tip<Planar<f64>>,
    L: Loading<Planar<f64>>,
    Strip<P>: Runs<L, Planar<f64>, Root, Chain, P>,
    M: for<'s> Method<&'s Strip<P>, L>,
{
    let [end, step] = TIMES;
    let clock = Instant::now();
    let mut readings = vec![];
    let run = strip.simulation(rule).loads(blow).every(step).run(strip.motion(), end, |now| {
        let (bodies, stations) = (now.bodies(), now.stations());
        let (root, tip) = (stations.root().internal.force, stations.tip());
        let mut shape: Vec<_> = bodies.iter().map(|body| (body.inboard.place.x, body.inboard.place.y)).collect();
        shape.push((tip.frame.place.x, tip.frame.place.y));
        let middle = bodies.get(K / 2).map_or(f64::NAN, |body| body.centre().place.y);
        // An internal force acts on what lies outboard of its station. Beyond the tip that is the ground.
        let ends = [[root.x, root.y], [-tip.internal.force.x, -tip.internal.force.y]];
        readings.push(Reading { time: now.time(), middle, ends, shape });
    })?;
    Ok(Record { readings, sweeps: run.sweeps, wall: clock.elapsed() })
}
