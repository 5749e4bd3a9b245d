//! Numerical examples 4 and 5 of the paper: one body, and three bodies in a row, swinging in space on smooth balls; by the paper's scheme,
//! its eight steps spelt out here, and by the global equations (41) and (42).
//!
//! Of example 5 the paper gives the initial motion: all angles zero, bodies 2 and 4 at rest, body 6 turning with (0, 0.1, 0) rad/s.
//! The body is a stand-in: 1 kg, mass centre at (0.5, 0.03, −0.02) m, next ball at (1, 0, 0) m, gravity along −y. So is all of example
//! 4: the same body from θ = (0.3, 0.2, −0.4) rad with ω = (1, −2, 0.5) rad/s in body axes.
//!
//! ```text
//! cargo run --release --example paper_example_5
//! ```

mod common;

use catena::paper::spatial::{
    ANGLES, Attitude, External, FORCE, ONE, PLACE, Rigid, Step, TORQUE, rigid_body, smooth_ball,
};
use catena::paper::{At, Coordinate, GeneralizedAlpha, Newmark, Rule};
use catena::{Error, StateVector, TransferMatrix};
use common::{BLUE, Drawn, GREEN, GREY, ORANGE, line};
use nalgebra::{DMatrix, DVector, Matrix3, SMatrix, SVector, Vector3};
use std::path::PathBuf;

const GRAVITY: f64 = 9.81;

/// What a run of one scheme shows: times and the angles of all bodies, and the force at the root.
pub type Record = Vec<(f64, Vec<[f64; 3]>, [f64; 3])>;

/// A start, and what is known of it at t = 1 s: angles (rad) and force at the root (N) of integrations of order 8 at 1e-13 that agree
/// with another rigid-body code to 4e-13.
pub struct Example {
    /// Angles (rad) and angular velocities (rad/s) in body axes.
    pub start: Vec<([f64; 3], Vector3<f64>)>,
    /// Angles of the bodies at t = 1 s (rad).
    pub known: Vec<[f64; 3]>,
    /// Force of the ground on the first body (N).
    pub force: [f64; 3],
}

/// One body.
pub fn example_4() -> Example {
    Example {
        start: vec![([0.3, 0.2, -0.4], Vector3::new(1.0, -2.0, 0.5))],
        known: vec![[0.371281069924, 0.692770393021, -2.728768005859]],
        force: [3.620248298227, 4.963809523534, 3.596624971111],
    }
}

/// Three bodies.
pub fn example_5() -> Example {
    let still = ([0.0; 3], Vector3::zeros());
    Example {
        start: vec![still, still, ([0.0; 3], Vector3::new(0.0, 0.1, 0.0))],
        known: vec![
            [-2.997268232699, 0.013167658531, -1.811532109802],
            [-1.129140432033, -0.054226025762, -2.256123087488],
            [0.433760853716, -0.008784990424, -2.677865406295],
        ],
        force: [9.470109594365, 50.942943141779, 0.984682053201],
    }
}

/// The stand-in body; its inertia about the mass centre, moved to the ball.
fn body() -> Rigid<f64> {
    let centre = Vector3::new(0.5, 0.03, -0.02);
    let about_centre = Matrix3::new(0.02, 0.001, 0.002, 0.001, 0.09, 0.003, 0.002, 0.003, 0.1);
    let j: Matrix3<f64> = about_centre + Matrix3::identity() * centre.norm_squared() - centre * centre.transpose();
    let rows = core::array::from_fn(|i| core::array::from_fn(|k| j[(i, k)]));
    Rigid { mass: 1.0, centre: centre.into(), outboard: [1.0, 0.0, 0.0], about_inboard: rows }
}

/// (5), and H of (8) with ω = H θ̇ in body axes.
fn frames([a, b, c]: [f64; 3]) -> [Matrix3<f64>; 2] {
    let ((s1, c1), (s2, c2), (s3, c3)) = (a.sin_cos(), b.sin_cos(), c.sin_cos());
    let cosines = Matrix3::new(
        c2 * c3,
        s1 * s2 * c3 - c1 * s3,
        c1 * s2 * c3 + s1 * s3,
        c2 * s3,
        s1 * s2 * s3 + c1 * c3,
        c1 * s2 * s3 - s1 * c3,
        -s2,
        s1 * c2,
        c1 * c2,
    );
    [cosines, Matrix3::new(1.0, 0.0, -s2, 0.0, c1, s1 * c2, 0.0, -s1, c1 * c2)]
}

