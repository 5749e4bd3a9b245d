//! A flexible pendulum, twenty rods with springs between them: what explicit and implicit rules make of a stiff scene.
//!
//! ```text
//! cargo run --release --example flexible_pendulum
//! ```

mod common;
#[path = "pictures/flexible_pendulum.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Method;
use catena::time::Rule;
use std::error::Error;
use std::f64::consts::FRAC_PI_3;
use std::time::{Duration, Instant};

/// Place of the tip at t = 2 s (m): an integration of order 8 at 1e-13 of dense equations in relative coordinates.
const REFERENCE: [f64; 2] = [0.17695383936, -0.98421480732];
/// End of the run that meets the reference (s), and of a longer one that shows what becomes of energy.
const SHORT: f64 = 2.0;
const LONG: f64 = 20.0;

type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, [(ElasticHinge<Spring<f64>>, Rod<f64>); 19]), Free>;

/// A run of a rule.
struct Record {
    name: &'static str,
    /// Times (s), energy errors (J), angles of the last rod less those of the first (rad).
    readings: Vec<[f64; 3]>,
    /// Distance of the tip from the reference (m), in a run that ends with it.
    miss: f64,
    sweeps: usize,
    wall: Duration,
}

impl Record {
    fn worst(&self) -> f64 {
        self.readings.iter().fold(0.0, |most, [_, error, _]| error.abs().max(most))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // Example 2 of X. Rui et al. 2005, with parameters of our own, for those of its figure are not in its text: a beam of
    // 1 m and 1 kg with E I = 1 N·m², of twenty rods with springs E I / ℓ between them, 60° below the horizontal, straight.
    // `Beam` would put springs in the middle of segments; here they are where the reference has them.
    let rod = Rod::uniform(0.05, 0.05); // length (m), mass (kg)
    let link = (ElasticHinge::rotary(20.0), rod); // stiffness (N·m/rad)
    let pendulum = System::new(Pinned::origin(), (rod, [link; 19]), Free)?.with_gravity(9.81);

    println!("Flexible pendulum: 20 rods (5 cm, 50 g), springs of 20 N·m/rad, released at rest at −60°\n");
    let heads = ["sweeps", "wall time", "tip error (m)", "energy error (J)"];
    println!("To t = {SHORT} s {:>28}  {:>10}  {:>14}  {:>17}", heads[0], heads[1], heads[2], heads[3]);
    // The fastest vibration swings at 2741 rad/s. An explicit rule has to follow it, whatever the accuracy asked for.
    let exact = run(&pendulum, "DOP853, tolerance 1e-10", Dop853::tolerance(1e-10), SHORT)?;
    show(&exact);
    show(&run(&pendulum, "DOP853, tolerance 1e-4", Dop853::tolerance(1e-4), SHORT)?);
    // An implicit rule may step over it.
    show(&run(&pendulum, "generalised-alpha, 10 ms", GeneralizedAlpha::new(0.8).step(0.01), SHORT)?);
    show(&run(&pendulum, "generalised-alpha, 1 ms", GeneralizedAlpha::new(0.8).step(0.001), SHORT)?);
    show(&run(&pendulum, "trapezoidal, 10 ms", GeneralizedAlpha::trapezoidal().step(0.01), SHORT)?);
    show(&run(&pendulum, "trapezoidal, 1 ms", GeneralizedAlpha::trapezoidal().step(0.001), SHORT)?);
    show(&run(&pendulum, "SDIRK4, 10 ms", Sdirk4::new().step(0.01), SHORT)?);
    show(&run(&pendulum, "SDIRK4, 2.5 ms", Sdirk4::new().step(0.0025), SHORT)?);
    show(&run(&pendulum, "SDIRK4, 1 ms", Sdirk4::new().step(0.001), SHORT)?);

    println!("\nTo t = {LONG} s with steps of 10 ms: largest energy error (J)");
    let long = [
        run(&pendulum, "generalised-alpha", GeneralizedAlpha::new(0.8).step(0.01), LONG)?,
        run(&pendulum, "trapezoidal", GeneralizedAlpha::trapezoidal().step(0.01), LONG)?,
        run(&pendulum, "SDIRK4", Sdirk4::new().step(0.01), LONG)?,
    ];
    for record in &long {
        println!("  {:28} {:.1e}", record.name, record.worst());
    }
    println!("\nPicture: {}", pictures::draw(&pendulum, &exact, &long)?.display());
    Ok(())
}

/// A line of the table.
fn show(record: &Record) {
    let Record { name, miss, sweeps, wall, .. } = record;
    println!("  {name:28} {sweeps:8}  {:7.1} ms  {miss:14.1e}  {:17.1e}", wall.as_secs_f64() * 1e3, record.worst());
}

/// Runs to a time, and reads energy at every step.
fn run<M>(pendulum: &Pendulum, name: &'static str, rule: Rule<M, f64>, end: f64) -> Result<Record, Box<dyn Error>>
where
    M: for<'s> Method<&'s Pendulum, Unloaded>,
{
    let start = pendulum.at_rest(&[-FRAC_PI_3; 20])?;
    let initial = pendulum.budget(&start)?.energy();
    let mut readings = vec![];
    let clock = Instant::now();
    let run = pendulum.simulate(start, rule, end, |now| {
        let angles = now.angles();
        let bend = angles.get(19).zip(angles.get(0)).map_or(f64::NAN, |(last, first)| last - first);
        readings.push([now.time(), now.energy() - initial, bend]);
    })?;
    let wall = clock.elapsed();
    let tip = pendulum.stations(&run.motion, &Unloaded)?.tip().frame.place;
    let miss = (tip.x - REFERENCE[0]).hypot(tip.y - REFERENCE[1]);
    Ok(Record { name, readings, miss, sweeps: run.sweeps, wall })
}
