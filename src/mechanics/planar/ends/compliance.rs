//! How much the end of a body yields to a force: the measure of closures that hold it.

use crate::mechanics::planar::BodyMotion;
use crate::relation::planar::algebra::{cross, dot};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// Compliance of the outboard end of a free body.
pub(in crate::mechanics::planar) struct Compliance<T> {
    inverse_mass: T,
    /// From the mass centre to the end (m).
    lever: Vector2<T>,
    /// Angular acceleration per torque (1/(kg·m²)).
    pub(in crate::mechanics::planar) torque: T,
}

impl<T: Scalar> Compliance<T> {
    /// Of a body. Its moment of inertia counts with that of its mass at the ends, so that a point mass has one too: this serves
    /// as a measure, and a factor of a few does not matter.
    pub(in crate::mechanics::planar) fn of(body: &BodyMotion<T>) -> Self {
        let inertia = &body.inertia;
        let (arm, centre) = (body.arm, body.to_centre);
        let spread = inertia.mass * (dot(arm, arm) + dot(centre, centre));
        Self {
            inverse_mass: inertia.mass.recip(),
            lever: arm - centre,
            torque: (inertia.about_centre + spread).recip(),
        }
    }

    /// Acceleration of the end along a direction, for a unit force along it (1/kg).
    pub(in crate::mechanics::planar) fn along(&self, direction: Vector2<T>) -> T {
        let turn = cross(self.lever, direction);
        self.inverse_mass + turn * turn * self.torque
    }
}
