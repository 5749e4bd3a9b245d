//! A slow, plain second opinion on the motion of a planar chain of rigid bodies: the Newton-Euler equations of all
//! bodies in the absolute coordinates of their mass centres, joined by Lagrange multipliers,
//!
//! ```text
//! [ M  A' ] [  a ]   [ f ]
//! [ A  0  ] [ -l ] = [ b ]
//! ```
//!
//! solved as one dense system. It shares nothing with the crate under test: neither code, nor unknowns, nor recursions.
//!
//! SI units; the plane is x, y; angles are absolute, counter-clockwise from +x, and never wrapped. A body has an
//! inboard point I (the origin of its frame), an outboard point O and a mass centre C. The chain runs from the ground
//! over the root joint to body 0, joint 1, body 1, .. and its tip, the point O of the last body.
//!
//! Section loads: on a body act the force `+q_inboard` at I and `-q_outboard` at O, the torque `-m_inboard` at I and
//! `+m_outboard` at O.

use nalgebra::{DMatrix, DVector};

pub use super::extrapolation::extrapolate;

/// A vector of the plane.
pub type Vector = [f64; 2];

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

pub fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub fn scale(s: f64, a: Vector) -> Vector {
    [s * a[0], s * a[1]]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The z component of the cross product.
pub fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// A quarter turn counter-clockwise: the velocity of the point `a` at unit angular rate.
pub fn perp(a: Vector) -> Vector {
    [-a[1], a[0]]
}

/// From axes turned by `angle` to inertial axes.
pub fn rotate(angle: f64, a: Vector) -> Vector {
    let (s, c) = angle.sin_cos();
    [c * a[0] - s * a[1], s * a[0] + c * a[1]]
}

/// A rigid body; points in its own frame, whose origin is I.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub mass: f64,
    /// About the mass centre. May be zero (a point mass) if the joints rule the angle.
    pub inertia_c: f64,
    pub centre: Vector,
    pub outboard: Vector,
}

impl Body {
    /// A uniform slender rod from I to O.
    pub fn rod(mass: f64, length: f64) -> Self {
        let inertia_c = mass * length * length / 12.0;
        Self { mass, inertia_c, centre: [0.5 * length, 0.0], outboard: [length, 0.0] }
    }
}

/// The motion of a ground point (and of the frame that turns with it), as numbers at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ground {
    pub position: Vector,
    pub velocity: Vector,
    pub acceleration: Vector,
    pub angle: f64,
    pub rate: f64,
    pub angular_acceleration: f64,
}

impl Ground {
    /// At rest, with axes along x and y.
    pub fn at(position: Vector) -> Self {
        Self { position, ..Self::default() }
    }
}

/// Axes and moment balance of an elastic joint. Let `d` be the vector from the inboard to the outboard joint point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Axes turn with the inboard body, `d = R u`; the reaction acts at the same spatial point as the action.
    Inboard,
    /// Inertial axes, `u = d`; the reaction acts at the same spatial point as the action.
    Fixed,
    /// Inertial axes, `u = d`; the reaction acts at the inboard joint point, so that the moment `d x q` is missing.
    FixedUnbalanced,
}

/// Three-dof spring and damper; entries x, y, angle.
#[derive(Clone, Copy, Debug)]
pub struct Elastic {
    pub stiffness: [f64; 3],
    pub damping: [f64; 3],
    pub rest: [f64; 3],
    pub axes: Axes,
}

/// What joins an outboard frame (a body at its joint point) to an inboard one. At the tip the ground is the inboard
/// side (it carries the axes) and the last body, with its point O, the outboard one.
#[derive(Clone, Copy, Debug)]
pub enum Joint {
    /// Nothing.
    Free,
    /// The points coincide.
    Pin,
    /// A pin with a torsion spring and damper.
    Rotary { stiffness: f64, damping: f64, rest: f64 },
    /// The points coincide and the relative angle, whatever it is, stays.
    Weld,
    /// The outboard point moves along an axis of the inboard frame, with a spring, a damper and a rest value; the relative
    /// angle, whatever it is, stays.
    Slider { axis: Vector, spring: [f64; 3] },
    /// The outboard point moves along an axis of the inboard frame; the relative angle is free (a pin in a slot).
    Slot { axis: Vector },
    /// Springs and dampers, no constraint.
    Elastic(Elastic),
}

/// The end of the last body at its point O.
#[derive(Clone, Copy, Debug)]
pub enum Tip {
    Free,
    Held { joint: Joint, ground: Ground },
}

impl Tip {
    pub fn pinned(ground: Ground) -> Self {
        Self::Held { joint: Joint::Pin, ground }
    }

    pub fn clamped(ground: Ground) -> Self {
        Self::Held { joint: Joint::Weld, ground }
    }

    /// O moves along an axis of the ground frame, the angle stays.
    pub fn guided(ground: Ground, axis: Vector) -> Self {
        Self::Held { joint: Joint::Slider { axis, spring: [0.0; 3] }, ground }
    }

    /// O moves along an axis of the ground frame, the angle is free.
    pub fn rolling(ground: Ground, axis: Vector) -> Self {
        Self::Held { joint: Joint::Slot { axis }, ground }
    }
}

/// A force in inertial axes at a point in body coordinates, and a torque.
#[derive(Clone, Copy, Debug)]
pub struct Load {
    pub body: usize,
    pub point: Vector,
    pub force: Vector,
    pub torque: f64,
}

