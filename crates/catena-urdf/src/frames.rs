//! Axes of bodies, chosen so that zeros show.
//!
//! A body's axes are those of its parent while its joint is at zero, so that nothing turns between them, but for the least turn
//! that lays the joint's axis along a coordinate axis. Where hinges stand at right angles, as in most robots, no turn is left at
//! all; where one leans in a coordinate plane, a turn about one axis.

use crate::algebra::{IDENTITY, Matrix, Vector, apply, least_turn, matrix, times, transpose, vector};
use crate::robot::Robot;

/// What is off by more than rounding of a product of turns is not a coordinate axis.
const ROUNDED: f64 = 8.0 * f64::EPSILON;

/// How axes of bodies are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Frames {
    /// Each joint's axis along a coordinate axis of its body, as few turns between bodies as that allows.
    #[default]
    AlongHinges,
    /// No turns between bodies: while all joints are at zero, all axes are those of the root. Joints' axes point anywhere, which
    /// the library's present elements do not mind.
    Parallel,
    /// Axes as the description has them.
    AsWritten,
}

/// The signed coordinate axis next to a unit vector.
fn nearest(axis: Vector) -> Vector {
    let most = (0..3).fold(0, |most, k| if axis[k].abs() > axis[most].abs() { k } else { most });
    let mut nearest = [0.0; 3];
    nearest[most] = axis[most].signum();
    nearest
}

/// A turn without the errors of the products it came from: one step of Newton's towards the nearest turn.
fn orthonormal(a: &Matrix) -> Matrix {
    let square = times(&transpose(a), a);
    times(a, &matrix(|i, k| 1.5 * IDENTITY[i][k] - 0.5 * square[i][k]))
}

/// Chooses axes for all bodies.
pub fn choose(robot: &mut Robot, frames: Frames) {
    if frames == Frames::AsWritten {
        return;
    }
    // For each body, its new axes as columns in its old ones; the turn that is left; and its axis.
    let mut turns: Vec<Matrix> = Vec::with_capacity(robot.bodies.len());
    let mut left = Vec::with_capacity(robot.bodies.len());
    for body in &robot.bodies {
        let parent = body.parent.map_or(IDENTITY, |parent| turns[parent]);
        let parallel = times(&transpose(&body.pose.turn), &parent);
        let axis = apply(&transpose(&parallel), body.axis);
        let along = nearest(axis);
        let (turn, axis) = if (0..3).all(|k| (along[k] - axis[k]).abs() <= ROUNDED) {
            (IDENTITY, along)
        } else if frames == Frames::AlongHinges {
            (orthonormal(&least_turn(along, axis)), along)
        } else {
            (IDENTITY, axis)
        };
        turns.push(orthonormal(&times(&parallel, &turn)));
        left.push((turn, axis));
    }
    robot.reframe(&turns);
    // What products of turns say of them but for rounding, which would double from joint to joint.
    for (body, (turn, axis)) in robot.bodies.iter_mut().zip(left) {
        (body.pose.turn, body.axis) = (turn, axis);
    }
}

/// Lays the axes of joints, which are along coordinate axes, along z: a turn of the cube for each body.
pub fn lay_along_z(robot: &mut Robot) {
    let turns: Vec<Matrix> = robot.bodies.iter().map(|body| cube_turn(body.axis)).collect();
    robot.reframe(&turns);
    for body in &mut robot.bodies {
        body.axis = [0.0, 0.0, 1.0];
    }
}

/// Axes, as columns, of which z is along a signed coordinate axis.
fn cube_turn(axis: Vector) -> Matrix {
    let along = nearest(axis);
    let third = (0..3).find(|k| along[*k] != 0.0).unwrap_or(2);
    let unit = |k: usize| vector(|i| if i == k % 3 { 1.0 } else { 0.0 });
    let first = unit(third + 1);
    let second = if along[third] > 0.0 { unit(third + 2) } else { unit(third + 2).map(|x| -x) };
    matrix(|i, k| [first, second, along][k][i])
}
