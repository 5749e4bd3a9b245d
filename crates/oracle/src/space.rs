//! A slow, plain second opinion on chains of rigid bodies in space: the Newton-Euler equations of all bodies in accelerations of
//! their mass centres and angular accelerations, joined by Lagrange multipliers,
//!
//! ```text
//! [ M  A' ] [  a ]   [ f ]
//! [ A  0  ] [ -l ] = [ b ]
//! ```
//!
//! solved as one dense system. It shares nothing with the crate under test: neither code, nor unknowns, nor recursions. A joint is
//! the list of its conditions, differentiated twice by hand.
//!
//! SI units. A body has an inboard point I (the origin of its axes), an outboard point O and a mass centre C; its spin is the angular
//! velocity in inertial axes. Joint k lies between body k and its parent, which is the ground or a body of lower number: a chain is the
//! tree in which each body has the one before as its parent.

pub mod elastic;
pub mod robot;

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

pub type Vector = Vector3<f64>;
pub type Matrix = Matrix3<f64>;

/// The matrix of a × .
pub fn tilde(a: Vector) -> Matrix {
    Matrix::new(0.0, -a.z, a.y, a.z, 0.0, -a.x, -a.y, a.x, 0.0)
}

/// The rotation by an angle about an axis, by Rodrigues' formula.
pub fn about(axis: Vector, angle: f64) -> Matrix {
    let t = tilde(axis.normalize());
    Matrix::identity() + t * angle.sin() + t * t * (1.0 - angle.cos())
}

/// R_z(c) R_y(b) R_x(a).
pub fn angles([a, b, c]: [f64; 3]) -> Matrix {
    about(Vector::z(), c) * about(Vector::y(), b) * about(Vector::x(), a)
}

/// A rigid body; vectors in its own axes.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub mass: f64,
    /// About the mass centre.
    pub inertia: Matrix,
    pub centre: Vector,
    pub outboard: Vector,
    /// Force at a point (inertial axes, body axes) and torque (inertial axes) on it.
    pub force: Vector,
    pub at: Vector,
    pub torque: Vector,
}

/// What a joint lets move. Axes in body axes; efforts are generalised forces on the outboard body (springs included).
#[derive(Clone, Copy, Debug)]
pub enum Joint {
    /// Absolute attitude, spin and torque in axes of the outboard body.
    Ball { attitude: Matrix, spin: Vector, torque: Vector },
    /// Angle, rate and torque about an axis.
    Revolute { axis: Vector, angle: f64, rate: f64, torque: f64 },
    /// The first axis is fixed to the inboard, the second to the outboard body.
    Universal { axes: [Vector; 2], angles: [f64; 2], rates: [f64; 2], torques: [f64; 2] },
    /// Slide, rate and force along an axis of the inboard body.
    Prismatic { axis: Vector, slide: f64, rate: f64, force: f64 },
    /// Slide and angle.
    Cylindrical { axis: Vector, position: [f64; 2], rates: [f64; 2], efforts: [f64; 2] },
    /// A relative attitude.
    Weld { attitude: Matrix },
    /// Place and its rate in axes of the inboard body, relative attitude, relative spin (axes of the outboard body); force at the
    /// outboard point and torque in axes of the inboard body. `together`: its points coincide.
    Elastic {
        place: Vector,
        rate: Vector,
        attitude: Matrix,
        spin: Vector,
        force: Vector,
        torque: Vector,
        together: bool,
    },
    /// Place, velocity, attitude, spin (axes of the body).
    Free { place: Vector, velocity: Vector, attitude: Matrix, spin: Vector },
}

/// A point and the body it belongs to, moving.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub place: Vector,
    pub velocity: Vector,
    pub attitude: Matrix,
    pub spin: Vector,
    /// For the ground, its accelerations.
    pub linear: Vector,
    pub angular: Vector,
}

impl Frame {
    pub fn still() -> Self {
        let o = Vector::zeros();
        Self { place: o, velocity: o, attitude: Matrix::identity(), spin: o, linear: o, angular: o }
    }
}

/// What closes a loop: it holds the outboard points of two bodies together along some directions, and the bodies about some axes
/// (inertial axes; these turn with the main body).
#[derive(Clone, Debug)]
pub struct Closing {
    pub main: usize,
    pub side: usize,
    pub along: Vec<Vector>,
    pub about: Vec<Vector>,
    /// Torque in it ON the main body (inertial axes).
    pub torque: Vector,
}