/// Everything but the state and the loads. `joints[0]` is the root joint, `joints[k]` is between bodies k - 1 and k.
#[derive(Clone, Debug)]
pub struct Scene {
    pub bodies: Vec<Body>,
    pub joints: Vec<Joint>,
    pub ground: Ground,
    pub tip: Tip,
    pub gravity: Vector,
}

/// Absolute state: position and velocity of I, angle and rate of every body.
#[derive(Clone, Debug, Default)]
pub struct State {
    pub position: Vec<Vector>,
    pub angle: Vec<f64>,
    pub velocity: Vec<Vector>,
    pub rate: Vec<f64>,
}

/// Joint coordinates: the outboard joint point relative to the inboard one, in the axes of the joint (the axes of the
/// inboard frame, or inertial ones for an elastic joint with fixed axes), the relative angle, and their rates.
#[derive(Clone, Copy, Debug, Default)]
pub struct Coordinates {
    pub u: Vector,
    pub phi: f64,
    pub u_rate: Vector,
    pub phi_rate: f64,
}

impl Coordinates {
    pub fn angle(phi: f64, phi_rate: f64) -> Self {
        Self { phi, phi_rate, ..Self::default() }
    }

    /// At `s` along `axis` (of any length) at a fixed relative angle.
    pub fn along(axis: Vector, s: f64, s_rate: f64, phi: f64) -> Self {
        let e = unit(axis);
        Self { u: scale(s, e), phi, u_rate: scale(s_rate, e), phi_rate: 0.0 }
    }
}

/// Accelerations and section loads.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Of the points I.
    pub acceleration: Vec<Vector>,
    /// Of the mass centres.
    pub acceleration_c: Vec<Vector>,
    pub angular_acceleration: Vec<f64>,
    pub q_inboard: Vec<Vector>,
    pub m_inboard: Vec<f64>,
    pub q_outboard: Vec<Vector>,
    pub m_outboard: Vec<f64>,
    /// The ground's face of the root joint, at the ground point: the ground gets the force `-q_ground` and the torque
    /// `+m_ground`.
    pub q_ground: Vector,
    pub m_ground: f64,
    /// What the ground at the tip does to the last body, at O.
    pub tip_force: Vector,
    pub tip_torque: f64,
    /// The torque the ground at the tip gets, at its own point.
    pub tip_ground_torque: f64,
    /// Lagrange multipliers in the order of the constraints.
    pub multipliers: Vec<f64>,
    /// Relative residual of the dense system.
    pub residual: f64,
}

/// A point that takes part in a joint, together with the frame it is fixed to.
#[derive(Clone, Copy)]
struct Frame {
    body: Option<usize>,
    arm: Vector, // from C to the point; nothing for the ground
    position: Vector,
    velocity: Vector,
    bias: Vector, // acceleration of the point for a body whose own accelerations are zero
    angle: f64,
    rate: f64,
    angular_bias: f64,
}

/// An inboard and an outboard frame.
#[derive(Clone, Copy)]
struct Link {
    joint: Joint,
    inboard: Frame,
    outboard: Frame,
}

/// A scalar constraint between two frames.
#[derive(Clone, Copy)]
enum Row {
    /// No relative motion along an inertial direction.
    Still { direction: Vector },
    /// No relative motion along a direction fixed to the inboard frame (here in inertial axes).
    Carried { direction: Vector },
    /// No relative rotation.
    Angle,
}

/// What a joint does apart from its constraints: force and torque on the outboard frame at its point, torque on the
/// inboard frame at its own point (the force on it is the opposite one).
#[derive(Clone, Copy, Default)]
struct Wrench {
    force: Vector,
    torque_outboard: f64,
    torque_inboard: f64,
}

fn unit(a: Vector) -> Vector {
    scale(1.0 / a[0].hypot(a[1]), a)
}

impl Frame {
    fn of_ground(g: &Ground) -> Self {
        Self {
            body: None,
            arm: [0.0; 2],
            position: g.position,
            velocity: g.velocity,
            bias: g.acceleration,
            angle: g.angle,
            rate: g.rate,
            angular_bias: g.angular_acceleration,
        }
    }

    fn of_body(scene: &Scene, state: &State, k: usize, point: Vector) -> Self {
        let (angle, rate) = (state.angle[k], state.rate[k]);
        let from_inboard = rotate(angle, point);
        let arm = rotate(angle, sub(point, scene.bodies[k].centre));
        Self {
            body: Some(k),
            arm,
            position: add(state.position[k], from_inboard),
            velocity: add(state.velocity[k], scale(rate, perp(from_inboard))),
            bias: scale(-rate * rate, arm),
            angle,
            rate,
            angular_bias: 0.0,
        }
    }
}

impl Link {
    fn distance(&self) -> Vector {
        sub(self.outboard.position, self.inboard.position)
    }

    fn distance_rate(&self) -> Vector {
        sub(self.outboard.velocity, self.inboard.velocity)
    }

    fn rows(&self) -> Vec<Row> {
        let pin = [Row::Still { direction: [1.0, 0.0] }, Row::Still { direction: [0.0, 1.0] }];
        let across = |axis| Row::Carried { direction: rotate(self.inboard.angle, perp(unit(axis))) };
        match self.joint {
            Joint::Free | Joint::Elastic(_) => vec![],
            Joint::Pin | Joint::Rotary { .. } => pin.to_vec(),
            Joint::Weld => vec![pin[0], pin[1], Row::Angle],
            Joint::Slider { axis, .. } => vec![across(axis), Row::Angle],
            Joint::Slot { axis } => vec![across(axis)],
        }
    }

