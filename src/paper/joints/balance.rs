//! Newton and Euler for a body in an iterate, and their derivatives.

use crate::mechanics::planar::BodyMotion;
use crate::mechanics::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::paper::body::{External, Rigid};
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// The balance of a body in an iterate.
pub(super) struct Balance<T> {
    pub motion: BodyMotion<T>,
    pub external: External<T>,
    /// m and q at the outboard end.
    pub outer: (T, [T; 2]),
    /// m at the inboard end, where a joint's law gives it.
    pub held: Option<T>,
}

impl<T: Scalar> Balance<T> {
    /// The matrix of increments (δa_x, δa_y, δθ, δm, δq_x, δq_y, 1), of the same shape as (32), and m and q at the inboard end.
    #[allow(clippy::many_single_char_names)] // the symbols of (19) and (20)
    pub fn linearize(&self, body: &Rigid<T>, chi1: T::Real, chi3: T::Real) -> (TransferMatrix<T, 7>, (T, [T; 2])) {
        let mass = body.inertia.mass;
        let (o, c) = (self.motion.arm, self.motion.to_centre);
        let (at, centre) = (self.motion.inboard.acceleration, self.motion.centre().acceleration.linear);
        let (a, spin) = (at.linear, self.motion.rate());
        let External { force: [fx, fy], torque } = self.external;
        let (m_o, [qx, qy]) = self.outer;
        let about_inboard = body.about_inboard();

        // (19), (20)
        let q_i = [qx + mass * centre.x - fx, qy + mass * centre.y - fy];
        let balanced = m_o - (o.x * qy - o.y * qx) - mass * (c.x * a.y - c.y * a.x) + torque + (c.x * fy - c.y * fx)
            - about_inboard * at.angular;
        let m_i = self.held.unwrap_or(balanced);
        let residual = balanced - m_i;

        // How a point at d accelerates with δθ: (χ₁ − θ̇²) n − (2θ̇χ₃ + θ̈) d.
        let across = T::constant(chi1) - spin * spin;
        let along = (spin + spin).scale(chi3) + at.angular;
        let swing = |x: T, y: T| [-(across * y) - along * x, across * x - along * y];
        let (w_o, w_c) = (swing(o.x, o.y), swing(c.x, c.y));
        // ∂/∂θ of the torques of forces that stay.
        let geometric =
            o.x * qx + o.y * qy + mass * (c.x * a.x + c.y * a.y) - (c.x * fx + c.y * fy) - about_inboard.scale(chi1);

        let mut u = TransferMatrix::identity();
        (u[(X, THETA)], u[(Y, THETA)]) = (w_o[0], w_o[1]);
        (u[(QX, X)], u[(QY, Y)]) = (-mass, -mass);
        (u[(QX, THETA)], u[(QY, THETA)]) = (-(mass * w_c[0]), -(mass * w_c[1]));
        (u[(M, X)], u[(M, Y)]) = (mass * (o.y - c.y), mass * (c.x - o.x));
        u[(M, THETA)] = o.x * u[(QY, THETA)] - o.y * u[(QX, THETA)] - geometric;
        (u[(M, QX)], u[(M, QY)]) = (-o.y, o.x);
        u[(M, ONE)] = -residual;
        (u, (m_i, q_i))
    }
}