/// How the tip is held.
#[derive(Clone, Copy, Debug)]
pub enum Tip {
    Free,
    /// Its point accelerates like this.
    Pinned(Vector),
    /// Its point and its body accelerate like this.
    Clamped(Vector, Vector),
    /// Its point moves with this ground, against which its body turns about an axis (axes of the ground).
    Hinged(Frame, Vector),
}

/// Accelerations of mass centres, angular accelerations, and force and torque ON each body at its inboard point; force and torque
/// ON the last body at its tip.
#[derive(Clone, Debug)]
pub struct Answer {
    pub linear: Vec<Vector>,
    pub angular: Vec<Vector>,
    pub forces: Vec<Vector>,
    pub torques: Vec<Vector>,
    pub tip: [Vector; 2],
    /// Force and torque ON the main body at each closing.
    pub closings: Vec<[Vector; 2]>,
    /// The largest residual of loops: by how much their ends miss each other, in place and velocity along what is held.
    pub residual: f64,
}

/// A condition row: Σ linear·a + angular·α over bodies (None is the ground) = value.
struct Row {
    terms: Vec<(Option<usize>, Vector, Vector)>,
    value: f64,
}

/// Place of the inboard points, attitudes, spins and velocities of all bodies.
pub fn kinematics(ground: Frame, parents: &[Option<usize>], bodies: &[Body], joints: &[Joint]) -> Vec<Frame> {
    let mut frames: Vec<Frame> = vec![];
    for (parent, joint) in parents.iter().zip(joints) {
        let inboard = parent.map_or(ground, |j| {
            let frame = frames[j];
            let arm = frame.attitude * bodies[j].outboard;
            Frame { place: frame.place + arm, velocity: frame.velocity + frame.spin.cross(&arm), ..frame }
        });
        let Frame { place, velocity, attitude, spin, .. } = inboard;
        let mut frame = inboard;
        match *joint {
            Joint::Ball { attitude, spin, .. } => {
                frame.attitude = attitude;
                frame.spin = attitude * spin;
            }
            Joint::Revolute { axis, angle, rate, .. } => {
                frame.attitude = attitude * about(axis, angle);
                frame.spin = spin + attitude * axis.normalize() * rate;
            }
            Joint::Universal { axes, angles, rates, .. } => {
                let between = attitude * about(axes[0], angles[0]);
                frame.attitude = between * about(axes[1], angles[1]);
                frame.spin = spin + between * (axes[0].normalize() * rates[0] + axes[1].normalize() * rates[1]);
            }
            Joint::Prismatic { axis, slide, rate, .. } => {
                let n = attitude * axis.normalize();
                frame.place = place + n * slide;
                frame.velocity = velocity + n * rate + spin.cross(&(n * slide));
            }
            Joint::Cylindrical { axis, position, rates, .. } => {
                let n = attitude * axis.normalize();
                frame.place = place + n * position[0];
                frame.velocity = velocity + n * rates[0] + spin.cross(&(n * position[0]));
                frame.attitude = attitude * about(axis, position[1]);
                frame.spin = spin + n * rates[1];
            }
            Joint::Weld { attitude: relative } => frame.attitude = attitude * relative,
            Joint::Elastic { place: d, rate, attitude: relative, spin: own, .. } => {
                frame.place = place + attitude * d;
                frame.velocity = velocity + attitude * rate + spin.cross(&(attitude * d));
                frame.attitude = attitude * relative;
                frame.spin = spin + frame.attitude * own;
            }
            Joint::Free { place: at, velocity: moving, attitude, spin } => {
                frame = Frame {
                    place: place + at,
                    velocity: velocity + moving,
                    attitude,
                    spin: attitude * spin,
                    ..inboard
                };
            }
        }
        frames.push(frame);
    }
    frames
}

/// Two directions at right angles to a vector and to each other.
fn across(n: Vector) -> [Vector; 2] {
    let other = if n.x.abs() < 0.6 { Vector::x() } else { Vector::y() };
    let first = n.cross(&other).normalize();
    [first, n.cross(&first).normalize()]
}

