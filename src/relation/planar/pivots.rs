//! The eliminations of rotations that joints make in a full relation.

use super::algebra::{add_scaled, normal};
use super::relative_gain::RelativeGain;
use super::{Full, FullColumn, Point};
use crate::relation::{Closures, Open, Symmetric, Term};
use crate::scalar::Scalar;
use nalgebra::Vector2;

impl<T: Scalar, C: Closures> Full<T, C> {
    /// Adds a rotary inertia (kg·m²).
    #[inline(always)]
    pub fn with_inertia(self, inertia: T) -> Self {
        Self { angular: self.angular + inertia, ..self }
    }

    /// Adds a first moment σ = m d_C (kg·m) about the station, of a body with −ω² as given.
    #[inline(always)]
    pub fn with_first_moment(self, moment: Vector2<T>, minus_spin2: T) -> Self {
        Self { coupling: self.coupling + normal(moment), force: add_scaled(self.force, minus_spin2, moment), ..self }
    }

    /// Lets the station turn freely under the torque that acts in the pin: the rotation is eliminated, and what the
    /// outward pass needs to find it again is returned beside the relation.
    #[cfg_attr(optimised, inline(always))]
    pub fn pinned<M: Term<T>>(self, torque: M) -> (Point<T, M, C>, Gain<T, C>) {
        let minus_inverse = -self.angular.recip();
        let per_acceleration = self.coupling * minus_inverse;
        let free = torque.take_from(self.torque) * minus_inverse;
        let reduce = |w: FullColumn<T>, row: T| add_scaled(w.force, row, self.coupling);
        let (cuts, per_closure) = self.cuts.eliminated(minus_inverse, free, |w| w.torque, reduce);
        let relation = Point {
            mass: self.linear.plus_outer(self.coupling, per_acceleration),
            offset: add_scaled(self.force, free, self.coupling),
            torque,
            cuts,
        };
        (relation, Gain { per_acceleration, free, per_closure })
    }

    /// Lets the station turn against a stiff torque τ̂ − K̂ φ̈, with φ̈ relative to the inboard body: only the pivot of the
    /// elimination, S_mm + K̂, knows of it.
    #[cfg_attr(optimised, inline(always))]
    pub fn hinged(self, torque: T, stiffness: T) -> (Self, RelativeGain<T, C>) {
        let minus_inverse = -(self.angular + stiffness).recip();
        let per_acceleration = self.coupling * minus_inverse;
        let per_angular = self.angular * minus_inverse;
        let free = (self.torque - torque) * minus_inverse;
        // What is left of the rotational part, I_a Φ = U Δ⁻¹ K̂: no difference of large numbers.
        let left = -(stiffness * minus_inverse);
        let reduce = |w: FullColumn<T>, row: T| FullColumn {
            force: add_scaled(w.force, row, self.coupling),
            torque: w.torque * left,
        };
        let (cuts, per_closure) = self.cuts.eliminated(minus_inverse, free, |w| w.torque, reduce);
        let relation = Self {
            linear: self.linear.plus_outer(self.coupling, per_acceleration),
            coupling: self.coupling * left,
            angular: self.angular * left,
            force: add_scaled(self.force, free, self.coupling),
            torque: self.angular.mul_add(free, self.torque),
            cuts,
        };
        (relation, RelativeGain { per_acceleration, per_angular, free, per_closure })
    }
}

/// A relation that resists rotation: what a joint that turns must find on its outboard side.
#[diagnostic::on_unimplemented(
    message = "a `Pin`, a hinge or a `Free` root needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint that turns",
    note = "end a chain with a body, put a body between two pins, and start a chain with a body: the root `Pinned` is a pin"
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

/// What eliminating a rotation leaves behind: α = free + w · a + row · λ.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector2<T>: serde::Serialize, T: serde::Serialize, C::Each<T>: serde::Serialize",
        deserialize = "Vector2<T>: serde::Deserialize<'de>, T: serde::Deserialize<'de>, C::Each<T>: serde::Deserialize<'de>"
    ))
)]
pub struct Gain<T: Copy, C: Closures = Open> {
    /// w = −s / S_mm (rad/m).
    pub per_acceleration: Vector2<T>,
    /// Angular acceleration of a station that does not accelerate (rad/s²).
    pub free: T,
    /// Angular acceleration for each closure force.
    pub per_closure: C::Each<T>,
}

impl<T: Scalar, C: Closures> Gain<T, C> {
    /// No gain yet.
    pub fn blank() -> Self {
        let per_acceleration = Vector2::new(T::zero(), T::zero());
        Self { per_acceleration, free: T::zero(), per_closure: C::each(|_| T::zero()) }
    }

    /// Whether the pivot of the gain resists: what velocities, loads and springs contribute may overflow where it does.
    pub fn is_finite(&self) -> bool {
        self.per_acceleration.x.is_finite() && self.per_acceleration.y.is_finite()
    }

    /// The angular acceleration (rad/s²) of the eliminated rotation where its station accelerates by `a`.
    #[cfg_attr(optimised, inline(always))]
    pub fn angular(&self, a: Vector2<T>, multipliers: &C::Each<T>) -> T {
        let w = self.per_acceleration;
        let open = w.x.mul_add(a.x, w.y.mul_add(a.y, self.free));
        C::plus_dot(open, &self.per_closure, multipliers)
    }
}