/// θ̇ and θ̈ from ω and ω̇ in body axes.
fn angle_rates(angles: [f64; 3], omega: Vector3<f64>, alpha: Vector3<f64>) -> Option<[Vector3<f64>; 2]> {
    let ((s1, c1), (s2, c2)) = (angles[0].sin_cos(), angles[1].sin_cos());
    let inverse = frames(angles)[1].try_inverse()?;
    let v = inverse * omega;
    let bend = Vector3::new(0.0, -s1, -c1) * (v.x * v.y)
        + Vector3::new(-c2, -s1 * s2, -c1 * s2) * (v.y * v.z)
        + Vector3::new(0.0, c1 * c2, -s1 * c2) * (v.z * v.x);
    Some([v, inverse * (alpha - bend)])
}

/// The ordinary method: angular accelerations in body axes by (41), with E₄₂ and F₄ of (42) corrected, for any number of bodies.
fn global(angles: &[[f64; 3]], omega: &[Vector3<f64>]) -> Option<Vec<Vector3<f64>>> {
    let (n, body) = (angles.len(), body());
    let [centre, next] = [body.centre, body.outboard].map(Vector3::from);
    let j = Matrix3::from_fn(|i, k| body.about_inboard[i][k]);
    let turned: Vec<Matrix3<f64>> = angles.iter().map(|a| frames(*a)[0]).collect();
    let beyond = |k: usize| (n - 1 - k) as f64; // bodies outboard
    let first = |k: usize| centre + next * beyond(k);
    let tilde = |v: Vector3<f64>| v.cross_matrix();
    let spin = |k: usize, r: Vector3<f64>| omega[k].cross(&omega[k].cross(&r));
    let (mut e, mut f) = (DMatrix::zeros(3 * n, 3 * n), DVector::zeros(3 * n));
    for i in 0..n {
        let mut block = |k: usize, value: Matrix3<f64>| e.view_mut((3 * i, 3 * k), (3, 3)).copy_from(&value);
        block(i, j - tilde(next) * tilde(next) * (body.mass * beyond(i)));
        let down = turned[i].transpose() * Vector3::y() * GRAVITY;
        let mut force = -omega[i].cross(&(j * omega[i]))
            - body.mass * first(i).cross(&down)
            - body.mass * beyond(i) * next.cross(&spin(i, next));
        for k in 0..n {
            let across = turned[i].transpose() * turned[k];
            if k > i {
                block(k, -tilde(next) * across * tilde(first(k)) * body.mass);
                force -= body.mass * next.cross(&(across * spin(k, first(k))));
            } else if k < i {
                block(k, -tilde(first(i)) * across * tilde(next) * body.mass);
                force -= body.mass * first(i).cross(&(across * spin(k, next)));
            }
        }
        f.fixed_rows_mut::<3>(3 * i).copy_from(&force);
    }
    let alpha = e.lu().solve(&f)?;
    Some((0..n).map(|k| alpha.fixed_rows::<3>(3 * k).into()).collect())
}