    /// Factors of the accelerations (x, y of the mass centre, angle) of the inboard and of the outboard frame.
    fn factors(&self, row: Row) -> [[f64; 3]; 2] {
        match row {
            Row::Still { direction: n } => {
                let [p, o] = [&self.inboard, &self.outboard].map(|f| cross(f.arm, n));
                [[-n[0], -n[1], -p], [n[0], n[1], o]]
            }
            Row::Carried { direction: n } => {
                let [p, o] = [&self.inboard, &self.outboard].map(|f| cross(f.arm, n));
                // n turns with the inboard frame: n' = rate * perp(n).
                [[-n[0], -n[1], -p + dot(perp(n), self.distance())], [n[0], n[1], o]]
            }
            Row::Angle => [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]],
        }
    }

    /// The right hand side: minus all of the twice differentiated constraint that holds no unknown acceleration.
    fn right_hand_side(&self, row: Row) -> f64 {
        let (p, o) = (&self.inboard, &self.outboard);
        match row {
            Row::Still { direction: n } => -dot(n, sub(o.bias, p.bias)),
            Row::Carried { direction: n } => {
                let (d, w) = (self.distance(), p.rate);
                -dot(n, sub(o.bias, p.bias))
                    - p.angular_bias * dot(perp(n), d)
                    - 2.0 * w * dot(perp(n), self.distance_rate())
                    + w * w * dot(n, d)
            }
            Row::Angle => p.angular_bias - o.angular_bias,
        }
    }

    /// Errors of position and velocity. The angle a weld keeps is not recorded and so never wrong.
    fn violation(&self, row: Row) -> [f64; 2] {
        let (d, v) = (self.distance(), self.distance_rate());
        match row {
            Row::Still { direction: n } => [dot(n, d), dot(n, v)],
            Row::Carried { direction: n } => [dot(n, d), dot(n, v) + self.inboard.rate * dot(perp(n), d)],
            Row::Angle => [0.0, self.outboard.rate - self.inboard.rate],
        }
    }

    /// What the multiplier one does.
    fn unit_wrench(&self, row: Row) -> Wrench {
        match row {
            Row::Still { direction: n } => Wrench { force: n, ..Wrench::default() },
            Row::Carried { direction: n } => {
                Wrench { force: n, torque_outboard: 0.0, torque_inboard: -cross(self.distance(), n) }
            }
            Row::Angle => Wrench { force: [0.0; 2], torque_outboard: 1.0, torque_inboard: -1.0 },
        }
    }

    /// Joint coordinates in the axes of the joint.
    fn coordinates(&self) -> Coordinates {
        let (d, v) = (self.distance(), self.distance_rate());
        let (angle, rate) = self.axes();
        Coordinates {
            u: rotate(-angle, d),
            phi: self.outboard.angle - self.inboard.angle,
            u_rate: rotate(-angle, sub(v, scale(rate, perp(d)))),
            phi_rate: self.outboard.rate - self.inboard.rate,
        }
    }

    /// Angle and rate of the axes of the joint.
    fn axes(&self) -> (f64, f64) {
        if fixed_axes(&self.joint) { (0.0, 0.0) } else { (self.inboard.angle, self.inboard.rate) }
    }

    /// Springs, dampers and the applied torque.
    fn wrench(&self, torque: f64) -> Wrench {
        let c = self.coordinates();
        match self.joint {
            Joint::Rotary { stiffness, damping, rest } => {
                let t = torque - stiffness * (c.phi - rest) - damping * c.phi_rate;
                Wrench { force: [0.0; 2], torque_outboard: t, torque_inboard: -t }
            }
            Joint::Elastic(e) => {
                let [x, y] = [0, 1].map(|i| -e.stiffness[i] * (c.u[i] - e.rest[i]) - e.damping[i] * c.u_rate[i]);
                let force = rotate(self.axes().0, [x, y]);
                let t = torque - e.stiffness[2] * (c.phi - e.rest[2]) - e.damping[2] * c.phi_rate;
                let moment = if e.axes == Axes::FixedUnbalanced { 0.0 } else { cross(self.distance(), force) };
                Wrench { force, torque_outboard: t, torque_inboard: -t - moment }
            }
            Joint::Slider { axis, spring: [stiffness, damping, rest] } => {
                let e = unit(axis);
                let along = -stiffness * (dot(c.u, e) - rest) - damping * dot(c.u_rate, e);
                let force = rotate(self.axes().0, scale(along, e));
                Wrench { force, torque_outboard: torque, torque_inboard: -torque - cross(self.distance(), force) }
            }
            _ => Wrench { force: [0.0; 2], torque_outboard: torque, torque_inboard: -torque },
        }
    }

    /// Energy stored in the springs.
    fn potential(&self) -> f64 {
        let c = self.coordinates();
        match self.joint {
            Joint::Rotary { stiffness, rest, .. } => 0.5 * stiffness * (c.phi - rest).powi(2),
            Joint::Elastic(e) => {
                let stretch = [c.u[0] - e.rest[0], c.u[1] - e.rest[1], c.phi - e.rest[2]];
                (0..3).map(|i| 0.5 * e.stiffness[i] * stretch[i].powi(2)).sum()
            }
            Joint::Slider { axis, spring: [stiffness, _, rest] } => {
                0.5 * stiffness * (dot(c.u, unit(axis)) - rest).powi(2)
            }
            _ => 0.0,
        }
    }

    /// Power lost in the dampers, at least zero.
    fn dissipation(&self) -> f64 {
        let c = self.coordinates();
        match self.joint {
            Joint::Rotary { damping, .. } => damping * c.phi_rate.powi(2),
            Joint::Elastic(e) => {
                let rates = [c.u_rate[0], c.u_rate[1], c.phi_rate];
                (0..3).map(|i| e.damping[i] * rates[i].powi(2)).sum()
            }
            Joint::Slider { axis, spring: [_, damping, _] } => damping * dot(c.u_rate, unit(axis)).powi(2),
            _ => 0.0,
        }
    }
}

