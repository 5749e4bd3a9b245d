//! Example 5 of the paper by this crate's sweeps, beside the equations (41) and (42) that the paper sets against its method.
//!
//! Three equal bodies hang on balls, released in a horizontal row; the last turns a little, so that they leave the plane. The paper
//! prints its initial motion, but not its body: a stand-in is used.
//!
//! ```text
//! cargo run --release --example three_pendulums
//! ```

mod common;
#[path = "common/equations.rs"]
mod equations;
#[path = "pictures/three_pendulums.rs"]
mod pictures;

use catena::spatial::*;
use equations::{CENTRE, GRAVITY, INERTIA, MASS, NEXT};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::error::Error;

const END: f64 = 2.0; // (s)
const SHOWN: f64 = 0.01; // (s)

/// Attitudes and angular velocities (body axes) of bodies 2, 4 and 6.
type State = [(Quaternion<f64>, Vector3<f64>); 3];

/// Angular accelerations by (41).
fn global(state: &State) -> Option<Vec<Vector3<f64>>> {
    let turned = state.map(|(q, _)| UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner());
    equations::global(&turned, &state.map(|(_, w)| w))
}

/// Rates of the state.
fn slope(state: &State) -> Option<State> {
    let alpha = global(state)?;
    Some(core::array::from_fn(|k| {
        let (q, w) = state[k];
        (q * Quaternion::from_imag(w) * 0.5, alpha[k])
    }))
}

fn plus(a: &State, factor: f64, b: &State) -> State {
    core::array::from_fn(|k| (a[k].0 + b[k].0 * factor, a[k].1 + b[k].1 * factor))
}

/// One step of order 8: the modified midpoint rule with 2, 4, 6 and 8 substeps, extrapolated to infinitely many.
fn step(state: &State, dt: f64) -> Option<State> {
    const SUBSTEPS: [usize; 4] = [2, 4, 6, 8];
    let first = slope(state)?;
    let mut coarser: Vec<State> = vec![];
    for (j, n) in SUBSTEPS.into_iter().enumerate() {
        let h = dt / n as f64;
        let (mut before, mut now) = (*state, plus(state, h, &first));
        for _ in 1..n {
            (before, now) = (now, plus(&before, 2.0 * h, &slope(&now)?));
        }
        let mut finer = vec![now];
        for (i, coarse) in coarser.iter().enumerate() {
            let share = 1.0 / ((n as f64 / SUBSTEPS[j - 1 - i] as f64).powi(2) - 1.0);
            let fine = finer[i];
            finer.push(plus(&plus(&fine, share, &fine), -share, coarse));
        }
        coarser = finer;
    }
    coarser.last().map(|state| state.map(|(q, w)| (q.normalize(), w)))
}

/// What is kept of each instant.
struct Reading {
    time: f64,
    /// Angles 1-2-3 of the bodies (rad).
    angles: [[f64; 3]; 3],
    /// Largest difference between angles found both ways (rad), and between angular accelerations of one state (rad/s²).
    differences: [f64; 2],
    energy: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let body = RigidBody::new(MASS, INERTIA, CENTRE, NEXT);
    let chain = (body, Ball, body, Ball, body);
    let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, -GRAVITY, 0.0]);
    let rates = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0];
    let start = pendulum.with_rates(pendulum.motion(), &rates)?;

    let mut other: State = [(Quaternion::identity(), Vector3::zeros()); 3];
    other[2].1.y = 0.1;
    let (substeps, mut failed) = (4, false);
    let mut readings: Vec<Reading> = vec![];
    let run = pendulum.simulation(Dop853::tolerance(1e-13)).every(SHOWN).run(start, END, |now| {
        let before = readings.last().map_or([[0.0; 3]; 3], |last| last.angles);
        if !readings.is_empty() {
            for _ in 0..substeps {
                match step(&other, SHOWN / substeps as f64) {
                    Some(next) => other = next,
                    None => failed = true,
                }
            }
        }
        let mut same = other;
        let (mut angles, mut differences) = (before, [0.0_f64; 2]);
        for (k, body) in now.bodies().iter().enumerate() {
            angles[k] = body.attitude().angles_near(before[k]);
            let [w, x, y, z] = body.attitude().quaternion();
            same[k] = (Quaternion::new(w, x, y, z), Vector3::from(body.rate()));
            let q = other[k].0;
            if let Ok(attitude) = Rotation::from_quaternion([q.w, q.i, q.j, q.k]) {
                let turned = attitude.relative_to(&body.attitude()).shortest().log();
                differences[0] = differences[0].max(Vector3::from(turned).norm());
            }
        }
        // At one and the same state, what (41) says and what the sweep says.
        let alpha = global(&same).unwrap_or(vec![Vector3::repeat(f64::NAN); 3]);
        for (body, alpha) in now.bodies().iter().zip(alpha) {
            let off = (Vector3::from(body.angular_acceleration()) - alpha).norm() / alpha.norm();
            differences[1] = differences[1].max(off);
        }
        readings.push(Reading { time: now.time(), angles, differences, energy: now.energy() });
    })?;
    if failed {
        return Err("(41) is singular".into());
    }

    println!("Example 5: three bodies on balls, released along x, g = 9.81 m/s² along −y");
    println!("Sweeps: DOP853, tolerance 1e-13, {} steps. (41), (42): order 8, {} steps\n", run.steps, {
        substeps * (readings.len() - 1)
    });
    let heads = [("time (s)", 8), ("θ₁ of body 6 (rad)", 18), ("θ₂ (rad)", 12), ("θ₃ (rad)", 12)];
    let differ = [("attitudes differ (rad)", 22), ("accelerations differ", 20), ("energy error (J)", 16)];
    common::heads(&[&heads[..], &differ[..]].concat());
    let initial = readings.first().ok_or("the start is always shown")?.energy;
    for Reading { time, angles, differences: [turned, off], energy } in readings.iter().step_by(20) {
        let [a, b, c] = angles[2];
        let error = energy - initial;
        println!("  {time:8.2}  {a:18.8}  {b:12.8}  {c:12.8}  {turned:22.1e}  {off:20.1e}  {error:16.1e}");
    }
    println!("\nAttitudes of two runs; angular accelerations at one state, relative.");
    println!("Picture: {}", pictures::draw(&readings)?.display());
    Ok(())
}
