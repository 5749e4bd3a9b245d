//! How much the end of a body yields to a force: the measure of closures that hold it.

use crate::mechanics::spatial::BodyMotion;
use crate::relation::spatial::algebra::{cross, dot};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// Compliance of the outboard end of a free body.
pub(in crate::mechanics::spatial) struct Compliance<T> {
    inverse_mass: T,
    /// From the mass centre to the end (m).
    lever: Vector3<T>,
    /// Angular acceleration per torque (1/(kg·m²)).
    pub(in crate::mechanics::spatial) torque: T,
}

impl<T: Scalar> Compliance<T> {
    /// Of a body. Its mean moment of inertia counts with that of its mass at the ends, so that a point mass has one too: this
    /// serves as a measure, and a factor of a few does not matter.
    pub(in crate::mechanics::spatial) fn of(body: &BodyMotion<T>) -> Self {
        let inertia = &body.inertia;
        let (arm, centre) = (body.arm, body.to_centre);
        let spread = inertia.mass * (dot(arm, arm) + dot(centre, centre));
        let [[x, ..], [_, y, _], [.., z]] = inertia.about_centre;
        Self {
            inverse_mass: inertia.mass.recip(),
            lever: arm - centre,
            torque: ((x + y + z).scale(T::Real::of(1.0 / 3.0)) + spread).recip(),
        }
    }

    /// Acceleration of the end along each axis, for a unit force along it (1/kg).
    pub(in crate::mechanics::spatial) fn along_axes(&self) -> [T; 3] {
        let (zero, one) = (T::zero(), T::one());
        let axes = [Vector3::new(one, zero, zero), Vector3::new(zero, one, zero), Vector3::new(zero, zero, one)];
        axes.map(|axis| {
            let turn = cross(self.lever, axis);
            self.inverse_mass + dot(turn, turn) * self.torque
        })
    }
}
