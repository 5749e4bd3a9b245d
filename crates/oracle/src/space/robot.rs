//! A slow, plain second opinion on robots: trees of bodies on hinges and slides, fixed or floating. Mass matrix and generalised forces
//! from Jacobians of mass centres in inertial axes, M = Σ m Jᵀ J + Jωᵀ I Jω, and the accelerations that rates alone cause.

use super::{Matrix, Vector, about, tilde};
use nalgebra::{DMatrix, DVector, Matrix3xX};

/// A body with the joint that carries it, about or along its z axis.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The body inboard; the base or the ground where there is none.
    pub parent: Option<usize>,
    pub slides: bool,
    /// Where the joint sits on the parent, and how the body is turned there while the coordinate is zero: its axes as columns.
    pub place: Vector,
    pub turn: Matrix,
    pub mass: f64,
    pub centre: Vector,
    /// About the mass centre.
    pub tensor: Matrix,
    pub armature: f64,
    pub damping: f64,
}

/// Mass, mass centre and tensor about it of a floating base.
#[derive(Clone, Copy, Debug)]
pub struct Base {
    pub mass: f64,
    pub centre: Vector,
    pub tensor: Matrix,
    pub place: Vector,
    pub attitude: Matrix,
    /// Inertial axes.
    pub velocity: Vector,
    /// Axes of the base.
    pub spin: Vector,
}

/// A robot.
#[derive(Clone, Debug)]
pub struct Robot {
    pub base: Option<Base>,
    pub parts: Vec<Part>,
    pub gravity: Vector,
}

/// A body's motion, with Jacobians of its origin and of its turning (inertial axes); accelerations with those of coordinates zero.
#[derive(Clone, Debug)]
pub struct Moving {
    pub place: Vector,
    pub attitude: Matrix,
    pub velocity: Vector,
    pub spin: Vector,
    pub linear: Vector,
    pub angular: Vector,
    pub of_place: Matrix3xX<f64>,
    pub of_turn: Matrix3xX<f64>,
}

/// What a robot is at an instant.
#[derive(Clone, Debug)]
pub struct Instant {
    /// The base, if it floats, and all bodies.
    pub base: Option<Moving>,
    pub bodies: Vec<Moving>,
    pub mass: DMatrix<f64>,
    /// Forces that it takes to keep coordinates from accelerating: with gravity, without damping.
    pub bias: DVector<f64>,
    /// Energy of motion, armatures included, and of place in gravity.
    pub kinetic: f64,
    pub potential: f64,
    pub centre: Vector,
    pub of_centre: Matrix3xX<f64>,
}

impl Moving {
    /// At rest at the origin.
    fn ground(n: usize) -> Self {
        let (o, none) = (Vector::zeros(), Matrix3xX::zeros(n));
        let (of_place, of_turn) = (none.clone(), none);
        Self { place: o, attitude: Matrix::identity(), velocity: o, spin: o, linear: o, angular: o, of_place, of_turn }
    }

    /// At another point of the body, by the vector to it (inertial axes).
    pub fn at(&self, arm: Vector) -> Self {
        Self {
            place: self.place + arm,
            velocity: self.velocity + self.spin.cross(&arm),
            linear: self.linear + self.angular.cross(&arm) + self.spin.cross(&self.spin.cross(&arm)),
            of_place: &self.of_place - tilde(arm) * &self.of_turn,
            ..self.clone()
        }
    }
}

impl Instant {
    /// Accelerations under forces while some directions are held, those of the rows of a Jacobian, which accelerate as demanded; and what holds
    /// each of them: M q̈ + b = f + Jᵀ λ, J q̈ = d.
    pub fn held(&self, forces: &[f64], jacobian: &DMatrix<f64>, demand: &DVector<f64>) -> [DVector<f64>; 2] {
        let (n, m) = (forces.len(), demand.len());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        matrix.view_mut((0, 0), (n, n)).copy_from(&self.mass);
        matrix.view_mut((n, 0), (m, n)).copy_from(jacobian);
        matrix.view_mut((0, n), (n, m)).copy_from(&(-jacobian.transpose()));
        let right = DVector::from_fn(n + m, |k, _| if k < n { forces[k] - self.bias[k] } else { demand[k - n] });
        let found = matrix.lu().solve(&right).expect("what is held is independent");
        [found.rows(0, n).into_owned(), found.rows(n, m).into_owned()]
    }
}

impl Robot {
    /// Coordinates of the base: six or none.
    pub fn offset(&self) -> usize {
        if self.base.is_some() { 6 } else { 0 }
    }

