//! Andrews' squeezing mechanism, a test of solvers for mechanical systems: seven bodies whose four arms from the ground meet in one
//! point, driven by a constant moment, for 0.03 s.
//!
//! ```text
//! cargo run --release --example andrews_squeezer
//! ```

mod common;
#[path = "common/squeezer.rs"]
mod squeezer;

use catena::observe::PerBody;
use catena::planar::*;
use common::film::Film;
use common::{BLUE, Drawn, FAINT, GREEN, INK, ORANGE, blend, line};
use squeezer::{A, B, C, CLOSING, END, HOOK, REFERENCE, START, absolute, relative, squeezer, wrench};
use std::error::Error;
use std::path::PathBuf;
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
    println!("\nPictures: {}", draw(&readings)?.display());
    println!("          {}", film(&readings)?.display());
    Ok(())
}

/// The mechanism at the start and at the end and the path of E on the left; angles and forces over time on the right.
fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("andrews_squeezer", (1000, 560), |area| {
        let subtitle = "Seven bodies, four arms from the ground to one point; a constant moment drives the crank.";
        let area = common::heading(area, "Andrews' squeezing mechanism", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(470.0));
        let (upper, lower) = right.split_vertically(common::pixels(250.0));

        let title = "Every 2 ms from 0.012 s, path of their end (mm)";
        let mm = |(x, y): (f64, f64)| (1e3 * x, 1e3 * y);
        let ground = |[x, y]: [f64; 2]| mm((x, y));
        let mut path = common::chart(&left, title, "", -80.0..30.0, -50.0..80.0)?;
        let shown: Vec<_> = readings.iter().skip(240).step_by(40).collect();
        for (k, reading) in shown.iter().enumerate() {
            let share = k as f64 / (shown.len() - 1) as f64;
            let colour = blend(FAINT, INK, 0.1 + 0.8 * share.powi(3));
            let [k1, _, _, k5, _, k7, _] = reading.ends.map(mm);
            let meet = mm(reading.ends[1]);
            for arm in [
                vec![(0.0, 0.0), k1, meet],
                vec![ground(B), meet],
                vec![ground(A), k5, meet],
                vec![ground(A), k7, meet],
                vec![ground(B), mm(reading.hook)],
            ] {
                common::links(&mut path, arm, line(colour, 2.4))?;
            }
            common::links(&mut path, vec![ground(C), mm(reading.hook)], line(blend(FAINT, GREEN, share.powi(3)), 1.4))?;
            common::dots(&mut path, [k1, k5, k7, meet], 3.0, colour)?;
        }
        common::curve(&mut path, readings.iter().map(|reading| mm(reading.ends[1])), line(ORANGE, 1.2))?;
        common::dots(&mut path, [(0.0, 0.0), ground(A), ground(B), ground(C)], 4.5, INK)?;

        let names = [("gamma", 2, BLUE), ("Phi", 3, ORANGE), ("delta", 4, GREEN), ("epsilon", 6, INK)];
        let end = 1e3 * END;
        let all = readings.iter().flat_map(|reading| names.map(|(_, k, _)| reading.angles[k]));
        let mut angles = common::chart(&upper, "Angles (rad)", "time (ms)", 0.0..end, common::range(all, 0.08))?;
        common::legend(&upper, &names.map(|(name, _, colour)| (name, colour)))?;
        for (_, k, colour) in names {
            common::curve(&mut angles, readings.iter().map(|r| (1e3 * r.time, r.angles[k])), line(colour, 1.4))?;
        }
        let names = [("K3", BLUE), ("K4", ORANGE), ("K6", GREEN)];
        let all = readings.iter().flat_map(|reading| reading.forces);
        let title = "Forces at the point where the arms meet (N)";
        let mut forces = common::chart(&lower, title, "time (ms)", 0.0..end, common::range(all, 0.08))?;
        common::legend(&lower, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            common::curve(&mut forces, readings.iter().map(|r| (1e3 * r.time, r.forces[k])), line(colour, 1.4))?;
        }
        Ok(())
    })
}

/// The mechanism as it moves, slowed down.
fn film(readings: &[Reading]) -> Drawn<PathBuf> {
    let frames: Vec<_> = readings
        .iter()
        .step_by(4)
        .map(|now| {
            let [k1, _, _, k5, _, k7, _] = now.ends;
            let meet = now.ends[1];
            let ground = |[x, y]: [f64; 2]| (x, y);
            vec![
                vec![(0.0, 0.0), k1, meet],
                vec![ground(A), k5, meet],
                vec![ground(A), k7, meet],
                vec![ground(B), now.hook, meet],
                vec![ground(C), now.hook],
            ]
        })
        .collect();
    let film = Film {
        title: "Andrews' squeezing mechanism",
        subtitle: "Seven bodies meet in one point; a constant moment drives the crank.",
        view: (-0.085..0.045, -0.045..0.085),
        scale: 4000.0,
        seconds: [END, 12.0],
        strokes: &[(ORANGE, 5.0), (BLUE, 5.0), (BLUE, 5.0), (INK, 5.0), (GREEN, 2.0)],
        trace: (0, 2, ORANGE),
        ground: &[(0.0, 0.0), (A[0], A[1]), (B[0], B[1]), (C[0], C[1])],
        floor: &[],
    };
    film.save("andrews_squeezer_moving", &frames)
}