/// Solves a chain.
pub fn solve(ground: Frame, gravity: Vector, bodies: &[Body], joints: &[Joint], tip: Tip) -> Answer {
    let parents: Vec<Option<usize>> = (0..bodies.len()).map(|k| k.checked_sub(1)).collect();
    solve_tree(ground, gravity, &parents, bodies, joints, (bodies.len() - 1, tip))
}

/// Solves a tree, of which the outboard point of one body is held.
pub fn solve_tree(
    ground: Frame,
    gravity: Vector,
    parents: &[Option<usize>],
    bodies: &[Body],
    joints: &[Joint],
    held: (usize, Tip),
) -> Answer {
    solve_closed(ground, gravity, parents, bodies, joints, held, &[])
}

/// Solves a tree with loops.
pub fn solve_closed(
    ground: Frame,
    gravity: Vector,
    parents: &[Option<usize>],
    bodies: &[Body],
    joints: &[Joint],
    (last, tip): (usize, Tip),
    closings: &[Closing],
) -> Answer {
    let n = bodies.len();
    let frames = kinematics(ground, parents, bodies, joints);
    // Vectors from mass centres, inertial axes.
    let to_inboard: Vec<Vector> = (0..n).map(|k| -(frames[k].attitude * bodies[k].centre)).collect();
    let to_outboard: Vec<Vector> =
        (0..n).map(|k| frames[k].attitude * (bodies[k].outboard - bodies[k].centre)).collect();
    let mut force: Vec<Vector> = vec![];
    let mut torque: Vec<Vector> = vec![];
    let mut world: Vec<Matrix> = vec![];
    for k in 0..n {
        let (body, frame) = (&bodies[k], &frames[k]);
        let inertia = frame.attitude * body.inertia * frame.attitude.transpose();
        world.push(inertia);
        force.push(gravity * body.mass + body.force);
        let arm = frame.attitude * (body.at - body.centre);
        torque.push(body.torque + arm.cross(&body.force) - frame.spin.cross(&(inertia * frame.spin)));
    }
    let (mut effort_force, mut effort_torque) = (vec![Vector::zeros(); n], vec![Vector::zeros(); n]);
    let mut rows: Vec<(usize, Row)> = vec![]; // with the joint; `n` is the tip, and closings follow
    for k in 0..n {
        // Inboard side.
        let (inner, spin_i, attitude_i, inner_arm, place_i, velocity_i) = match parents[k] {
            None => (None, ground.spin, ground.attitude, Vector::zeros(), ground.place, ground.velocity),
            Some(j) => {
                let (frame, body) = (&frames[j], &bodies[j]);
                let arm = frame.attitude * body.outboard;
                let velocity = frame.velocity + frame.spin.cross(&arm);
                (Some(j), frame.spin, frame.attitude, to_outboard[j], frame.place + arm, velocity)
            }
        };
        let frame = &frames[k];
        let spin_o = frame.spin;
        let relative = spin_o - spin_i;
        let (arm_i, arm_o) = (inner_arm, to_inboard[k]);
        let d = frame.place - place_i;
        let drift = frame.velocity - velocity_i;
        let centripetal = |spin: Vector, arm: Vector| spin.cross(&spin.cross(&arm));
        // a_P = a_C + α × r + ω × (ω × r); the ground's point has its own.
        let known_i = if inner.is_none() { ground.linear } else { centripetal(spin_i, arm_i) };
        let known_o = centripetal(spin_o, arm_o);
        // t · (a_O − a_I) = value, with t × and lever arms
        let point = |t: Vector, extra: Vector, value: f64| {
            // extra: coefficient of α_I besides
            let outer = (Some(k), t, arm_o.cross(&t));
            let inside = (inner, -t, -arm_i.cross(&t) + extra);
            Row { terms: vec![outer, inside], value: value - t.dot(&(known_o - known_i)) }
        };
        let turn = |t: Vector, value: f64| Row {
            terms: vec![(Some(k), Vector::zeros(), t), (inner, Vector::zeros(), -t)],
            value,
        };
        // A direction t of the inboard body along which the points do not slide: t · d = 0, twice differentiated.
        let guided = |t: Vector| {
            let known = 2.0 * spin_i.cross(&t).dot(&drift) + centripetal(spin_i, t).dot(&d);
            // (α_I × t) · d = α_I · (t × d)
            point(t, t.cross(&d), -known)
        };
        let unit = [Vector::x(), Vector::y(), Vector::z()];
        let fixed_turn = |t: Vector| turn(t, -spin_i.cross(&t).dot(&relative));
        match joints[k] {
            Joint::Ball { attitude, torque: own, .. } => {
                rows.extend(unit.map(|t| (k, point(t, Vector::zeros(), 0.0))));
                effort_torque[k] = attitude * own;
            }
            Joint::Revolute { axis, torque: own, .. } => {
                let n = attitude_i * axis.normalize();
                rows.extend(unit.map(|t| (k, point(t, Vector::zeros(), 0.0))));
                rows.extend(across(n).map(|t| (k, fixed_turn(t))));
                effort_torque[k] = n * own;
            }
            Joint::Universal { axes, torques, .. } => {
                let u = attitude_i * axes[0].normalize();
                let w = frame.attitude * axes[1].normalize();
                let normal = u.cross(&w);
                let change = spin_i.cross(&u).cross(&w) + u.cross(&spin_o.cross(&w));
                rows.extend(unit.map(|t| (k, point(t, Vector::zeros(), 0.0))));
                rows.push((k, turn(normal, -change.dot(&relative))));
                // Generalised forces about both axes: a torque M in their plane with M·u and M·w given.
                let gram = nalgebra::Matrix2::new(1.0, u.dot(&w), u.dot(&w), 1.0);
                let parts = gram.try_inverse().unwrap() * nalgebra::Vector2::new(torques[0], torques[1]);
                effort_torque[k] = u * parts.x + w * parts.y;
            }
            Joint::Prismatic { axis, force: own, .. } => {
                let n = attitude_i * axis.normalize();
                rows.extend(across(n).map(|t| (k, guided(t))));
                rows.extend(unit.map(|t| (k, turn(t, 0.0))));
                effort_force[k] = n * own;
            }
            Joint::Cylindrical { axis, efforts, .. } => {
                let n = attitude_i * axis.normalize();
                rows.extend(across(n).map(|t| (k, guided(t))));
                rows.extend(across(n).map(|t| (k, fixed_turn(t))));
                effort_force[k] = n * efforts[0];
                effort_torque[k] = n * efforts[1];
            }
            Joint::Weld { .. } => {
                rows.extend(unit.map(|t| (k, point(t, Vector::zeros(), 0.0))));
                rows.extend(unit.map(|t| (k, turn(t, 0.0))));
            }
            Joint::Elastic { force: own, torque: couple, together, .. } => {
                if together {
                    rows.extend(unit.map(|t| (k, point(t, Vector::zeros(), 0.0))));
                }
                effort_force[k] = attitude_i * own;
                effort_torque[k] = attitude_i * couple;
            }
            Joint::Free { .. } => (),
        }
        // Efforts act at the outboard point: on body k at arm_o, on the inner one at the same place of space.
        force[k] += effort_force[k];
        torque[k] += effort_torque[k] + arm_o.cross(&effort_force[k]);
        if let Some(j) = inner {
            force[j] -= effort_force[k];
            torque[j] -= effort_torque[k] + (arm_i + d).cross(&effort_force[k]);
        }
    }
    let held = |t: Vector, value: f64| {
        let arm = to_outboard[last];
        let spin = frames[last].spin;
        let known = spin.cross(&spin.cross(&arm));
        Row { terms: vec![(Some(last), t, arm.cross(&t))], value: value - t.dot(&known) }
    };
    let unit = [Vector::x(), Vector::y(), Vector::z()];
    if let Tip::Pinned(a) | Tip::Clamped(a, _) | Tip::Hinged(Frame { linear: a, .. }, _) = tip {
        rows.extend(unit.map(|t| (n, held(t, t.dot(&a)))));
    }
    if let Tip::Clamped(_, angular) = tip {
        let row = |t: Vector| Row { terms: vec![(Some(last), Vector::zeros(), t)], value: t.dot(&angular) };
        rows.extend(unit.map(|t| (n, row(t))));
    }
    let mut residual = 0.0_f64;
    for (number, Closing { main, side, along, about, torque: own }) in closings.iter().enumerate() {
        let end = |k: usize| {
            let (frame, arm) = (&frames[k], frames[k].attitude * bodies[k].outboard);
            let known = frame.spin.cross(&frame.spin.cross(&to_outboard[k]));
            (frame.place + arm, frame.velocity + frame.spin.cross(&arm), known)
        };
        let (outer, inner) = (end(*main), end(*side));
        for t in along {
            residual = residual.max(t.dot(&(outer.0 - inner.0)).abs()).max(t.dot(&(outer.1 - inner.1)).abs());
            let (a, b) = (to_outboard[*main].cross(t), to_outboard[*side].cross(t));
            let terms = vec![(Some(*main), *t, a), (Some(*side), -t, -b)];
            rows.push((n + 1 + number, Row { terms, value: -t.dot(&(outer.2 - inner.2)) }));
        }
        for t in about {
            residual = residual.max(t.dot(&(frames[*main].spin - frames[*side].spin)).abs());
            let none = Vector::zeros();
            // t · (ω_m − ω_s) = 0, differentiated, for t that turn with the main body.
            let (spin, relative) = (frames[*main].spin, frames[*main].spin - frames[*side].spin);
            let value = -spin.cross(t).dot(&relative);
            rows.push((n + 1 + number, Row { terms: vec![(Some(*main), none, *t), (Some(*side), none, -t)], value }));
        }
        torque[*main] += own;
        torque[*side] -= own;
    }

    if let Tip::Hinged(ground, axis) = tip {
        // t · (ω − ω_g) = 0, differentiated, for t that turn with the ground.
        let relative = frames[last].spin - ground.spin;
        let row = |t: Vector| Row {
            terms: vec![(Some(last), Vector::zeros(), t)],
            value: t.dot(&ground.angular) - ground.spin.cross(&t).dot(&relative),
        };
        rows.extend(across(ground.attitude * axis.normalize()).map(|t| (n, row(t))));
    }

    let (unknowns, conditions) = (6 * n, rows.len());
    let mut system = DMatrix::<f64>::zeros(unknowns + conditions, unknowns + conditions);
    let mut right = DVector::<f64>::zeros(unknowns + conditions);
    for k in 0..n {
        for i in 0..3 {
            system[(6 * k + i, 6 * k + i)] = bodies[k].mass;
            right[6 * k + i] = force[k][i];
            right[6 * k + 3 + i] = torque[k][i];
            for j in 0..3 {
                system[(6 * k + 3 + i, 6 * k + 3 + j)] = world[k][(i, j)];
            }
        }
    }
    for (r, (_, row)) in rows.iter().enumerate() {
        let r = unknowns + r;
        right[r] = row.value;
        for (body, linear, angular) in &row.terms {
            match body {
                Some(k) => {
                    for i in 0..3 {
                        system[(r, 6 * k + i)] += linear[i];
                        system[(r, 6 * k + 3 + i)] += angular[i];
                        system[(6 * k + i, r)] -= linear[i];
                        system[(6 * k + 3 + i, r)] -= angular[i];
                    }
                }
                None => right[r] -= angular.dot(&ground.angular),
            }
        }
    }
    let solution = system.lu().solve(&right).expect("a regular chain");
    let part =
        |k: usize, at: usize| Vector::new(solution[6 * k + at], solution[6 * k + at + 1], solution[6 * k + at + 2]);
    let linear: Vec<Vector> = (0..n).map(|k| part(k, 0)).collect();
    let angular: Vec<Vector> = (0..n).map(|k| part(k, 3)).collect();
    // Force and torque about I ON each body from its inboard joint: multipliers and efforts, the torque moved from C to I.
    let (mut forces, mut torques) = (effort_force.clone(), effort_torque.clone());
    let mut at_tip = [Vector::zeros(); 2];
    let mut at_closings: Vec<[Vector; 2]> = closings.iter().map(|closing| [Vector::zeros(), closing.torque]).collect();
    for (r, (joint, row)) in rows.iter().enumerate() {
        let multiplier = solution[unknowns + r];
        let (_, linear, angular) = row.terms[0];
        if *joint == n {
            at_tip[0] += linear * multiplier;
            at_tip[1] += (angular - to_outboard[last].cross(&linear)) * multiplier;
        } else if let Some(number) = joint.checked_sub(n + 1) {
            at_closings[number][0] += linear * multiplier;
            at_closings[number][1] += (angular - to_outboard[closings[number].main].cross(&linear)) * multiplier;
        } else {
            forces[*joint] += linear * multiplier;
            torques[*joint] += (angular - to_inboard[*joint].cross(&linear)) * multiplier;
        }
    }
    Answer { linear, angular, forces, torques, tip: at_tip, closings: at_closings, residual }
}
