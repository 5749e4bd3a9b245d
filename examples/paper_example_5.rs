//! Numerical example 5 of the paper: three bodies in a row, swinging in space on smooth balls, by the paper's scheme, by the global
//! equations (41) and (42), and by this crate's default.
//!
//! The paper gives the initial motion: all angles zero, bodies 2 and 4 at rest, body 6 turning with (0, 0.1, 0) rad/s. The body is a
//! stand-in: 1 kg, mass centre at (0.5, 0.03, −0.02) m, next ball at (1, 0, 0) m, gravity along −y.
//!
//! ```text
//! cargo run --release --example paper_example_5
//! ```

mod common;
#[path = "common/equations.rs"]
mod equations;
#[path = "pictures/paper_example_5.rs"]
mod pictures;

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, Newmark, Scheme, Slots, Solver};
use catena::spatial::index::Q;
use catena::spatial::{Ball, Dop853, Free, Pinned, RigidBody, Rotation, System};
use equations::{CENTRE, GRAVITY, INERTIA, MASS, NEXT};
use nalgebra::{Matrix3, Vector3};

/// Times, the angles of all bodies, and the force of the ground on the first.
type Record = Vec<(f64, Vec<[f64; 3]>, [f64; 3])>;

/// (5).
fn cosines(angles: [f64; 3]) -> Matrix3<f64> {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .map(|e| Vector3::from(Rotation::from_angles(angles).turned(e)));
    Matrix3::from_columns(&[x, y, z])
}

/// θ̇ of ω in body axes.
fn angle_rates([a, b, _]: [f64; 3], omega: Vector3<f64>) -> Option<Vector3<f64>> {
    let ((s1, c1), (s2, c2)) = (a.sin_cos(), b.sin_cos());
    Some(Matrix3::new(1.0, 0.0, -s2, 0.0, c1, s1 * c2, 0.0, -s1, c1 * c2).try_inverse()? * omega)
}

/// The ordinary method, integrated by the classical Runge-Kutta rule.
fn runge_kutta(start: &[([f64; 3], Vector3<f64>)], dt: f64, end: f64) -> Option<Record> {
    type State = Vec<([f64; 3], Vector3<f64>)>;
    let slope = |state: &State| -> Option<State> {
        let (angles, omega): (Vec<_>, Vec<_>) = state.iter().copied().unzip();
        let turned: Vec<_> = angles.iter().map(|angles| cosines(*angles)).collect();
        let alpha = equations::global(&turned, &omega)?;
        state.iter().zip(alpha).map(|((a, w), alpha)| Some((angle_rates(*a, *w)?.into(), alpha))).collect()
    };
    let moved = |state: &State, slope: &State, h: f64| -> State {
        let each = state.iter().zip(slope);
        each.map(|((a, w), (v, alpha))| (core::array::from_fn(|k| a[k] + h * v[k]), w + alpha * h)).collect()
    };
    let mut state: State = start.to_vec();
    let mut record = vec![];
    for step in 1..=(end / dt).round() as usize {
        let k1 = slope(&state)?;
        let k2 = slope(&moved(&state, &k1, 0.5 * dt))?;
        let k3 = slope(&moved(&state, &k2, 0.5 * dt))?;
        let k4 = slope(&moved(&state, &k3, dt))?;
        for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            state = moved(&state, &k, weight * dt / 6.0);
        }
        record.push((step as f64 * dt, state.iter().map(|(a, _)| *a).collect(), [f64::NAN; 3]));
    }
    Some(record)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let body = RigidBody::new(MASS, INERTIA, CENTRE, NEXT);
    let scene = System::new(Pinned::origin(), (body, Ball, body, Ball, body), Free)?.with_gravity([0.0, -GRAVITY, 0.0]);
    let start = scene.with_rates(scene.at_rest(&[0.0; 9])?, &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0])?;
    let end = 1.0;

    let mut near = [[0.0; 3]; 3];
    let mut exact: Record = vec![];
    let run = scene.simulation(Dop853::tolerance(1e-12)).every(0.01).run(start, end, |now| {
        for (angles, body) in near.iter_mut().zip(now.bodies().iter()) {
            *angles = body.attitude().angles_near(*angles);
        }
        exact.push((now.time(), near.to_vec(), now.stations().root().internal.force.into()));
    })?;
    let Some((_, known, force)) = exact.last().cloned() else { return Ok(()) };

    println!(
        "Example 5: three bodies on smooth balls. Errors at t = {end} s, of angles (rad) and of the force at the root (N, of 52)."
    );
    println!("The initial motion is the paper's; the body is a stand-in.\n");
    println!("  scheme                                                   step    angles     force   sweeps");
    let mut shown = vec![];
    let miss = |angles: &[[f64; 3]]| {
        angles.iter().flatten().zip(known.iter().flatten()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()))
    };
    macro_rules! row {
        ($name:expr, $scheme:expr) => {
            for dt in [0.0025, 0.00125] {
                let mut run = $scheme.start(&scene, &start, &Unloaded, dt)?;
                let mut record: Record = vec![];
                let mut broken = None;
                while run.time() < end - 0.5 * dt && broken.is_none() {
                    broken = run.step().err().map(|error| error.to_string());
                    let angles: Vec<[f64; 3]> = (0..3).filter_map(|k| run.attitude(k)).collect();
                    if broken.is_none() && angles.iter().flatten().any(|angle| angle.abs() > 20.0) {
                        broken = Some(format!("torn apart at {:.2} s", run.time()));
                    }
                    let z = run.stations()[0];
                    record.push((run.time(), angles, [z[Q], z[Q + 1], z[Q + 2]]));
                }
                match (broken, record.last()) {
                    (None, Some((_, angles, root))) => {
                        let off = root.iter().zip(force).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                        println!("  {:52} {dt:8} {:9.1e} {off:9.1e} {:8}", $name, miss(angles), run.sweeps());
                    }
                    (why, _) => println!("  {:52} {dt:8}   {}", $name, why.unwrap_or_default()),
                }
                if dt == 0.0025 {
                    shown.push(record);
                }
            }
        };
    }
    row!("as printed, corrected: Newmark β = ¼, γ = ½", Scheme::new(Newmark::new(0.25, 0.5)));
    row!("the same, γ = 0.6", Scheme::new(Newmark::damped(0.6)));
    let alpha = Scheme::new(GeneralizedAlpha::new(0.8));
    row!("generalised-α (0.8), angles 1-2-3, at t(i−1)", alpha);
    row!("generalised-α (0.8), angles 1-2-3, at the predictor", alpha.linearized(At::Predictor));
    let vectors = alpha.linearized(At::Predictor).turning_by(Slots::RotationVectors);
    row!("generalised-α (0.8), rotation vectors", vectors);
    row!("the same, Riccati", vectors.solved_by(Solver::Riccati));
    let still = ([0.0; 3], Vector3::zeros());
    let bodies = [still, still, ([0.0; 3], Vector3::new(0.0, 0.1, 0.0))];
    for dt in [0.0025, 0.00125] {
        let record = runge_kutta(&bodies, dt, end).ok_or("singular")?;
        let error = record.last().map_or(f64::NAN, |(_, angles, _)| miss(angles));
        println!(
            "  {:52} {dt:8} {error:9.1e} {:>9} {:8}",
            "global equations (41), (42), Runge-Kutta",
            "-",
            4 * record.len()
        );
    }
    println!("  {:52} {:>8} {:>9} {:>9} {:8}", "this crate: DOP853 at 1e-12", "free", "-", "-", run.sweeps);
    println!("\nPicture: {}", pictures::draw(&exact, &shown)?.display());
    Ok(())
}