fn fixed_axes(joint: &Joint) -> bool {
    matches!(joint, Joint::Elastic(e) if e.axes != Axes::Inboard)
}

impl Scene {
    /// A chain of pins with a free tip, pinned to the ground at the origin, under gravity 9.81 along -y.
    pub fn pinned(bodies: Vec<Body>) -> Self {
        let joints = vec![Joint::Pin; bodies.len()];
        Self { bodies, joints, ground: Ground::default(), tip: Tip::Free, gravity: [0.0, -9.81] }
    }

    fn root_link(&self, state: &State) -> Link {
        let outboard = Frame::of_body(self, state, 0, [0.0; 2]);
        Link { joint: self.joints[0], inboard: Frame::of_ground(&self.ground), outboard }
    }

    /// Joint k between bodies k - 1 and k, or the root joint for k = 0.
    fn link(&self, state: &State, k: usize) -> Link {
        if k == 0 {
            return self.root_link(state);
        }
        Link {
            joint: self.joints[k],
            inboard: Frame::of_body(self, state, k - 1, self.bodies[k - 1].outboard),
            outboard: Frame::of_body(self, state, k, [0.0; 2]),
        }
    }

    fn tip_link(&self, state: &State) -> Option<Link> {
        let last = self.bodies.len() - 1;
        match self.tip {
            Tip::Free => None,
            Tip::Held { joint, ground } => Some(Link {
                joint,
                inboard: Frame::of_ground(&ground),
                outboard: Frame::of_body(self, state, last, self.bodies[last].outboard),
            }),
        }
    }

    /// All joints from the root; the tip last, if it is held.
    fn links(&self, state: &State) -> Vec<Link> {
        (0..self.bodies.len()).map(|k| self.link(state, k)).chain(self.tip_link(state)).collect()
    }

    /// Accelerations and section loads at a state that meets the constraints. `torques[k]` acts on the body outboard of
    /// joint k, and its opposite on the one inboard; an empty slice stands for zeros.
    ///
    /// Panics when the constraints are redundant or contradict each other; see [`Scene::solve_redundant`].
    pub fn solve(&self, state: &State, torques: &[f64], loads: &[Load]) -> Answer {
        self.solve_by(state, torques, loads, solve_refined)
    }

    /// As [`Scene::solve`], for constraints that may be redundant: the least squares solution of least norm, by
    /// singular values. The accelerations are unique if all bodies have mass and inertia; the reactions are one choice
    /// of many.
    pub fn solve_redundant(&self, state: &State, torques: &[f64], loads: &[Load]) -> Answer {
        self.solve_by(state, torques, loads, solve_singular)
    }

    fn solve_by(
        &self,
        state: &State,
        torques: &[f64],
        loads: &[Load],
        solver: fn(&DMatrix<f64>, &DVector<f64>) -> DVector<f64>,
    ) -> Answer {
        let n = self.bodies.len();
        assert!(self.joints.len() == n && state.position.len() == n && state.angle.len() == n);
        assert!(state.velocity.len() == n && state.rate.len() == n && (torques.is_empty() || torques.len() == n));
        let links = self.links(state);
        let wrenches: Vec<Wrench> =
            links.iter().enumerate().map(|(k, l)| l.wrench(torques.get(k).copied().unwrap_or(0.0))).collect();
        let rows: Vec<(usize, Row)> =
            links.iter().enumerate().flat_map(|(k, l)| l.rows().into_iter().map(move |r| (k, r))).collect();

        let size = 3 * n + rows.len();
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        for (k, body) in self.bodies.iter().enumerate() {
            for i in 0..2 {
                matrix[(3 * k + i, 3 * k + i)] = body.mass;
                right[3 * k + i] = body.mass * self.gravity[i];
            }
            matrix[(3 * k + 2, 3 * k + 2)] = body.inertia_c;
        }
        for load in loads {
            let arm = rotate(state.angle[load.body], sub(load.point, self.bodies[load.body].centre));
            push(&mut right, load.body, arm, load.force, load.torque);
        }
        for (link, w) in links.iter().zip(&wrenches) {
            if let Some(k) = link.outboard.body {
                push(&mut right, k, link.outboard.arm, w.force, w.torque_outboard);
            }
            if let Some(k) = link.inboard.body {
                push(&mut right, k, link.inboard.arm, scale(-1.0, w.force), w.torque_inboard);
            }
        }
        for (i, &(link, row)) in rows.iter().enumerate() {
            let link = &links[link];
            let factors = link.factors(row);
            for (frame, factors) in [&link.inboard, &link.outboard].into_iter().zip(factors) {
                if let Some(k) = frame.body {
                    for (j, factor) in factors.into_iter().enumerate() {
                        matrix[(3 * n + i, 3 * k + j)] += factor;
                        matrix[(3 * k + j, 3 * n + i)] += factor;
                    }
                }
            }
            right[3 * n + i] = link.right_hand_side(row);
        }

        let unknowns = solver(&matrix, &right);
        let multipliers: Vec<f64> = unknowns.rows(3 * n, rows.len()).iter().map(|l| -l).collect();
        let mut totals = wrenches;
        for (&(k, row), &l) in rows.iter().zip(&multipliers) {
            let w = links[k].unit_wrench(row);
            totals[k].force = add(totals[k].force, scale(l, w.force));
            totals[k].torque_outboard += l * w.torque_outboard;
            totals[k].torque_inboard += l * w.torque_inboard;
        }

        let acceleration_c: Vec<Vector> = (0..n).map(|k| [unknowns[3 * k], unknowns[3 * k + 1]]).collect();
        let angular_acceleration: Vec<f64> = (0..n).map(|k| unknowns[3 * k + 2]).collect();
        let acceleration = (0..n)
            .map(|k| {
                let to_inboard = rotate(state.angle[k], scale(-1.0, self.bodies[k].centre));
                let turning = scale(angular_acceleration[k], perp(to_inboard));
                add(acceleration_c[k], sub(turning, scale(state.rate[k].powi(2), to_inboard)))
            })
            .collect();
        let tip = totals.get(n).copied().unwrap_or_default();
        Answer {
            acceleration,
            acceleration_c,
            angular_acceleration,
            q_inboard: totals[..n].iter().map(|w| w.force).collect(),
            m_inboard: totals[..n].iter().map(|w| -w.torque_outboard).collect(),
            q_outboard: totals[1..n].iter().map(|w| w.force).chain([scale(-1.0, tip.force)]).collect(),
            m_outboard: totals[1..n].iter().map(|w| w.torque_inboard).chain([tip.torque_outboard]).collect(),
            q_ground: totals[0].force,
            m_ground: totals[0].torque_inboard,
            tip_force: tip.force,
            tip_torque: tip.torque_outboard,
            tip_ground_torque: tip.torque_inboard,
            multipliers,
            residual: residual(&matrix, &unknowns, &right).amax() / right.amax().max(f64::MIN_POSITIVE),
        }
    }

