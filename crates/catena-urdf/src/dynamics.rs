//! The plain dynamics behind the test in a module, and for comparison: all vectors in axes of the ground, O(n²), sharing nothing
//! with the library it checks.

use crate::algebra::{
    IDENTITY, Matrix, Vector, ZERO, about, add, apply, cross, dot, scale, subtract, times, transpose, turned,
};
use crate::error::{Error, Fault};
use crate::inertia::Inertia;
use crate::model::Furniture;
use crate::robot::{Body, Robot};

/// Positions and rates. The base stays as it is without one.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Place of the base (m).
    pub place: Vector,
    /// Attitude of the base: its axes as columns.
    pub attitude: Matrix,
    /// Velocity (m/s, axes of the ground) and angular velocity (rad/s, axes of the base).
    pub base_rates: [Vector; 2],
    /// Coordinates of the joints (rad, m).
    pub q: Vec<f64>,
    /// Rates of the joint coordinates (rad/s, m/s).
    pub rates: Vec<f64>,
}

impl State {
    /// All zero.
    pub fn zero(robot: &Robot) -> Self {
        let joints = vec![0.0; robot.bodies.len()];
        Self { place: ZERO, attitude: IDENTITY, base_rates: [ZERO; 2], q: joints.clone(), rates: joints }
    }
}

/// A body's motion.
#[derive(Clone, Copy)]
struct Motion {
    place: Vector,
    turn: Matrix,
    spin: Vector,
    angular: Vector,
    linear: Vector,
}

impl Robot {
    /// Inverse dynamics: generalised forces for accelerations, by the recursion of Newton and Euler. Those of the base are a force
    /// (axes of the ground) and a torque about its origin (axes of the base), as its accelerations are; those of joints are torques
    /// (N·m) and forces (N).
    ///
    /// # Panics
    /// Where the numbers of coordinates, rates and accelerations are not those of the robot.
    pub fn inverse_dynamics(&self, state: &State, accelerations: &[f64], gravity: Vector) -> Vec<f64> {
        let offset = self.base_freedoms();
        assert_eq!(accelerations.len(), offset + self.bodies.len(), "one acceleration for each coordinate");
        assert_eq!((state.q.len(), state.rates.len()), (self.bodies.len(), self.bodies.len()), "one for each joint");
        // Outward. The ground falls upward by gravity.
        let rest = Motion { place: ZERO, turn: IDENTITY, spin: ZERO, angular: ZERO, linear: scale(-1.0, gravity) };
        let root = if offset == 6 {
            let turn = state.attitude;
            let [_, spin] = state.base_rates;
            let of = |from: usize| [accelerations[from], accelerations[from + 1], accelerations[from + 2]];
            let (place, linear) = (state.place, add(rest.linear, of(0)));
            Motion { place, turn, linear, spin: apply(&turn, spin), angular: apply(&turn, of(3)) }
        } else {
            rest
        };
        let mut motions: Vec<Motion> = Vec::with_capacity(self.bodies.len());
        for (k, body) in self.bodies.iter().enumerate() {
            let inboard = body.parent.map_or(root, |parent| motions[parent]);
            motions.push(outboard(&inboard, body, state.q[k], state.rates[k], accelerations[offset + k]));
        }
        // Inward: force, and torque about the body's origin, that its joint must carry.
        let mut carried: Vec<[Vector; 2]> =
            self.bodies.iter().zip(&motions).map(|(body, motion)| load(&body.inertia, motion)).collect();
        let mut base = self.base.map_or([ZERO; 2], |inertia| load(&inertia, &root));
        let mut forces = vec![0.0; offset + self.bodies.len()];
        for (k, body) in self.bodies.iter().enumerate().rev() {
            let [force, torque] = carried[k];
            let axis = apply(&motions[k].turn, body.axis);
            forces[offset + k] = dot(axis, if body.slides { force } else { torque });
            let (sum, place) = match body.parent {
                Some(parent) => (&mut carried[parent], motions[parent].place),
                None => (&mut base, root.place),
            };
            let arm = subtract(motions[k].place, place);
            *sum = [add(sum[0], force), add(sum[1], add(torque, cross(arm, force)))];
        }
        if offset == 6 {
            forces[..3].copy_from_slice(&base[0]);
            forces[3..6].copy_from_slice(&apply(&transpose(&root.turn), base[1]));
        }
        forces
    }

    /// The mass matrix, a column for each acceleration of one.
    ///
    /// # Panics
    /// As [`inverse_dynamics`](Self::inverse_dynamics).
    pub fn mass_matrix(&self, state: &State) -> Vec<Vec<f64>> {
        let count = self.base_freedoms() + self.bodies.len();
        let rest = State { base_rates: [ZERO; 2], rates: vec![0.0; self.bodies.len()], ..state.clone() };
        let column = |k: usize| {
            let unit: Vec<_> = (0..count).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
            self.inverse_dynamics(&rest, &unit, ZERO)
        };
        (0..count).map(column).collect()
    }
}

