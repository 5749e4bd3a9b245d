//! Andrews' squeezing mechanism, a test of solvers for mechanical systems: seven bodies whose four arms from the ground meet in one
//! point, driven by a constant moment, for 0.03 s.
//!
//! ```text
//! cargo run --release --example andrews_squeezer
//! ```

mod common;
#[path = "pictures/andrews_squeezer.rs"]
mod pictures;
#[path = "common/squeezer.rs"]
mod squeezer;

use catena::observe::PerBody;
use catena::planar::*;
use squeezer::{CLOSING, END, HOOK, REFERENCE, START, absolute, relative, squeezer, wrench};
use std::error::Error;
use std::time::{Duration, Instant};

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// The mechanism's seven angles (rad).
    angles: [f64; 7],
    /// Outboard ends of the seven bodies, K1, K2, K3, K5, K4, K7, K6, and the hook of the spring (m).
    ends: [(f64, f64); 7],
    hook: (f64, f64),
    /// Forces at E from the arms of K3, K4 and K6 (N).
    forces: [f64; 3],
    /// Largest distance of the ends of arms that meet in E (m).
    miss: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mechanism = squeezer()?;
    let loads = Loads::none().on_bodies(|_, k, body: &BodyMotion<f64>| wrench(k, body));
    let start = mechanism.assembled(mechanism.at_rest(&absolute(START))?, &loads)?;
    let angles =
        |all: PerBody<'_, _, _, f64>| relative(squeezer::BODIES.map(|k| all.get(k).copied().unwrap_or(f64::NAN)));

    let rule = Dop853::tolerance(1e-13);
    let mut readings = Vec::new();
    let run = mechanism.simulation(rule).loads(&loads).every(END / 600.0).run(start, END, |now| {
        let (bodies, stations) = (now.bodies(), now.stations());
        let place = |k: usize| bodies.get(k).map_or_else(Default::default, |body| body.outboard().place);
        let meet = stations.tip().frame.place;
        let hook = bodies.get(3).map_or_else(Default::default, |body| body.point(HOOK).place);
        let at = |k| {
            stations
                .get(k)
                .map_or((0.0, 0.0), |s: &Station<f64>| (s.internal.force.norm(), (s.frame.place - meet).norm()))
        };
        readings.push(Reading {
            time: now.time(),
            angles: angles(now.angles()),
            ends: squeezer::BODIES.map(|k| (place(k).x, place(k).y)),
            hook: (hook.x, hook.y),
            forces: CLOSING.map(|k| at(k).0),
            miss: CLOSING.iter().fold(0.0, |worst, k| at(*k).1.max(worst)),
        });
    })?;

    println!("Andrews' squeezing mechanism at t = 0.03 s (rad)\n");
    println!("              found               reference    relative error");
    let names = ["beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon"];
    for ((name, found), expected) in names.iter().zip(angles(mechanism.angles(&run.motion)?)).zip(REFERENCE) {
        println!("  {name:8}{found:20.14}{expected:20.14}  {:8.1e}", ((found - expected) / expected).abs());
    }
    let miss = readings.iter().fold(0.0_f64, |worst, reading| worst.max(reading.miss));
    println!("\nThe arms meet within {miss:.1e} m throughout.");

    println!("\n  largest relative error   tolerance   steps   sweeps   time (ms)");
    let mut wanted = 1e-3;
    for exponent in 5..=75 {
        let tolerance = 10_f64.powf(-0.2 * f64::from(exponent));
        let once = || {
            let run = mechanism.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(start, END, |_| ());
            run.map_err(|stopped| stopped.error)
        };
        let run = once()?;
        let of = |(found, expected): (f64, f64)| ((found - expected) / expected).abs();
        let error = angles(mechanism.angles(&run.motion)?).into_iter().zip(REFERENCE).map(of).fold(0.0, f64::max);
        if error <= wanted && wanted > 0.9e-9 {
            let mut fastest = Duration::MAX;
            for _ in 0..20 {
                let begin = Instant::now();
                std::hint::black_box(once()?);
                fastest = fastest.min(begin.elapsed());
            }
            let milliseconds = 1e3 * fastest.as_secs_f64();
            println!("  {error:22.1e}{tolerance:12.0e}{:8}{:9}{milliseconds:12.3}", run.steps, run.sweeps);
            while wanted >= error {
                wanted *= 0.1;
            }
        }
    }
    println!("\nPictures: {}", pictures::draw(&readings)?.display());
    println!("          {}", pictures::film(&readings)?.display());
    Ok(())
}