    /// The consistent state of a chain of pins from absolute angles and rates; the root pin is at the ground point.
    pub fn assemble(&self, angles: &[f64], rates: &[f64]) -> State {
        let mut state = State { angle: angles.to_vec(), rate: rates.to_vec(), ..State::default() };
        let (mut position, mut velocity) = (self.ground.position, self.ground.velocity);
        for (k, body) in self.bodies.iter().enumerate() {
            state.position.push(position);
            state.velocity.push(velocity);
            let arm = rotate(angles[k], body.outboard);
            position = add(position, arm);
            velocity = add(velocity, scale(rates[k], perp(arm)));
        }
        state
    }

    /// The state with the given joint coordinates, root joint first.
    pub fn place(&self, coordinates: &[Coordinates]) -> State {
        assert_eq!(coordinates.len(), self.bodies.len());
        let mut state = State::default();
        let mut inboard = Frame::of_ground(&self.ground);
        for (k, c) in coordinates.iter().enumerate() {
            let (angle, rate) = if fixed_axes(&self.joints[k]) { (0.0, 0.0) } else { (inboard.angle, inboard.rate) };
            let d = rotate(angle, c.u);
            let v = add(rotate(angle, c.u_rate), scale(rate, perp(d)));
            state.position.push(add(inboard.position, d));
            state.velocity.push(add(inboard.velocity, v));
            state.angle.push(inboard.angle + c.phi);
            state.rate.push(inboard.rate + c.phi_rate);
            inboard = Frame::of_body(self, &state, k, self.bodies[k].outboard);
        }
        state
    }

    /// The joint coordinates of a state, root joint first.
    pub fn coordinates(&self, state: &State) -> Vec<Coordinates> {
        (0..self.bodies.len()).map(|k| self.link(state, k).coordinates()).collect()
    }

    /// Second derivatives of the joint coordinates, root joint first.
    pub fn coordinate_accelerations(&self, state: &State, answer: &Answer) -> Vec<(Vector, f64)> {
        let of = |f: &Frame| match f.body {
            None => (f.bias, f.angular_bias),
            Some(k) => {
                let alpha = answer.angular_acceleration[k];
                (add(answer.acceleration_c[k], add(f.bias, scale(alpha, perp(f.arm)))), alpha)
            }
        };
        let second = |k: usize| {
            let link = self.link(state, k);
            let ((a_in, alpha_in), (a_out, alpha_out)) = (of(&link.inboard), of(&link.outboard));
            let (angle, rate) = link.axes();
            let alpha = if fixed_axes(&link.joint) { 0.0 } else { alpha_in };
            let (d, v) = (link.distance(), link.distance_rate());
            // d = R u; v = R u' + w perp(d); a = R u'' + 2 w perp(R u') + alpha perp(d) - w^2 d, R u' = v - w perp(d).
            let relative = sub(v, scale(rate, perp(d)));
            let a = sub(sub(a_out, a_in), scale(2.0 * rate, perp(relative)));
            let a = add(sub(a, scale(alpha, perp(d))), scale(rate * rate, d));
            (rotate(-angle, a), alpha_out - alpha_in)
        };
        (0..self.bodies.len()).map(second).collect()
    }

