//! The law of an elastic hinge, written once more: from the matrix of left tangents of rotations, inverted as a matrix.

use super::{Joint, Matrix, Vector, about, tilde};

/// Stiffness, damping and rest value of all six coordinates, along and about axes of the inboard body.
#[derive(Clone, Copy, Debug, Default)]
pub struct Law {
    pub rotary: [f64; 3],
    pub damping: [f64; 3],
    pub rest: [f64; 3],
    /// Stiffness, damping, rest value along each axis.
    pub linear: [[f64; 3]; 3],
    /// Its points coincide.
    pub together: bool,
}

/// J with dR = (J dφ)~ R: 1 + (1 − cos φ)/φ² φ~ + (φ − sin φ)/φ³ φ~².
fn left_tangent(phi: Vector) -> Matrix {
    let (angle, t) = (phi.norm(), tilde(phi));
    Matrix::identity() + t * ((1.0 - angle.cos()) / angle.powi(2)) + t * t * ((angle - angle.sin()) / angle.powi(3))
}

/// The rotation vector of a rotation by less than half a turn.
pub fn logarithm(r: Matrix) -> Vector {
    let twice = Vector::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]);
    let (sine, cosine) = (0.5 * twice.norm(), 0.5 * (r.trace() - 1.0));
    if sine < 1e-7 { twice * 0.5 } else { twice * (0.5 * sine.atan2(cosine) / sine) }
}

impl Law {
    /// A hinge at a displacement and a rotation vector (axes of the inboard body), with rates and an effort (axes of the outboard body).
    pub fn joint(&self, place: Vector, rate: Vector, phi: Vector, spin: Vector, effort: Vector) -> Joint {
        let attitude = about(phi, phi.norm());
        let of = |values: [f64; 3]| Vector::from(values);
        // −∂V/∂ψ for turns ψ of the outboard body: dφ = J⁻¹ ψ.
        let strain = of(self.rotary).component_mul(&(phi - of(self.rest)));
        let couple = left_tangent(phi).transpose().try_inverse().unwrap() * strain;
        let torque = attitude * effort - couple - of(self.damping).component_mul(&(attitude * spin));
        let force = Vector::from_fn(|i, _| {
            let [k, c, rest] = self.linear[i];
            -k * (place[i] - rest) - c * rate[i]
        });
        Joint::Elastic { place, rate, attitude, spin, force, torque, together: self.together }
    }

    /// Energy stored.
    pub fn energy(&self, place: Vector, phi: Vector) -> f64 {
        let rotary: f64 = (0..3).map(|i| self.rotary[i] * (phi[i] - self.rest[i]).powi(2)).sum();
        let linear: f64 = (0..3).map(|i| self.linear[i][0] * (place[i] - self.linear[i][2]).powi(2)).sum();
        0.5 * (rotary + linear)
    }
}
