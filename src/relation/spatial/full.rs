//! What only relations in space do along a body.

use super::Full;
use super::algebra::{Columns, Symmetric3, cross, cross_onto};
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use nalgebra::Vector3;

impl<T: Scalar> Full<T> {
    /// The acceleration (a, α) of a station on which nothing acts: S p + e = 0, by block elimination.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn free(self) -> (Vector3<T>, Vector3<T>) {
        let (point, gain) = self.balled(Absent);
        let linear = -point.mass.factor().solve(point.offset);
        (linear, gain.angular(linear, &()))
    }
}

impl<T: Scalar, C: Closures> Full<T, C> {
    /// Adds a body's moments of inertia about the station, inertial axes (kg·m²), and its gyroscopic torque ω × J ω. They may be
    /// less than nothing when they only complete those of point masses.
    #[inline(always)]
    pub fn with_inertia(self, inertia: Symmetric3<T>, spin: Vector3<T>) -> Self {
        Self { angular: self.angular + inertia, torque: cross_onto(spin, inertia.apply(spin), self.torque), ..self }
    }

    /// Adds a first moment σ = m r_C (kg·m) about the station, of a body that turns with ω.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn with_first_moment(self, moment: Vector3<T>, spin: Vector3<T>) -> Self {
        let k = self.coupling;
        let coupling = Columns {
            x: Vector3::new(k.x.x, k.x.y - moment.z, k.x.z + moment.y),
            y: Vector3::new(k.y.x + moment.z, k.y.y, k.y.z - moment.x),
            z: Vector3::new(k.z.x - moment.y, k.z.y + moment.x, k.z.z),
        };
        Self { coupling, force: cross_onto(spin, cross(spin, moment), self.force), ..self }
    }
}

/// A relation that resists rotation: what a joint must find on its outboard side.
#[diagnostic::on_unimplemented(
    message = "a joint or a `Free` root needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint",
    note = "end a chain with a body, put a body between two joints, and start a chain with a body: the root `Pinned` is a ball"
)]
pub trait Rigid<T: Scalar>: Copy {
    /// Closure forces that the relation carries.
    type Closures: Closures;
    /// The relation in full.
    fn full(self) -> Full<T, Self::Closures>;
}

impl<T: Scalar, C: Closures> Rigid<T> for Full<T, C> {
    type Closures = C;
    #[inline(always)]
    fn full(self) -> Self {
        self
    }
}
