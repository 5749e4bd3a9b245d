//! Example 5 of the paper by this crate's sweeps, beside the equations (41) and (42) that the paper sets against its method.
//!
//! Three equal bodies hang on balls, released in a horizontal row; the last turns a little, so that they leave the plane. The paper
//! prints its initial motion, but not its body: a stand-in is used.
//!
//! ```text
//! cargo run --release --example three_pendulums
//! ```

mod common;

use catena::spatial::*;
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use nalgebra::{Matrix3, Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use std::error::Error;
use std::path::PathBuf;

const MASS: f64 = 1.0; // (kg)
const ABOUT_CENTRE: [[f64; 3]; 3] = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]]; // (kg·m²)
const CENTRE: [f64; 3] = [0.5, 0.03, -0.02]; // (m)
const NEXT: [f64; 3] = [1.0, 0.0, 0.0]; // the next ball (m)
const G: f64 = 9.81; // (m/s²)
const END: f64 = 2.0; // (s)
const SHOWN: f64 = 0.01; // (s)

/// Attitudes and angular velocities (body axes) of bodies 2, 4 and 6.
type State = [(Quaternion<f64>, Vector3<f64>); 3];

/// (41) with (42): angular accelerations in body axes. The inertia is that about the inboard ball; E₄₂ is printed with A₄ A₂ᵀ for A₄ᵀ A₂,
/// and F₄ with ω̃₄ J ω̃₄ for ω̃₄ J ω₄.
fn global(state: &State) -> Option<[Vector3<f64>; 3]> {
    let (m, [c, o]) = (MASS, [CENTRE, NEXT].map(Vector3::from));
    let [a2, a4, a6] = state.map(|(q, _)| UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner());
    let [w2, w4, w6] = state.map(|(_, w)| w);
    let about_centre = Matrix3::from_fn(|i, k| ABOUT_CENTRE[i][k]);
    let j = about_centre + (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * m;
    let [rc, ro, sum] = [c, o, o + c].map(|r| r.cross_matrix());
    let mut e = SMatrix::<f64, 9, 9>::zeros();
    let blocks = [
        [j - 2.0 * m * ro * ro, -m * ro * a2.transpose() * a4 * sum, -m * ro * a2.transpose() * a6 * rc],
        [-m * sum * a4.transpose() * a2 * ro, j - m * ro * ro, -m * ro * a4.transpose() * a6 * rc],
        [-m * rc * a6.transpose() * a2 * ro, -m * rc * a6.transpose() * a4 * ro, j],
    ];
    for (i, row) in blocks.iter().enumerate() {
        for (k, block) in row.iter().enumerate() {
            e.fixed_view_mut::<3, 3>(3 * i, 3 * k).copy_from(block);
        }
    }
    let up = Vector3::y();
    let spun = |w: Vector3<f64>, r: Vector3<f64>| w.cross(&w.cross(&r)) * m;
    let (s2, s4, s6) = (a2 * spun(w2, o), a4 * spun(w4, o), a6 * spun(w6, c));
    let f2 = -w2.cross(&(j * w2))
        - m * G * (rc + 2.0 * ro) * (a2.transpose() * up)
        - ro * (a2.transpose() * (2.0 * s2 + a4 * spun(w4, o + c) + s6));
    let f4 = -w4.cross(&(j * w4))
        - m * G * sum * (a4.transpose() * up)
        - sum * (a4.transpose() * s2)
        - ro * (a4.transpose() * (s4 + s6));
    let f6 = -w6.cross(&(j * w6)) - m * G * rc * (a6.transpose() * up) - rc * (a6.transpose() * (s2 + s4));
    let mut f = SVector::<f64, 9>::zeros();
    for (i, part) in [f2, f4, f6].iter().enumerate() {
        f.fixed_rows_mut::<3>(3 * i).copy_from(part);
    }
    let found = e.lu().solve(&f)?;
    Some([0, 3, 6].map(|i| found.fixed_rows::<3>(i).into()))
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
    let body = RigidBody::new(MASS, ABOUT_CENTRE, CENTRE, NEXT);
    let chain = (body, Ball, body, Ball, body);
    let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity([0.0, -G, 0.0]);
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
        let alpha = global(&same).unwrap_or([Vector3::repeat(f64::NAN); 3]);
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
    println!("Picture: {}", draw(&readings)?.display());
    Ok(())
}

/// The angles of all bodies, and how far both ways are apart.
fn draw(readings: &[Reading]) -> Drawn<PathBuf> {
    common::picture("three_pendulums", (1000, 620), |area| {
        let subtitle =
            "Three bodies on smooth balls, released in a horizontal row, by sweeps and by the equations (41), (42).";
        let area = common::heading(area, "Example 5 of the paper", subtitle)?;
        let (upper, lower) = area.split_vertically(common::pixels(350.0));
        let (left, right) = upper.split_horizontally(common::pixels(500.0));
        let names = [("body 2", BLUE), ("body 4", ORANGE), ("body 6", GREEN)];
        for (area, axis, title) in [(&left, 2, "Angle θ₃ (rad)"), (&right, 0, "Angle θ₁ (rad)")] {
            let all = readings.iter().flat_map(|now| now.angles.map(|angles| angles[axis]));
            let mut chart = common::chart(area, title, "time (s)", 0.0..END, common::range(all, 0.08))?;
            common::legend(area, &names)?;
            for (k, (_, colour)) in names.iter().enumerate() {
                let points = readings.iter().map(|now| (now.time, now.angles[k][axis]));
                common::curve(&mut chart, points, line(*colour, 1.8))?;
            }
        }
        let logs = |which: usize| {
            readings.iter().skip(1).map(move |now| (now.time, now.differences[which].max(1e-17).log10()))
        };
        let title = "Differences: attitudes of two runs (rad), accelerations at one state (relative)";
        let mut chart = common::powers(&lower, title, "time (s)", 0.0..END, -17.0..-11.0)?;
        common::curve(&mut chart, logs(0), line(ORANGE, 1.6))?;
        common::curve(&mut chart, logs(1), line(GREY, 1.4))?;
        common::legend(&lower, &[("attitudes", ORANGE), ("accelerations", GREY)])
    })
}
