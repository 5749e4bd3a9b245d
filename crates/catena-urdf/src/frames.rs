//! Axes of bodies, chosen so that zeros show.
//!
//! A body's axes are those of its parent while its joint is at zero, so that nothing turns between them, but for the least turn
//! that lays the joint's axis along a coordinate axis. Where hinges stand at right angles, as in most robots, no turn is left at
//! all; where one leans in a coordinate plane, a turn about one axis.

use crate::algebra::{IDENTITY, Matrix, Vector, apply, least_turn, times, transpose};
use crate::robot::Robot;

/// Beyond rounding of a product of some turns, an axis is not a coordinate axis.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

/// How axes of bodies are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Frames {
    /// Each joint's axis along a coordinate axis of its body, as few turns between bodies as that allows.
    #[default]
    AlongHinges,
    /// No turns between bodies: while all joints are at zero, all axes are those of the root. Joints' axes point anywhere.
    Parallel,
    /// As the description has them.
    AsWritten,
}

/// The signed coordinate axis next to a unit vector.
fn nearest(axis: Vector) -> Vector {
    let most = (0..3).fold(0, |most, k| if axis[k].abs() > axis[most].abs() { k } else { most });
    let mut nearest = [0.0; 3];
    nearest[most] = axis[most].signum();
    nearest
}

/// Chooses axes for all bodies.
pub fn choose(robot: &mut Robot, frames: Frames) {
    if frames == Frames::AsWritten {
        return;
    }
    // New axes of each body as columns in its old ones.
    let mut turns: Vec<Matrix> = Vec::with_capacity(robot.bodies.len());
    for body in &robot.bodies {
        let parent = body.parent.map_or(IDENTITY, |parent| turns[parent]);
        let parallel = times(&transpose(&body.pose.turn), &parent);
        let axis = apply(&transpose(&parallel), body.axis);
        let turn = match frames {
            Frames::AlongHinges => least_turn(axis, nearest(axis)).unwrap_or(IDENTITY),
            _ => IDENTITY,
        };
        turns.push(times(&parallel, &transpose(&turn)));
    }
    robot.reframe(&turns);
    // What is a coordinate axis or no turn but for rounding is one: the products above had no other error.
    for body in &mut robot.bodies {
        let along = nearest(body.axis);
        if (0..3).all(|k| (along[k] - body.axis[k]).abs() <= ROUNDED) {
            body.axis = along;
        }
        if (0..9).all(|i| (IDENTITY[i / 3][i % 3] - body.pose.turn[i / 3][i % 3]).abs() <= ROUNDED) {
            body.pose.turn = IDENTITY;
        }
    }
}
