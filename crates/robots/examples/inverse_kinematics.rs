//! Inverse kinematics of an arm of seven joints from its description (URDF): a tool follows a path by Newton's method on its Jacobian.
//!
//! Place and direction of the tool are six conditions, joints are seven. Each step is the least one that meets them to first order,
//! q += Jᵀ (J Jᵀ + λ² 1)⁻¹ e, with damping λ while the error e is large; what is left of the seventh joint draws all of them toward the
//! middle of their range.
//!
//! ```text
//! cargo run --release -p catena-robots --example inverse_kinematics
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;

use catena::robot::*;
use catena_robots::arm7_bare as arm7;
use common::camera::Camera;
use common::film::{Film, Frame, Stroke};
use common::{BLUE, Drawn, ORANGE};
use nalgebra::{Matrix6, SMatrix, SVector, Vector3, Vector6};
use std::f64::consts::TAU;
use std::path::PathBuf;
use std::time::Instant;

type Arm = arm7::Scene<f64>;
type Joints = [f64; 7];

const START: Joints = [0.3, 0.6, 0.1, 1.0, 0.1, 0.8, 0.2];
const POINTS: usize = 120;
const SECONDS: f64 = 6.0; // that the path is shown

/// Where a tool is to be (m), and which way its z axis points and its x axis is (unit vectors).
#[derive(Clone, Copy)]
struct Pose {
    place: Vector3<f64>,
    axes: [Vector3<f64>; 3],
}

/// Where the tool's tip is.
fn pose(arm: &Arm, q: &Joints) -> Result<Pose, catena::Error> {
    let tip = arm7::frame::TOOL_TIP;
    let Place { place, attitude } = arm.places(q)?[6];
    let turned = |vector: [f64; 3]| attitude.apply(Vector3::from(vector));
    // The turn of a frame is written row by row; its columns are axes.
    let axes = core::array::from_fn(|k| turned(tip.turn.map(|row| row[k])));
    Ok(Pose { place: place + turned(tip.place), axes })
}

/// What is missing: a way (m), and a turn (rad) of the axes, right to first order.
fn missing(wanted: &Pose, found: &Pose) -> Vector6<f64> {
    let way = wanted.place - found.place;
    let turn = (0..3).map(|k| found.axes[k].cross(&wanted.axes[k])).sum::<Vector3<f64>>() * 0.5;
    Vector6::new(way.x, way.y, way.z, turn.x, turn.y, turn.z)
}

/// Moves the joints until the tool is where it is wanted; gives errors, step by step.
fn solve(arm: &Arm, wanted: &Pose, q: &mut Joints) -> Result<Vec<f64>, catena::Error> {
    let mut errors = vec![];
    for _ in 0..50 {
        let error = missing(wanted, &pose(arm, q)?);
        errors.push(error.norm());
        if error.norm() < 1e-13 {
            break;
        }
        let columns = arm.jacobian(q, 6, arm7::frame::TOOL_TIP.place)?;
        let jacobian = SMatrix::<f64, 6, 7>::from_fn(|row, joint| columns[joint][row]);
        let damping = (0.3 * error.norm()).min(0.05);
        let square = jacobian * jacobian.transpose() + Matrix6::identity() * (damping * damping);
        let Some(factor) = square.cholesky() else { break };
        let step = jacobian.transpose() * factor.solve(&error);
        // What the conditions leave free: toward the middle, as far as the tool does not feel it.
        let middle =
            SVector::<f64, 7>::from_fn(|k, _| 0.5 * (arm7::LOWER[k].max(-3.0) + arm7::UPPER[k].min(3.0)) - q[k]);
        let felt = jacobian.transpose() * factor.solve(&(jacobian * middle));
        let longest = step.amax().max(0.5);
        (0..7).for_each(|k| q[k] += 0.5 / longest * step[k] + 0.1 * error.norm().min(1.0) * (middle[k] - felt[k]));
    }
    Ok(errors)
}

/// A figure of eight around a place, in a plane across x, with the tool turned as it was.
fn path(start: &Pose, share: f64) -> Pose {
    let (angle, size) = (TAU * share, 0.16);
    let way = Vector3::new(0.0, size * angle.sin(), size * 0.5 * (2.0 * angle).sin());
    Pose { place: start.place + way, ..*start }
}

fn main() -> Drawn {
    let arm = arm7::scene::<f64>()?;
    let start = pose(&arm, &START)?;

    // From far away, to see how errors fall.
    let mut q = START.map(|angle| angle + 0.25);
    let errors = solve(&arm, &start, &mut q)?;
    println!("Error of place (m) and direction (rad), step by step:");
    errors.iter().for_each(|error| println!("  {error:.3e}"));
    let last = errors.last().copied().unwrap_or(f64::NAN);
    if last.is_nan() || last > 1e-12 {
        return Err("it does not get there".into());
    }

    let (mut poses, mut worst, mut steps) = (vec![], 0.0_f64, 0);
    let begun = Instant::now();
    for point in 0..=POINTS {
        let wanted = path(&start, point as f64 / POINTS as f64);
        let errors = solve(&arm, &wanted, &mut q)?;
        worst = worst.max(errors.last().copied().unwrap_or(f64::NAN));
        steps += errors.len();
        poses.push(q);
    }
    let spent = begun.elapsed().as_secs_f64();
    println!(
        "\n{} points of a figure of eight: {steps} steps, error {worst:.1e} at most, {:.1} µs a step",
        POINTS + 1,
        1e6 * spent / steps as f64
    );
    let far = (0..7).map(|k| (poses[0][k] - poses[POINTS][k]).abs()).fold(0.0, f64::max);
    println!("after a round joints are off by {far:.3} rad: a redundant arm need not come back");
    if worst.is_nan() || worst > 1e-12 {
        return Err("it leaves its path".into());
    }
    println!("{}", draw(&arm, &poses)?.display());
    Ok(())
}

/// The arm along the path.
fn draw(arm: &Arm, poses: &[Joints]) -> Drawn<PathBuf> {
    let camera = Camera::new([2.4, -2.2, 1.5], [0.1, 0.1, 0.55]);
    let mut frames: Vec<Frame> = vec![];
    for q in poses {
        let places = arm.places(q)?.map(|place| <[f64; 3]>::from(place.place));
        let tip = <[f64; 3]>::from(pose(arm, q)?.place);
        frames.push(vec![[[0.0; 3]].into_iter().chain(places).chain([tip]).map(|place| camera.sees(place)).collect()]);
    }
    let floor = camera.floor([[-0.8, -0.8], [0.8, 0.8]], 0.2);
    let film = Film {
        title: "Inverse kinematics",
        subtitle: "Seven joints, six conditions: a tool on a figure of eight.",
        view: (-1.0..1.0, -0.75..1.1),
        scale: 270.0,
        seconds: [SECONDS; 2],
        strokes: &[Stroke::links(BLUE, 8.0)],
        trace: Some((0, 8, ORANGE)),
        ground: &[camera.sees([0.0; 3])],
        floor: &floor,
        ..Film::default()
    };
    film.save("inverse_kinematics", &frames)
}