    /// The largest errors of position and of velocity over all constraints.
    pub fn violation(&self, state: &State) -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        for link in self.links(state) {
            for row in link.rows() {
                let error = link.violation(row);
                worst = [worst[0].max(error[0].abs()), worst[1].max(error[1].abs())];
            }
        }
        worst
    }

    /// The nearest state that meets the constraints (Newton steps of least norm in the coordinates of the mass
    /// centres), for loops that are closed by the tip. The relative angles of welds and sliders stay.
    pub fn project(&self, state: &State) -> State {
        let mut state = state.clone();
        for round in 0..60 {
            if self.violation(&state)[0] < 1e-15 && round > 0 {
                break;
            }
            self.shift(&mut state, 0);
        }
        for _ in 0..2 {
            self.shift(&mut state, 1);
        }
        state
    }

    /// One step of the projection of the positions (`level` 0) or the velocities (`level` 1).
    fn shift(&self, state: &mut State, level: usize) {
        let n = self.bodies.len();
        let links = self.links(state);
        let rows: Vec<(&Link, Row)> = links.iter().flat_map(|l| l.rows().into_iter().map(move |r| (l, r))).collect();
        if rows.is_empty() {
            return;
        }
        let mut jacobian = DMatrix::zeros(rows.len(), 3 * n);
        let mut error = DVector::zeros(rows.len());
        for (i, (link, row)) in rows.iter().enumerate() {
            for (frame, factors) in [&link.inboard, &link.outboard].into_iter().zip(link.factors(*row)) {
                for (j, factor) in factors.into_iter().enumerate() {
                    if let Some(k) = frame.body {
                        jacobian[(i, 3 * k + j)] += factor;
                    }
                }
            }
            error[i] = link.violation(*row)[level];
        }
        let step = solve_singular(&jacobian, &error);
        for (k, body) in self.bodies.iter().enumerate() {
            let (shift, turn) = ([step[3 * k], step[3 * k + 1]], step[3 * k + 2]);
            let arm = rotate(state.angle[k], body.centre);
            if level == 0 {
                let centre = sub(add(state.position[k], arm), shift);
                state.angle[k] -= turn;
                state.position[k] = sub(centre, rotate(state.angle[k], body.centre));
            } else {
                state.rate[k] -= turn;
                state.velocity[k] = add(sub(state.velocity[k], shift), scale(turn, perp(arm)));
            }
        }
    }

    /// Position and velocity of a mass centre.
    pub fn centre(&self, state: &State, k: usize) -> (Vector, Vector) {
        let frame = Frame::of_body(self, state, k, self.bodies[k].centre);
        (frame.position, frame.velocity)
    }

    /// Position and velocity of the point O of the last body.
    pub fn tip_point(&self, state: &State) -> (Vector, Vector) {
        let last = self.bodies.len() - 1;
        let frame = Frame::of_body(self, state, last, self.bodies[last].outboard);
        (frame.position, frame.velocity)
    }

    pub fn kinetic_energy(&self, state: &State) -> f64 {
        let of = |(k, body): (usize, &Body)| {
            let (_, v) = self.centre(state, k);
            0.5 * body.mass * dot(v, v) + 0.5 * body.inertia_c * state.rate[k].powi(2)
        };
        self.bodies.iter().enumerate().map(of).sum()
    }

    /// Of gravity (zero at the origin) and of all springs.
    pub fn potential_energy(&self, state: &State) -> f64 {
        let weight = |(k, body): (usize, &Body)| -body.mass * dot(self.gravity, self.centre(state, k).0);
        let gravity: f64 = self.bodies.iter().enumerate().map(weight).sum();
        gravity + self.links(state).iter().map(Link::potential).sum::<f64>()
    }

    /// Kinetic and potential energy.
    pub fn energy(&self, state: &State) -> f64 {
        self.kinetic_energy(state) + self.potential_energy(state)
    }

    /// The power lost in all dampers.
    pub fn dissipation(&self, state: &State) -> f64 {
        self.links(state).iter().map(Link::dissipation).sum()
    }

    /// The power of applied loads and joint torques. What moving ground adds is [`Scene::ground_power`].
    pub fn power(&self, state: &State, torques: &[f64], loads: &[Load]) -> f64 {
        let of_load = |load: &Load| {
            let velocity = Frame::of_body(self, state, load.body, load.point).velocity;
            dot(load.force, velocity) + load.torque * state.rate[load.body]
        };
        let of_torque = |(k, torque): (usize, &f64)| torque * self.link(state, k).coordinates().phi_rate;
        loads.iter().map(of_load).sum::<f64>() + torques.iter().enumerate().map(of_torque).sum::<f64>()
    }

    /// The power that the moving ground puts into the chain through the root and the tip.
    pub fn ground_power(&self, answer: &Answer) -> f64 {
        let root = dot(answer.q_ground, self.ground.velocity) - answer.m_ground * self.ground.rate;
        let tip = match self.tip {
            Tip::Free => 0.0,
            Tip::Held { ground, .. } => dot(answer.tip_force, ground.velocity) - answer.tip_ground_torque * ground.rate,
        };
        root + tip
    }

    /// The power that elastic joints with fixed axes and a balanced moment bring in from nowhere: their spring stretch
    /// does not see the rotation of the inboard body, while the moment `d x q` on it does work.
    pub fn axes_power(&self, state: &State) -> f64 {
        let of = |link: &Link| match link.joint {
            Joint::Elastic(Elastic { axes: Axes::Fixed, .. }) => {
                -link.inboard.rate * cross(link.distance(), link.wrench(0.0).force)
            }
            _ => 0.0,
        };
        self.links(state).iter().map(of).sum()
    }

    pub fn linear_momentum(&self, state: &State) -> Vector {
        let of = |(k, body): (usize, &Body)| scale(body.mass, self.centre(state, k).1);
        self.bodies.iter().enumerate().map(of).fold([0.0; 2], add)
    }

    /// About the origin.
    pub fn angular_momentum(&self, state: &State) -> f64 {
        let of = |(k, body): (usize, &Body)| {
            let (r, v) = self.centre(state, k);
            body.mass * cross(r, v) + body.inertia_c * state.rate[k]
        };
        self.bodies.iter().enumerate().map(of).sum()
    }

    /// Rate of the linear momentum from the accelerations.
    pub fn linear_momentum_rate(&self, answer: &Answer) -> Vector {
        self.bodies.iter().zip(&answer.acceleration_c).map(|(b, &a)| scale(b.mass, a)).fold([0.0; 2], add)
    }

    /// Rate of the angular momentum about the origin from the accelerations.
    pub fn angular_momentum_rate(&self, state: &State, answer: &Answer) -> f64 {
        let of = |(k, body): (usize, &Body)| {
            let moment = cross(self.centre(state, k).0, answer.acceleration_c[k]);
            body.mass * moment + body.inertia_c * answer.angular_acceleration[k]
        };
        self.bodies.iter().enumerate().map(of).sum()
    }

    /// The rate of [`Scene::energy`] from the accelerations; ground motion counts where springs are tied to it.
    pub fn energy_rate(&self, state: &State, answer: &Answer) -> f64 {
        let of = |(k, body): (usize, &Body)| {
            let v = self.centre(state, k).1;
            let force = scale(body.mass, sub(answer.acceleration_c[k], self.gravity));
            dot(force, v) + body.inertia_c * answer.angular_acceleration[k] * state.rate[k]
        };
        let springs = self.links(state).into_iter().map(|link| {
            let c = link.coordinates();
            match link.joint {
                Joint::Rotary { stiffness, rest, .. } => stiffness * (c.phi - rest) * c.phi_rate,
                Joint::Elastic(e) => {
                    let stretch = [c.u[0] - e.rest[0], c.u[1] - e.rest[1], c.phi - e.rest[2]];
                    let rates = [c.u_rate[0], c.u_rate[1], c.phi_rate];
                    (0..3).map(|i| e.stiffness[i] * stretch[i] * rates[i]).sum()
                }
                Joint::Slider { axis, spring: [stiffness, _, rest] } => {
                    let e = unit(axis);
                    stiffness * (dot(c.u, e) - rest) * dot(c.u_rate, e)
                }
                _ => 0.0,
            }
        });
        self.bodies.iter().enumerate().map(of).sum::<f64>() + springs.sum::<f64>()
    }

    /// The largest defect of Newton's and Euler's laws of any single body with the section loads of `answer`.
    pub fn balance_defect(&self, state: &State, loads: &[Load], answer: &Answer) -> f64 {
        let mut worst = 0.0_f64;
        for (k, body) in self.bodies.iter().enumerate() {
            let (q_i, q_o) = (answer.q_inboard[k], answer.q_outboard[k]);
            let arm = |point| rotate(state.angle[k], sub(point, body.centre));
            let mut force = sub(add(scale(body.mass, self.gravity), q_i), q_o);
            let mut moment = answer.m_outboard[k] - answer.m_inboard[k] + cross(arm([0.0; 2]), q_i);
            moment -= cross(arm(body.outboard), q_o);
            for load in loads.iter().filter(|load| load.body == k) {
                force = add(force, load.force);
                moment += load.torque + cross(arm(load.point), load.force);
            }
            let defect = sub(force, scale(body.mass, answer.acceleration_c[k]));
            let turning = moment - body.inertia_c * answer.angular_acceleration[k];
            worst = worst.max(defect[0].abs()).max(defect[1].abs()).max(turning.abs());
        }
        worst
    }

    /// The motion of a chain of pins (and rotary joints) without loads over `duration`, in the absolute angles as
    /// minimal coordinates: angles and rates at the end.
    pub fn integrate(&self, angles: &[f64], rates: &[f64], duration: f64, tolerance: f64) -> (Vec<f64>, Vec<f64>) {
        assert!(self.joints.iter().all(|j| matches!(j, Joint::Pin | Joint::Rotary { .. })));
        let n = angles.len();
        let slope = |_: f64, y: &[f64]| {
            let state = self.assemble(&y[..n], &y[n..]);
            let answer = self.solve(&state, &[], &[]);
            [&y[n..], &answer.angular_acceleration].concat()
        };
        let end = extrapolate(slope, 0.0, duration, &[angles, rates].concat(), tolerance);
        (end[..n].to_vec(), end[n..].to_vec())
    }

    /// The motion of any chain from the joint coordinates at time zero over `duration`, with the free joint coordinates
    /// as the variables: `prepare(t, scene)` sets what of the scene depends on time (ground motion), and
    /// `inputs(t, state)` gives the joint torques and loads. A tip that is held is kept by the accelerations alone.
    pub fn integrate_driven(
        &self,
        start: &[Coordinates],
        duration: f64,
        tolerance: f64,
        mut prepare: impl FnMut(f64, &mut Scene),
        mut inputs: impl FnMut(f64, &State) -> (Vec<f64>, Vec<Load>),
    ) -> Vec<Coordinates> {
        let mut scene = self.clone();
        let variables = self.pack(start);
        let slope = |t: f64, y: &[f64]| {
            prepare(t, &mut scene);
            let half = y.len() / 2;
            let state = scene.place(&scene.unpack(start, y));
            let (torques, loads) = inputs(t, &state);
            let answer = scene.solve(&state, &torques, &loads);
            let second = scene.coordinate_accelerations(&state, &answer);
            let second: Vec<Coordinates> =
                second.into_iter().map(|(u_rate, phi_rate)| Coordinates { u_rate, phi_rate, ..start[0] }).collect();
            [&y[half..], &scene.pack(&second)[half..]].concat()
        };
        let end = extrapolate(slope, 0.0, duration, &variables, tolerance);
        self.unpack(start, &end)
    }

    /// The free joint coordinates, then their rates.
    fn pack(&self, coordinates: &[Coordinates]) -> Vec<f64> {
        let (mut values, mut rates) = (Vec::new(), Vec::new());
        for (joint, c) in self.joints.iter().zip(coordinates) {
            match joint {
                Joint::Free | Joint::Elastic(_) => {
                    values.extend([c.u[0], c.u[1], c.phi]);
                    rates.extend([c.u_rate[0], c.u_rate[1], c.phi_rate]);
                }
                Joint::Pin | Joint::Rotary { .. } => {
                    values.push(c.phi);
                    rates.push(c.phi_rate);
                }
                Joint::Weld => {}
                Joint::Slider { axis, .. } => {
                    values.push(dot(unit(*axis), c.u));
                    rates.push(dot(unit(*axis), c.u_rate));
                }
                Joint::Slot { axis } => {
                    values.extend([dot(unit(*axis), c.u), c.phi]);
                    rates.extend([dot(unit(*axis), c.u_rate), c.phi_rate]);
                }
            }
        }
        [values, rates].concat()
    }

    /// The inverse of [`Scene::pack`]; what a joint keeps is taken from `start`.
    fn unpack(&self, start: &[Coordinates], packed: &[f64]) -> Vec<Coordinates> {
        let (values, rates) = packed.split_at(packed.len() / 2);
        let mut next = values.iter().copied().zip(rates.iter().copied());
        let mut take = || next.next().expect("one variable per free coordinate");
        let one = |(joint, start): (&Joint, &Coordinates)| match joint {
            Joint::Free | Joint::Elastic(_) => {
                let [x, y, phi] = [take(), take(), take()];
                Coordinates { u: [x.0, y.0], phi: phi.0, u_rate: [x.1, y.1], phi_rate: phi.1 }
            }
            Joint::Pin | Joint::Rotary { .. } => {
                let (phi, phi_rate) = take();
                Coordinates::angle(phi, phi_rate)
            }
            Joint::Weld => Coordinates::angle(start.phi, 0.0),
            Joint::Slider { axis, .. } => {
                let (s, s_rate) = take();
                Coordinates::along(*axis, s, s_rate, start.phi)
            }
            Joint::Slot { axis } => {
                let [(s, s_rate), (phi, phi_rate)] = [take(), take()];
                Coordinates { phi_rate, ..Coordinates::along(*axis, s, s_rate, phi) }
            }
        };
        self.joints.iter().zip(start).map(one).collect()
    }
}