/// A body's motion from that of the body inboard of its joint.
fn outboard(inboard: &Motion, body: &Body, q: f64, rate: f64, acceleration: f64) -> Motion {
    let turn = times(&inboard.turn, &body.pose.turn);
    let axis = apply(&turn, body.axis);
    let (turning, sliding) = if body.slides { (0.0, 1.0) } else { (1.0, 0.0) };
    let turn = if body.slides { turn } else { times(&turn, &about(body.axis, q)) };
    let arm = add(apply(&inboard.turn, body.pose.place), scale(sliding * q, axis));
    let spin = add(inboard.spin, scale(turning * rate, axis));
    let swept = cross(inboard.spin, axis);
    let angular = add(inboard.angular, add(scale(turning * acceleration, axis), scale(turning * rate, swept)));
    let centripetal = cross(inboard.spin, cross(inboard.spin, arm));
    let slide = add(scale(sliding * acceleration, axis), scale(2.0 * sliding * rate, swept));
    let linear = add(add(inboard.linear, cross(inboard.angular, arm)), add(centripetal, slide));
    Motion { place: add(inboard.place, arm), turn, spin, angular, linear }
}

/// Force, and torque about the body's origin, that its motion takes.
fn load(inertia: &Inertia, motion: &Motion) -> [Vector; 2] {
    let centre = apply(&motion.turn, inertia.centre);
    let tensor = turned(&motion.turn, &inertia.tensor);
    let centripetal = cross(motion.spin, cross(motion.spin, centre));
    let force = scale(inertia.mass, add(motion.linear, add(cross(motion.angular, centre), centripetal)));
    let gyroscopic = cross(motion.spin, apply(&tensor, motion.spin));
    let torque = add(apply(&tensor, motion.angular), gyroscopic);
    [force, add(torque, cross(centre, force))]
}

/// What is left of an inertia is none below this share: eliminations before it leave rounding, and no robot comes near it.
const ROUNDED: f64 = 1e-10;

/// Solves M x = b for a symmetric positive definite matrix, eliminating from the last row to the first, as a sweep from tip to root
/// does; fails with the row whose pivot is not positive.
pub fn solve(matrix: &[Vec<f64>], right: &[f64]) -> Result<Vec<f64>, usize> {
    let (mut m, mut x) = (matrix.to_vec(), right.to_vec());
    for k in (0..m.len()).rev() {
        let (others, last) = m.split_at_mut(k);
        let last = &last[0];
        let holds = last[k] > ROUNDED * matrix[k][k]; // which no NaN is
        if !holds {
            return Err(k);
        }
        for (i, row) in others.iter_mut().enumerate() {
            let factor = row[k] / last[k];
            row[..k].iter_mut().zip(&last[..k]).for_each(|(entry, by)| *entry -= factor * by);
            x[i] -= factor * x[k];
        }
    }
    for k in 0..m.len() {
        let known: f64 = (0..k).map(|j| m[k][j] * x[j]).sum();
        x[k] = (x[k] - known) / m[k][k];
    }
    Ok(x)
}

/// A state that is like no other, within limits, by a fixed rule.
pub(crate) fn sample(robot: &Robot) -> State {
    // The golden ratio's multiples spread evenly.
    let mut count = 0.0;
    let mut next = || {
        count += 1.0;
        let share: f64 = (count * 0.618_033_988_749_895_f64).fract();
        (2.0 * share - 1.0) * 0.9
    };
    let mut state = State::zero(robot);
    if robot.base.is_some() {
        state.place = [next(), next(), next()];
        state.attitude = about([0.48, 0.6, 0.64], next());
        state.base_rates = [[next(), next(), next()], [next(), next(), next()]];
    }
    for (k, body) in robot.bodies.iter().enumerate() {
        let Furniture { lower, upper, .. } = body.furniture;
        // Where the range has nothing near zero, the half unit of it that is nearest.
        let (lower, upper) = (lower.max(f64::min(-1.5, upper - 0.5)), upper.min(f64::max(1.5, lower + 0.5)));
        let middle = if lower <= upper { 0.5 * (lower + upper) } else { 0.0 };
        let half = if lower <= upper { 0.5 * (upper - lower) } else { 0.0 };
        state.q[k] = middle + half * next();
        state.rates[k] = next();
    }
    state
}

/// Fails where a joint has nothing beyond it that resists it.
pub(crate) fn check_inertia(robot: &Robot) -> Result<(), Error> {
    let offset = robot.base_freedoms();
    let matrix = robot.mass_matrix(&sample(robot));
    if !matrix.iter().flatten().all(|x| x.is_finite()) {
        return Err(Error::new(Fault::Overflow { of: "the mass matrix".to_owned() }));
    }
    let right = vec![0.0; matrix.len()];
    solve(&matrix, &right).map(|_| ()).map_err(|row| match row.checked_sub(offset) {
        Some(joint) => {
            let body = &robot.bodies[joint];
            Error::at(body.line, Fault::NoInertia { joint: body.joint.clone() })
        }
        None => Error::new(Fault::NoInertiaOfBase),
    })
}
