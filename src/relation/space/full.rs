//! The full relation, and how it moves along a body.

use super::algebra::{Columns, Symmetric3, add_scaled, cross, cross_onto, dot, zero};
use super::kinds::Relation;
use crate::relation::{Absent, Closures, Cuts, Open};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A full relation: q = L a + K α + e_q, −m = Kᵀ a + H α + e_m, and columns for closure forces.
#[derive(Clone, Copy)]
pub struct Full<T: Copy, C: Closures = Open> {
    /// L (kg).
    pub linear: Symmetric3<T>,
    /// K, the coupling of force and angular acceleration (kg·m).
    pub coupling: Columns<T>,
    /// H (kg·m²).
    pub angular: Symmetric3<T>,
    /// e_q (N).
    pub force: Vector3<T>,
    /// e_m (N·m), of the torque on the outboard part.
    pub torque: Vector3<T>,
    /// Columns of closure forces.
    pub cuts: Cuts<FullColumn<T>, T, C>,
}

/// A column of W: the force and torque on the outboard part for a unit closure force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FullColumn<T> {
    /// Of q.
    pub force: Vector3<T>,
    /// Of −m.
    pub torque: Vector3<T>,
}

impl<T: Scalar> Full<T> {
    /// Nothing that has mass.
    #[inline(always)]
    pub fn massless() -> Self {
        let none = Symmetric3::diagonal(T::zero());
        Self {
            linear: none,
            coupling: Columns::zero(),
            angular: none,
            force: zero(),
            torque: zero(),
            cuts: Cuts::none(),
        }
    }

    /// The same relation with closure forces.
    #[inline(always)]
    pub fn cut<C: Closures>(self, cuts: Cuts<FullColumn<T>, T, C>) -> Full<T, C> {
        let Self { linear, coupling, angular, force, torque, .. } = self;
        Full { linear, coupling, angular, force, torque, cuts }
    }

    /// The acceleration (a, α) of a station on which nothing acts: S p + e = 0, by block elimination.
    #[inline(always)]
    pub fn free(self) -> (Vector3<T>, Vector3<T>) {
        let (point, gain) = self.balled(Absent);
        let linear = -point.stiffness.factor().solve(point.offset);
        (linear, gain.angular(linear, &()))
    }
}

/// −L d~, column by column: the force for an angular acceleration about a point at −d.
#[inline(always)]
pub(super) fn levered<T: Scalar>(linear: Symmetric3<T>, d: Vector3<T>, k: Columns<T>) -> Columns<T> {
    let l = linear.columns();
    Columns {
        x: add_scaled(add_scaled(k.x, -d.z, l.y), d.y, l.z),
        y: add_scaled(add_scaled(k.y, -d.x, l.z), d.z, l.x),
        z: add_scaled(add_scaled(k.z, -d.y, l.x), d.x, l.y),
    }
}

impl<T: Scalar, C: Closures> Relation<T> for Full<T, C> {
    type Closures = C;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { linear: self.linear.plus_diagonal(mass), ..self }
    }

    #[inline(always)]
    fn carried(self, d: Vector3<T>, centripetal: Vector3<T>) -> Self {
        let (k, h) = (self.coupling, self.angular);
        let coupling = levered(self.linear, d, k);
        // H + d~ K' + (d~ K)ᵀ
        let n = &coupling;
        let crossed_x = |v: Vector3<T>, sum: T| d.y.mul_add(v.z, (-d.z).mul_add(v.y, sum));
        let crossed_y = |v: Vector3<T>, sum: T| d.z.mul_add(v.x, (-d.x).mul_add(v.z, sum));
        let crossed_z = |v: Vector3<T>, sum: T| d.x.mul_add(v.y, (-d.y).mul_add(v.x, sum));
        let angular = Symmetric3 {
            xx: crossed_x(k.x, crossed_x(n.x, h.xx)),
            xy: crossed_x(k.y, crossed_y(n.x, h.xy)),
            xz: crossed_x(k.z, crossed_z(n.x, h.xz)),
            yy: crossed_y(k.y, crossed_y(n.y, h.yy)),
            yz: crossed_y(k.z, crossed_z(n.y, h.yz)),
            zz: crossed_z(k.z, crossed_z(n.z, h.zz)),
        };
        let force = self.linear.apply_onto(centripetal, self.force);
        Self {
            linear: self.linear,
            coupling,
            angular,
            force,
            torque: cross_onto(d, force, k.transposed_onto(centripetal, self.torque)),
            cuts: self.cuts.turned(
                |w| FullColumn { force: w.force, torque: cross_onto(d, w.force, w.torque) },
                |gap, w| gap - dot(w.force, centripetal),
            ),
        }
    }
}

impl<T: Scalar, C: Closures> Full<T, C> {
    /// Adds a body's moments of inertia about the station, inertial axes (kg·m²), and its gyroscopic torque ω × J ω. They may be
    /// less than nothing when they only complete those of point masses.
    #[inline(always)]
    pub fn with_inertia(self, inertia: Symmetric3<T>, spin: Vector3<T>) -> Self {
        Self { angular: self.angular.plus(inertia), torque: cross_onto(spin, inertia.apply(spin), self.torque), ..self }
    }

    /// Adds a first moment σ = m r_C (kg·m) about the station, of a body that turns with ω.
    #[inline(always)]
    pub fn with_first_moment(self, moment: Vector3<T>, spin: Vector3<T>) -> Self {
        let k = self.coupling;
        let coupling = Columns {
            x: Vector3::new(k.x.x, k.x.y - moment.z, k.x.z + moment.y),
            y: Vector3::new(k.y.x + moment.z, k.y.y, k.y.z - moment.x),
            z: Vector3::new(k.z.x - moment.y, k.z.y + moment.x, k.z.z),
        };
        Self { coupling, force: cross_onto(spin, cross(spin, moment), self.force), ..self }
    }

    /// Where the station has an acceleration (c_a, c_α) besides that of the station that takes its place: F = S (p + c) + e.
    #[inline(always)]
    pub fn biased(self, linear: Vector3<T>, angular: Vector3<T>) -> Self {
        let turned = self.turning(angular);
        Self {
            force: turned.linear.apply_onto(linear, turned.force),
            torque: turned.coupling.transposed_onto(linear, turned.torque),
            cuts: turned.cuts.turned(|w| w, |gap, w| gap - dot(w.force, linear)),
            ..turned
        }
    }

    /// The same with an angular acceleration alone.
    #[inline(always)]
    pub fn turning(self, angular: Vector3<T>) -> Self {
        Self {
            force: self.coupling.apply_onto(angular, self.force),
            torque: self.angular.apply_onto(angular, self.torque),
            cuts: self.cuts.turned(|w| w, |gap, w| gap - dot(w.torque, angular)),
            ..self
        }
    }
}

/// A relation that resists rotation: what a joint must find on its outboard side.
#[diagnostic::on_unimplemented(
    message = "a joint or a `Free` root needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint",
    note = "end a chain with a body, put a body between two joints, and start a chain with a body: the root `Pinned` is a ball"
)]
pub trait Rigid<T: Scalar>: Copy {
    /// Closure forces it carries.
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