/// Adds a force with an arm from the mass centre, and a torque, to the right hand side.
fn push(right: &mut DVector<f64>, k: usize, arm: Vector, force: Vector, torque: f64) {
    right[3 * k] += force[0];
    right[3 * k + 1] += force[1];
    right[3 * k + 2] += torque + cross(arm, force);
}

/// LU with partial pivoting of the equilibrated matrix and one step of iterative refinement.
fn solve_refined(matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let size = right.len();
    // Symmetric scaling by powers of two, which round nothing, brings the largest entry of each row near one.
    let mut scaling = DVector::from_element(size, 1.0);
    for _ in 0..3 {
        for i in 0..size {
            let largest = (0..size).map(|j| (scaling[i] * matrix[(i, j)] * scaling[j]).abs()).fold(0.0, f64::max);
            if largest > 0.0 {
                scaling[i] *= (-0.5 * largest.log2()).round().exp2();
            }
        }
    }
    let scaled = DMatrix::from_fn(size, size, |i, j| scaling[i] * matrix[(i, j)] * scaling[j]);
    let lu = scaled.lu();
    let pivots = lu.u().diagonal().abs();
    // A redundant row leaves a pivot of the size of rounding errors; sound chains stay far above.
    assert!(
        pivots.min() > 1e-13 * pivots.max(),
        "singular system: the constraints are redundant or leave a massless dof"
    );
    let step = |r: &DVector<f64>| lu.solve(&r.component_mul(&scaling)).expect("regular").component_mul(&scaling);
    let first = step(right);
    let correction = step(&residual(matrix, &first, right));
    first + correction
}

/// Least squares of least norm, by singular values.
fn solve_singular(matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let svd = matrix.clone().svd(true, true);
    let cut = 1e-12 * svd.singular_values.max(); // rounding errors of null singular values are of the order 1e-16
    let first = svd.solve(right, cut).expect("both factors are there");
    let correction = svd.solve(&residual(matrix, &first, right), cut).expect("both factors are there");
    first + correction
}

/// `right - matrix * x` as if in twice the working precision (error-free products and sums), rounded at the end.
fn residual(matrix: &DMatrix<f64>, x: &DVector<f64>, right: &DVector<f64>) -> DVector<f64> {
    DVector::from_fn(right.len(), |i, _| {
        let (mut high, mut low) = (right[i], 0.0);
        for j in 0..x.len() {
            let product = -matrix[(i, j)] * x[j];
            let product_low = (-matrix[(i, j)]).mul_add(x[j], -product);
            let sum = high + product;
            let part = sum - high;
            low += (high - (sum - part)) + (product - part) + product_low;
            high = sum;
        }
        high + low
    })
}