/// The ordinary method, integrated by the classical Runge-Kutta rule.
fn runge_kutta(start: &[([f64; 3], Vector3<f64>)], dt: f64, end: f64) -> Option<Record> {
    type State = Vec<([f64; 3], Vector3<f64>)>;
    let slope = |state: &State| -> Option<State> {
        let angles: Vec<_> = state.iter().map(|(a, _)| *a).collect();
        let omega: Vec<_> = state.iter().map(|(_, w)| *w).collect();
        let alpha = global(&angles, &omega)?;
        state.iter().zip(alpha).map(|((a, w), alpha)| Some((angle_rates(*a, *w, alpha)?[0].into(), alpha))).collect()
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

/// A body in a run: each coordinate has its own history.
struct Moving<M> {
    inboard: [Coordinate<f64, M>; 3],
    centre: [Coordinate<f64, M>; 3],
    angles: [Coordinate<f64, M>; 3],
}

/// The eight steps of section 4 for bodies 2, 4, 6, .. with balls between them.
pub fn paper<R: Rule<f64>>(
    rule: R,
    at: At,
    start: &[([f64; 3], Vector3<f64>)],
    dt: f64,
    end: f64,
) -> Result<Record, Box<dyn std::error::Error>> {
    let rigid = body();
    rule.check().map_err(Error::new)?;
    // Step 1: positions, rates and accelerations of all coordinates, from the global equations.
    let (angles, omega): (Vec<_>, Vec<_>) = start.iter().copied().unzip();
    let alpha = global(&angles, &omega).ok_or("singular")?;
    let mut bodies: Vec<Moving<R::Memory>> = vec![];
    let (mut place, mut velocity, mut acceleration) = (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
    for ((angles, omega), alpha) in start.iter().zip(alpha) {
        let turn = frames(*angles)[0];
        let [v, a] = angle_rates(*angles, *omega, alpha).ok_or("singular angles")?;
        let point = |r: [f64; 3]| {
            let r = Vector3::from(r);
            let (swing, bend) = (omega.cross(&r), alpha.cross(&r) + omega.cross(&omega.cross(&r)));
            [place + turn * r, velocity + turn * swing, acceleration + turn * bend]
        };
        let started = |[x, v, a]: [Vector3<f64>; 3]| core::array::from_fn(|k| rule.start(x[k], v[k], a[k], dt));
        bodies.push(Moving {
            inboard: started([place, velocity, acceleration]),
            centre: started(point(rigid.centre)),
            angles: core::array::from_fn(|k| rule.start(angles[k], v[k], a[k], dt)),
        });
        [place, velocity, acceleration] = point(rigid.outboard);
    }
    let external = External { force: [0.0, -GRAVITY * rigid.mass, 0.0], torque: [0.0; 3] };
    let scale = 1.5; // size of J_I + m |r_C| |r_O|

    let mut record = vec![];
    // Steps 2 and 8.
    for step in 1..=(end / dt).round() as usize {
        // Step 3.
        let known: Vec<(Attitude<f64>, Step<f64>)> = bodies
            .iter()
            .map(|body| {
                let a = body.angles;
                let [x, v, w] = [a.map(|a| a.value), a.map(|a| a.rate), a.map(|a| a.acceleration)];
                let attitude = match at {
                    At::Previous => Attitude::printed(x, v, w, dt),
                    _ => Attitude::about(
                        core::array::from_fn(|k| x[k] + v[k] * dt + 0.5 * w[k] * dt * dt),
                        core::array::from_fn(|k| v[k] + w[k] * dt),
                    ),
                };
                let chi = |c: &Coordinate<f64, R::Memory>| rule.linearize(c, dt);
                let first = chi(&a[0]);
                let step = Step {
                    chi1: first.chi1,
                    chi3: first.chi3,
                    inboard: body.inboard.each_ref().map(|c| chi(c).chi2()),
                    centre: body.centre.each_ref().map(|c| chi(c).chi2()),
                    angles: a.each_ref().map(|c| chi(c).chi2()),
                    angle_rates: a.each_ref().map(|c| chi(c).chi4()),
                };
                (attitude, step)
            })
            .collect();
        // Step 4: U = U₆U₅U₄U₃U₂, (44).
        let mut matrices: Vec<TransferMatrix<f64, 13>> = vec![];
        for (k, (attitude, step)) in known.iter().enumerate() {
            let matrix = rigid_body(&rigid, attitude, step, &external);
            if k > 0 {
                matrices.push(smooth_ball(&matrix, scale * step.chi1)?);
            }
            matrices.push(matrix);
        }
        let whole = matrices.iter().fold(TransferMatrix::identity(), |whole, matrix| whole.then(matrix));
        // Step 5: boundary conditions (46), r and m known at the root, m and q at the tip.
        let unknown = [ANGLES, ANGLES + 1, ANGLES + 2, FORCE, FORCE + 1, FORCE + 2];
        let rows = [TORQUE, TORQUE + 1, TORQUE + 2, FORCE, FORCE + 1, FORCE + 2];
        let a = SMatrix::<f64, 6, 6>::from_fn(|i, k| whole[(rows[i], unknown[k])]);
        let b = SVector::<f64, 6>::from_fn(|i, _| -whole[(rows[i], ONE)]);
        let found = a.lu().solve(&b).ok_or("singular boundary conditions")?;
        let mut z = StateVector::new([0.0; 13]);
        unknown.iter().zip(found.iter()).for_each(|(index, value)| z[*index] = *value);
        z[ONE] = 1.0;
        let root = [z[FORCE], z[FORCE + 1], z[FORCE + 2]];
        // Steps 6 and 7, (45).
        for (k, matrix) in matrices.iter().enumerate() {
            if k % 2 == 0 {
                let (body, attitude) = (&mut bodies[k / 2], &known[k / 2].0);
                let (psi, phi) = (attitude.psi(rigid.centre), attitude.phi(rigid.centre));
                for i in 0..3 {
                    let of_angles: f64 = (0..3).map(|j| psi[i][j] * z[ANGLES + j]).sum();
                    let centre = z[PLACE + i] + of_angles + phi[i]; // (25)
                    for (coordinate, value) in [
                        (&mut body.inboard[i], z[PLACE + i]),
                        (&mut body.centre[i], centre),
                        (&mut body.angles[i], z[ANGLES + i]),
                    ] {
                        let increment = value - coordinate.value;
                        rule.advance(coordinate, dt, increment);
                    }
                }
            }
            z = *matrix * z;
        }
        let angles: Vec<[f64; 3]> = bodies.iter().map(|body| body.angles.each_ref().map(|a| a.value)).collect();
        if !angles.iter().flatten().all(|a| a.abs() < 20.0) {
            return Err(format!("blown up at t = {:.3} s", step as f64 * dt).into());
        }
        record.push((step as f64 * dt, angles, root));
    }
    Ok(record)
}

/// Angles at the end against known ones.
pub fn miss(record: &Record, known: &[[f64; 3]]) -> f64 {
    let last = record.last().map(|(_, angles, _)| angles.clone()).unwrap_or_default();
    let pairs = last.iter().flatten().zip(known.iter().flatten());
    pairs.fold(0.0, |worst: f64, (a, b)| worst.max((a - b).abs()))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut shown = vec![];
    for (number, Example { start, known, force }) in [(4, example_4()), (5, example_5())] {
        let (start, end) = (&start, 1.0);
        println!(
            "Example {number}: {} on smooth balls. Errors at t = {end} s, of angles (rad) and of the force at the root (N)",
            ["one body", "three bodies"][number - 4]
        );
        println!("  scheme                                                 step    angles     force");
        for dt in [0.0025, 0.00125] {
            let mut report = |name: &str, outcome: Result<Record, Box<dyn std::error::Error>>| match outcome {
                Ok(record) => {
                    let root = record.last().map_or([f64::NAN; 3], |(_, _, root)| *root);
                    let off = root.iter().zip(force).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
                    let forces = if root[0].is_nan() { "-".to_owned() } else { format!("{off:.1e}") };
                    println!("  {name:50} {dt:8} {:9.1e} {forces:>9}", miss(&record, &known));
                    if number == 5 && dt == 0.0025 {
                        shown.push(record);
                    }
                }
                Err(error) => println!("  {name:50} {dt:8}   {error}"),
            };
            report(
                "as printed, corrected: Newmark β = ¼, γ = ½",
                paper(Newmark::new(0.25, 0.5), At::Previous, start, dt, end),
            );
            report("the same, γ = 0.6", paper(Newmark::damped(0.6), At::Previous, start, dt, end));
            report("generalised-α (0.8)", paper(GeneralizedAlpha::new(0.8), At::Previous, start, dt, end));
            report(
                "generalised-α (0.8) at the predictor",
                paper(GeneralizedAlpha::new(0.8), At::Predictor, start, dt, end),
            );
            report("global equations (41), (42), Runge-Kutta", runge_kutta(start, dt, end).ok_or("singular".into()));
        }
        println!();
    }
    println!("All bodies are stand-ins; this crate's own rules do not enter here.");
    println!("Picture: {}", draw(&shown)?.display());
    Ok(())
}

/// The angles of the three bodies: global equations below, the best scheme above.
fn draw(shown: &[Record]) -> Drawn<PathBuf> {
    common::picture("paper_example_5", (1000, 480), |area| {
        let subtitle = "Angle θ₃ of three bodies, released from a horizontal row: global equations (wide) and the paper's scheme at the predictor.";
        let area = common::heading(area, "Example 5: three bodies on smooth balls", subtitle)?;
        let (Some(exact), Some(found)) = (shown.last(), shown.iter().rev().nth(1)) else { return Ok(()) };
        let mut chart = common::chart(&area, "Angle θ₃ (rad)", "time (s)", 0.0..1.0, -3.0..0.5)?;
        common::legend(&area, &[("body 2", BLUE), ("body 4", ORANGE), ("body 6", GREEN)])?;
        for (k, colour) in [BLUE, ORANGE, GREEN].into_iter().enumerate() {
            let of = |record: &Record| record.iter().map(|(t, angles, _)| (*t, angles[k][2])).collect::<Vec<_>>();
            common::curve(&mut chart, of(exact), line(GREY, 5.0))?;
            common::curve(&mut chart, of(found), line(colour, 1.6))?;
        }
        Ok(())
    })
}
