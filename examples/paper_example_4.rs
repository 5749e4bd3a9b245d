//! Numerical example 4 of the paper: a space pendulum, by the paper's scheme with both kinds of angles, and by this crate's default.
//!
//! All parameters of the paper stand in its figure 5(a), which its text does not repeat, so all here are stand-ins: one body of 1 kg, mass
//! centre at (0.5, 0.03, −0.02) m from a smooth ball at the origin, gravity along −y, released from angles 1-2-3 of
//! (0.3, 0.2, −0.4) rad with ω = (1, −2, 0.5) rad/s in body axes.
//!
//! ```text
//! cargo run --release --example paper_example_4
//! ```

mod common;

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, Newmark, Scheme, Slots, Solver};
use catena::spatial::index::Q;
use catena::spatial::{Dop853, Free, Pinned, RigidBody, System};
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use std::path::PathBuf;

/// Times, angles and the force of the ground.
type Record = Vec<(f64, [f64; 3], [f64; 3])>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let inertia: [[f64; 3]; 3] = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]]; // about the mass centre (kg·m²)
    let body = RigidBody::new(1.0, inertia, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let pendulum = System::new(Pinned::origin(), body, Free)?.with_gravity([0.0, -9.81, 0.0]);
    let start = pendulum.with_rates(pendulum.at_rest(&[0.3, 0.2, -0.4])?, &[1.0, -2.0, 0.5])?;
    let (end, every) = (5.0, 0.01);

    let mut exact: Record = vec![];
    let mut near = [0.3, 0.2, -0.4];
    let run = pendulum.simulation(Dop853::tolerance(1e-12)).every(every).run(start, end, |now| {
        let bodies = now.bodies();
        let attitude = bodies.iter().next().map(|body| body.attitude());
        near = attitude.map_or(near, |attitude| attitude.angles_near(near));
        exact.push((now.time(), near, now.stations().root().internal.force.into()));
    })?;
    let sweeps = run.sweeps;
    let largest = exact.iter().fold(0.0_f64, |largest, (_, angles, _)| largest.max(angles[1].abs()));

    println!(
        "Example 4: space pendulum of one body, {end} s. Largest errors of angles (rad) and of the force at the ball (N, up to 20)."
    );
    println!("All parameters are stand-ins. θ₂ reaches {:.0}°.\n", largest.to_degrees());
    println!("  scheme                                                   step    angles     force   sweeps");
    let mut shown: Vec<Record> = vec![];
    macro_rules! row {
        ($name:expr, $scheme:expr) => {
            for dt in [0.01, 0.0025] {
                let mut run = $scheme.start(&pendulum, &start, &Unloaded, dt)?;
                let (mut record, mut broken): (Record, _) = (vec![], None);
                while run.time() < end - 0.5 * dt {
                    if let Err(error) = run.step() {
                        broken = Some(error);
                        break;
                    }
                    let z = run.stations()[0];
                    let angles = run.attitude(0).unwrap_or([f64::NAN; 3]);
                    record.push((run.time(), angles, [z[Q], z[Q + 1], z[Q + 2]]));
                }
                let stride = (every / dt).round() as usize;
                let pairs = record.iter().skip(stride - 1).step_by(stride).zip(exact.iter().skip(1));
                let miss = |a: [f64; 3], b: [f64; 3]| (0..3).fold(0.0_f64, |worst, k| worst.max((a[k] - b[k]).abs()));
                let (angle, force) = pairs.fold((0.0_f64, 0.0_f64), |(angle, force), (found, known)| {
                    (angle.max(miss(found.1, known.1)), force.max(miss(found.2, known.2)))
                });
                let fate = broken.map_or(String::new(), |error| format!("   {error}"));
                println!("  {:52} {dt:8} {angle:9.1e} {force:9.1e} {:8}{fate}", $name, run.sweeps());
                if dt == 0.01 {
                    shown.push(record);
                }
            }
        };
    }
    let printed = Scheme::new(Newmark::new(0.25, 0.5));
    row!("as printed, corrected: Newmark β = ¼, γ = ½", printed);
    row!("the same, γ = 0.6", Scheme::new(Newmark::damped(0.6)));
    let alpha = Scheme::new(GeneralizedAlpha::new(0.8));
    row!("generalised-α (0.8), angles 1-2-3, at t(i−1)", alpha);
    row!("generalised-α (0.8), angles 1-2-3, at the predictor", alpha.linearized(At::Predictor));
    let vectors = alpha.linearized(At::Predictor).turning_by(Slots::RotationVectors);
    row!("generalised-α (0.8), rotation vectors", vectors);
    row!("the same, Riccati", vectors.solved_by(Solver::Riccati));
    println!("  {:52} {:>8} {:>9} {:>9} {sweeps:8}", "this crate: DOP853 at 1e-12", "free", "-", "-");
    println!("\nWith γ = ½ the force alternates, at any step.");
    println!("Picture: {}", draw(&exact, &shown)?.display());
    Ok(())
}

/// The angles over time, and the force.
fn draw(exact: &Record, shown: &[Record]) -> Drawn<PathBuf> {
    common::picture("paper_example_4", (1000, 620), |area| {
        let subtitle = "One body on a smooth ball; steps of 0.01 s. Wide: DOP853; thin: generalised-α at the predictor, rotation vectors.";
        let area = common::heading(area, "Example 4: space pendulum", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(300.0));
        let (Some(printed), Some(vectors)) = (shown.first(), shown.get(4)) else { return Ok(()) };
        let names = [("θ₁", BLUE), ("θ₂", ORANGE), ("θ₃", GREEN)];
        let all = exact.iter().flat_map(|(_, angles, _)| *angles);
        let mut chart = common::chart(&upper, "Angles 1-2-3 (rad)", "time (s)", 0.0..5.0, common::range(all, 0.05))?;
        common::legend(&upper, &names)?;
        for (k, (_, colour)) in names.into_iter().enumerate() {
            let of = |record: &Record| record.iter().map(|(t, angles, _)| (*t, angles[k])).collect::<Vec<_>>();
            common::curve(&mut chart, of(exact), line(GREY, 5.0))?;
            common::curve(&mut chart, of(vectors), line(colour, 1.6))?;
        }
        let title = "Vertical force at the ball (N)";
        let mut chart = common::chart(&lower, title, "time (s)", 0.0..5.0, -30.0..50.0)?;
        common::legend(&lower, &[("DOP853", GREY), ("as printed, γ = ½", ORANGE), ("generalised-α", BLUE)])?;
        let of =
            |record: &Record| record.iter().map(|(t, _, force)| (*t, force[1].clamp(-30.0, 50.0))).collect::<Vec<_>>();
        common::curve(&mut chart, of(printed), line(ORANGE, 1.0))?;
        common::curve(&mut chart, of(exact), line(GREY, 4.0))?;
        common::curve(&mut chart, of(vectors), line(BLUE, 1.6))?;
        Ok(())
    })
}