    /// At coordinates and rates of the joints.
    pub fn at(&self, q: &[f64], v: &[f64]) -> Instant {
        let n = self.offset() + self.parts.len();
        let mut root = Moving::ground(n);
        if let Some(base) = self.base {
            (root.place, root.attitude, root.velocity) = (base.place, base.attitude, base.velocity);
            root.spin = base.attitude * base.spin;
            for k in 0..3 {
                root.of_place[(k, k)] = 1.0;
                root.of_turn.set_column(3 + k, &base.attitude.column(k));
            }
        }
        let mut bodies: Vec<Moving> = vec![];
        for (k, part) in self.parts.iter().enumerate() {
            let parent = part.parent.map_or(&root, |parent| &bodies[parent]);
            let axis = parent.attitude * part.turn * Vector::z();
            let arm = parent.attitude * part.place + if part.slides { axis * q[k] } else { Vector::zeros() };
            let mut body = parent.at(arm);
            let (spin, column) = (parent.spin, self.offset() + k);
            if part.slides {
                body.attitude = parent.attitude * part.turn;
                body.velocity += axis * v[k];
                body.linear += spin.cross(&axis) * (2.0 * v[k]);
                body.of_place.set_column(column, &axis);
            } else {
                body.attitude = parent.attitude * part.turn * about(Vector::z(), q[k]);
                body.spin += axis * v[k];
                body.angular += spin.cross(&axis) * v[k];
                body.of_turn.set_column(column, &axis);
            }
            bodies.push(body);
        }
        let mut now = Instant {
            base: self.base.map(|_| root.clone()),
            mass: DMatrix::zeros(n, n),
            bias: DVector::zeros(n),
            kinetic: 0.0,
            potential: 0.0,
            centre: Vector::zeros(),
            of_centre: Matrix3xX::zeros(n),
            bodies,
        };
        let parts = self.parts.iter().zip(&now.bodies).map(|(p, b)| (b, p.mass, p.centre, p.tensor));
        let base = self.base.map(|base| (&root, base.mass, base.centre, base.tensor));
        let mut total = 0.0;
        for (body, mass, centre, tensor) in base.into_iter().chain(parts) {
            let centre = body.at(body.attitude * centre);
            let tensor = body.attitude * tensor * body.attitude.transpose();
            let (of_place, of_turn) = (&centre.of_place, &body.of_turn);
            now.mass += of_place.transpose() * of_place * mass + of_turn.transpose() * (tensor * of_turn);
            let torque = tensor * body.angular + body.spin.cross(&(tensor * body.spin));
            now.bias += of_place.transpose() * ((centre.linear - self.gravity) * mass) + of_turn.transpose() * torque;
            now.kinetic += 0.5 * (mass * centre.velocity.norm_squared() + body.spin.dot(&(tensor * body.spin)));
            now.potential -= mass * self.gravity.dot(&centre.place);
            now.centre += centre.place * mass;
            now.of_centre += of_place * mass;
            total += mass;
        }
        now.centre /= total;
        now.of_centre /= total;
        for (k, part) in self.parts.iter().enumerate() {
            now.mass[(self.offset() + k, self.offset() + k)] += part.armature;
            now.kinetic += 0.5 * part.armature * v[k] * v[k];
        }
        now
    }

    /// Mass (kg), momentum (kg·m/s) and angular momentum about the mass centre (kg·m²/s) at an instant of this robot, summed over its bodies.
    pub fn momenta(&self, now: &Instant) -> (f64, Vector, Vector) {
        let parts = self.parts.iter().zip(&now.bodies).map(|(p, b)| (b, p.mass, p.centre, p.tensor));
        let base = self.base.zip(now.base.as_ref()).map(|(p, b)| (b, p.mass, p.centre, p.tensor));
        let (mut sum, mut momentum, mut angular) = (0.0, Vector::zeros(), Vector::zeros());
        for (body, mass, local, tensor) in base.into_iter().chain(parts) {
            let (arm, tensor) = (body.attitude * local, body.attitude * tensor * body.attitude.transpose());
            let velocity = body.velocity + body.spin.cross(&arm);
            sum += mass;
            momentum += velocity * mass;
            angular += (body.place + arm - now.centre).cross(&velocity) * mass + tensor * body.spin;
        }
        (sum, momentum, angular)
    }

    /// Accelerations of the coordinates under forces, of which those of dampers are part only of this.
    pub fn forward_dynamics(&self, q: &[f64], v: &[f64], forces: &[f64]) -> DVector<f64> {
        let now = self.at(q, v);
        let mut sum = DVector::from_column_slice(forces) - now.bias;
        for (k, part) in self.parts.iter().enumerate() {
            sum[self.offset() + k] -= part.damping * v[k];
        }
        now.mass.lu().solve(&sum).expect("masses are positive")
    }
}
