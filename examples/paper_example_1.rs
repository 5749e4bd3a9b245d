//! Numerical example 1 of the paper: a rigid double pendulum, by the paper's scheme, by its better variants, and by this crate's default.
//!
//! The paper's parameters stand in its figure 2(a), which its text does not repeat. Here: two uniform rods of 1 m and 1 kg, released at
//! rest 60° below the horizontal, g = 9.81 m/s². The paper says that steps are equal for all methods, not how large.
//!
//! ```text
//! cargo run --release --example paper_example_1
//! ```

mod common;
#[path = "pictures/paper_example_1.rs"]
mod pictures;

use catena::Error;
use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{Dop853, Free, Pin, Pinned, Rod, System};
use std::{cell::RefCell, collections::BTreeSet, f64::consts::FRAC_PI_3};

type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

/// Angles of both rods at a time, and the force of the ground on the first at the time at which the rule balances forces.
struct Instant {
    time: f64,
    angles: [f64; 2],
    balance: f64,
    force: [f64; 2],
}

/// A motion at the multiples of a step, and what ended it before its time.
struct Record {
    instants: Vec<Instant>,
    broken: Option<Error>,
}

/// Runs of the two formulations have the same methods.
macro_rules! record {
    ($pendulum:expr, $scheme:expr, $dt:expr, $end:expr) => {{
        let start = $pendulum.at_rest(&[-FRAC_PI_3; 2])?;
        let mut run = $scheme.start($pendulum, &start, &Unloaded, $dt)?;
        let mut record = Record { instants: vec![], broken: None };
        while run.time() + 0.5 * $dt < $end {
            if let Err(error) = run.step() {
                record.broken = Some(error);
                break;
            }
            let mut angles = run.angles();
            let angles = [(); 2].map(|()| angles.next().unwrap_or(f64::NAN));
            let ground = run.stations()[0];
            let (time, balance) = (run.time(), run.balance_time());
            record.instants.push(Instant { time, angles, balance, force: [ground[4], ground[5]] });
        }
        record
    }};
}

/// The crate's default at the same instants: DOP853 at 1e-12, as good as exact here.
fn exact(pendulum: &Pendulum, dt: f64, end: f64) -> Result<(Vec<Instant>, usize), Box<dyn std::error::Error>> {
    let start = pendulum.at_rest(&[-FRAC_PI_3; 2])?;
    let mut instants = vec![];
    let run = pendulum.simulation(Dop853::tolerance(1e-12)).every(dt).run(start, end, |now| {
        let (first, ((), second, ())) = *now.motion().position();
        let force = now.stations().root().internal.force;
        let time = now.time();
        instants.push(Instant { time, angles: [first, second], balance: time, force: [force.x, force.y] });
    })?;
    instants.remove(0); // the start
    Ok((instants, run.sweeps))
}

/// The largest error of two numbers.
fn miss(found: [f64; 2], exact: [f64; 2]) -> f64 {
    (found[0] - exact[0]).abs().max((found[1] - exact[1]).abs())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(1.0, 1.0); // length (m), mass (kg)
    let pendulum: &Pendulum = &System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let (dt, end) = (0.01, 60.0);
    let (exact, sweeps) = exact(pendulum, dt, end)?;
    println!(
        "Example 1: rigid double pendulum, steps of {dt} s. Errors after 2 s; whether it stays within 1 rad for {end} s,"
    );
    println!("25 to 30 periods. The rods are stand-ins; the force at the root is 24 N.\n");
    common::heads(&[("scheme", 44), ("angles (rad)", 12), ("force (N)", 9), ("60 s", 18)]);
    let reasons = RefCell::new(BTreeSet::<String>::new());
    let report = |name: &str, record: &Record| {
        let at = (2.0_f64 / dt).round() as usize - 1;
        let here = record.instants.get(at).zip(exact.get(at));
        let force = here.and_then(|(found, _)| {
            let (mut then, _) = crate::exact(pendulum, found.balance, found.balance).ok()?;
            Some(miss(found.force, then.pop()?.force))
        });
        let turned = |(found, exact): (&Instant, &Instant)| miss(found.angles, exact.angles);
        let shown = |error: Option<f64>| error.map_or("–".to_owned(), |error| format!("{error:.1e}"));
        let lost = record.instants.iter().zip(&exact).find(|pair| turned(*pair) > 1.0);
        let fate = match (lost, &record.broken) {
            (Some((found, _)), _) => format!("lost at {:.2} s", found.time),
            (None, Some(error)) => {
                reasons.borrow_mut().insert(Error { time: None, ..*error }.to_string());
                format!("stopped at {:.2} s", error.time.unwrap_or(f64::NAN))
            }
            (None, None) => format!("{} rad", shown(record.instants.last().zip(exact.last()).map(turned))),
        };
        println!("  {name:>44}  {:>12}  {:>9}  {fate:>18}", shown(here.map(turned)), shown(force));
    };

    let printed = record!(pendulum, Scheme::new(Newmark::new(0.25, 0.5)), dt, end);
    report("as printed: Newmark β = ¼, γ = ½", &printed);
    let damped = record!(pendulum, Scheme::new(Newmark::damped(0.6)), dt, end);
    report("as printed, γ = 0.6", &damped);
    macro_rules! rules {
        ($row:ident) => {
            $row!("Newmark, γ = ½", Newmark::new(0.25, 0.5));
            $row!("Newmark, β = 1/6, γ = ½", Newmark::new(1.0 / 6.0, 0.5));
            $row!("generalised-α (0.8)", GeneralizedAlpha::new(0.8));
            $row!("HHT-α (0.1)", hht_alpha(0.1));
            $row!("Wilson-θ (1.42)", Wilson::new(1.42));
            $row!("Houbolt", Multistep::HOUBOLT);
            $row!("Park", Multistep::PARK);
            $row!("BDF2", Multistep::BDF2);
            $row!("midpoint", Midpoint);
        };
    }
    for at in [At::Previous, At::Predictor, At::Iterated] {
        macro_rules! row {
            ($name:expr, $rule:expr) => {
                report(&format!("{}, {at:?}", $name), &record!(pendulum, Scheme::new($rule).linearized(at), dt, end))
            };
        }
        println!();
        rules!(row);
    }
    println!();
    let joints = record!(pendulum, JointScheme::new(Newmark::new(0.25, 0.5)).with_sweeps(1), dt, end);
    report("joint coordinates: Newmark γ = ½, one sweep", &joints);
    macro_rules! row {
        ($name:expr, $rule:expr) => {
            report(&format!("joint coordinates: {}", $name), &record!(pendulum, JointScheme::new($rule), dt, end))
        };
    }
    row!("Newmark, γ = 0.6", Newmark::damped(0.6));
    rules!(row);
    reasons.borrow().iter().for_each(|reason| println!("\n  Stopped: {reason}."));
    println!("\n  Forces of Wilson's and the midpoint rule are those of the instant at which they balance.");
    println!("  This crate's default, DOP853 at 1e-12, takes {sweeps} sweeps for {end} s; those above, 6000 and more.");
    println!("\nPicture: {}", pictures::draw(&exact, &printed, &damped, &joints)?.display());
    Ok(())
}
