//! What only relations in space do along a body.

use super::algebra::{Columns, Symmetric3, cross, cross_onto, zero};
use super::pivots::turned_out;
use super::{Full, Spatial};
use crate::relation::{Absent, AccelerationOf, Closures, Cuts, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A station on which nothing acts: its acceleration, what each closure force adds to that, and what is left to say of them.
pub type Afloat<T, C> =
    (AccelerationOf<Spatial<T>>, <C as Closures>::Each<AccelerationOf<Spatial<T>>>, Cuts<Vector3<T>, T, C>);

impl<T: Scalar, C: Closures> Full<T, C> {
    /// The acceleration of a station on which nothing acts: S p + e + W λ = 0, by block elimination.
    #[cfg_attr(optimised, inline(always))]
    pub fn afloat(self) -> Afloat<T, C> {
        let (point, gain) = self.balled(Absent);
        let factor = point.mass.factor();
        let linear = -factor.solve(point.offset);
        let (cuts, rows) = turned_out(&point.cuts, |w| w, linear, |w| -factor.solve(w), |_, _| zero());
        let angular = gain.angular(linear, &C::each(|_| T::zero()));
        let per_closure = C::zip(&rows, &gain.per_closure, |linear, own| AccelerationOf::<Spatial<T>> {
            linear,
            angular: gain.per_acceleration.apply_onto(linear, own),
        });
        (AccelerationOf::<Spatial<T>> { linear, angular }, per_closure, cuts)
    }

    /// Adds a body's moments of inertia about the station, inertial axes (kg·m²), and its gyroscopic torque ω × J ω. They may be
    /// less than nothing when they only complete those of point masses.
    #[inline(always)]
    pub fn with_inertia(self, inertia: Symmetric3<T>, spin: Vector3<T>) -> Self {
        Self { angular: self.angular + inertia, torque: cross_onto(spin, inertia.apply(spin), self.torque), ..self }
    }

    /// Adds a first moment σ = m r_C (kg·m) about the station, of a body that turns with ω.
    #[cfg_attr(optimised, inline(always))]
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
    note = "end a chain with a body, put a body between two joints, and start a chain with a body: the root `Pinned` is a ball",
    note = "a robot of `Link`s begins with `BodyAxes`, on a `Free` root, too, and has a `Hinge` or `Slide` in it: of a single body that floats take a `RigidBody`"
)]
pub trait Rigid<T: Scalar>: Copy {
    /// Closure forces that the relation carries.
    type Closures: Closures;
    /// The relation in full.
    fn full(self) -> Full<T, Self::Closures>;
    /// The acceleration of the station where nothing acts on it but a point mass (kg) there.
    #[cfg_attr(optimised, inline(always))]
    fn afloat_with(self, lumped: T) -> Afloat<T, Self::Closures> {
        Relation::with_mass(self.full(), lumped).afloat()
    }
    /// The acceleration of the station where nothing acts on it but a force (N) and a torque (N·m) from outside, inertial axes.
    #[cfg_attr(optimised, inline(always))]
    fn afloat_under(self, force: Vector3<T>, torque: Vector3<T>) -> AccelerationOf<Spatial<T>> {
        let own = self.full();
        let (acceleration, ..) = Full { force: own.force - force, torque: own.torque - torque, ..own }.afloat();
        acceleration
    }
}

impl<T: Scalar, C: Closures> Rigid<T> for Full<T, C> {
    type Closures = C;
    #[inline(always)]
    fn full(self) -> Self {
        self
    }
}
