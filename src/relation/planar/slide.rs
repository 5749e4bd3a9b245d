//! The elimination of a displacement: what joints with linear coordinates do.

use super::algebra::Symmetric2;
use super::relative_gain::RelativeGain;
use super::{Full, FullColumn, Planar, Point, Relation};
use crate::relation::{Closures, Term};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A relation in which a displacement can be eliminated.
#[diagnostic::on_unimplemented(
    message = "a joint that slides needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint that slides",
    note = "end a chain with a body, not with a joint"
)]
pub trait Slides<T: Scalar>: Relation<Planar<T>, WithMass = Self> {
    /// This relation in full.
    fn full(self) -> Full<T, Self::Closures>;

    /// This relation with the components of vectors along axes in the direction (x, y) and its normal.
    fn along(self, direction: Vector2<T>) -> Self;

    /// This relation with x and y exchanged: what eliminates x then eliminates y.
    fn swapped(self) -> Self;

    /// Lets the station move along x against a force τ̂ − K̂ ẍ on the outboard part, ẍ relative to the inboard one: only
    /// the pivot, S_xx + K̂, knows of the stiffness.
    ///
    /// No entry of what is handed on along x is a difference of large numbers: without stiffness it is zero, and the force τ̂.
    fn slid(self, force: T, stiffness: T) -> (Self, RelativeGain<T, Self::Closures>);
}

/// The numbers that an elimination of x needs, from the row of S that belongs to it.
struct Pivot<T> {
    minus_inverse: T,
    /// K̂ / (S_xx + K̂): the share of x that stays.
    left: T,
    /// S_xx / (S_xx + K̂).
    yielded: T,
    free: T,
}

impl<T: Scalar> Pivot<T> {
    #[cfg_attr(optimised, inline(always))]
    fn of(inertia: T, stiffness: T, applied: T, offset: T) -> Self {
        let minus_inverse = -(inertia + stiffness).recip();
        let (left, yielded) = (-(stiffness * minus_inverse), -(inertia * minus_inverse));
        Self { minus_inverse, left, yielded, free: (offset - applied) * minus_inverse }
    }

    /// S with x eliminated.
    #[inline(always)]
    fn reduce(&self, s: Symmetric2<T>) -> Symmetric2<T> {
        let yy = s.xy.mul_add(s.xy * self.minus_inverse, s.yy);
        Symmetric2 { xx: s.xx * self.left, xy: s.xy * self.left, yy }
    }

    /// The force with x eliminated: the applied one along x, but for the share that stays.
    #[inline(always)]
    fn force(&self, s: Symmetric2<T>, applied: T, e: Vector2<T>) -> Vector2<T> {
        Vector2::new(e.x.mul_add(self.left, applied * self.yielded), s.xy.mul_add(self.free, e.y))
    }
}

impl<T: Scalar, C: Closures> Slides<T> for Full<T, C> {
    #[inline(always)]
    fn full(self) -> Self {
        self
    }
    #[cfg_attr(optimised, inline(always))]
    fn along(self, direction: Vector2<T>) -> Self {
        Self {
            linear: self.linear.along(direction),
            coupling: along(self.coupling, direction),
            force: along(self.force, direction),
            cuts: self.cuts.mapped(|w| FullColumn { force: along(w.force, direction), ..w }),
            ..self
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn swapped(self) -> Self {
        Self {
            linear: self.linear.swapped(),
            coupling: self.coupling.yx(),
            force: self.force.yx(),
            cuts: self.cuts.mapped(|w| FullColumn { force: w.force.yx(), ..w }),
            ..self
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn slid(self, applied: T, stiffness: T) -> (Self, RelativeGain<T, C>) {
        let Self { linear: s, coupling, angular, force, torque, cuts } = self;
        let pivot = Pivot::of(s.xx, stiffness, applied, force.x);
        let (cuts, per_closure) = cuts.eliminated(
            pivot.minus_inverse,
            pivot.free,
            |w| w.force.x,
            |w, row| FullColumn {
                force: Vector2::new(w.force.x * pivot.left, s.xy.mul_add(row, w.force.y)),
                torque: coupling.x.mul_add(row, w.torque),
            },
        );
        let per_angular = coupling.x * pivot.minus_inverse;
        let relation = Self {
            linear: pivot.reduce(s),
            coupling: Vector2::new(coupling.x * pivot.left, s.xy.mul_add(per_angular, coupling.y)),
            angular: coupling.x.mul_add(per_angular, angular),
            force: pivot.force(s, applied, force),
            torque: coupling.x.mul_add(pivot.free, torque),
            cuts,
        };
        let per_acceleration = Vector2::new(-pivot.yielded, s.xy * pivot.minus_inverse);
        (relation, RelativeGain { per_acceleration, per_angular, free: pivot.free, per_closure })
    }
}

impl<T: Scalar, M: Term<T>, C: Closures> Slides<T> for Point<T, M, C> {
    #[inline(always)]
    fn full(self) -> Full<T, C> {
        self.whole()
    }
    #[cfg_attr(optimised, inline(always))]
    fn along(self, direction: Vector2<T>) -> Self {
        Self {
            mass: self.mass.along(direction),
            offset: along(self.offset, direction),
            cuts: self.cuts.mapped(|w| along(w, direction)),
            ..self
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn swapped(self) -> Self {
        Self {
            mass: self.mass.swapped(),
            offset: self.offset.yx(),
            cuts: self.cuts.mapped(|w: Vector2<T>| w.yx()),
            ..self
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn slid(self, applied: T, stiffness: T) -> (Self, RelativeGain<T, C>) {
        let Self { mass: s, offset, torque, cuts } = self;
        let pivot = Pivot::of(s.xx, stiffness, applied, offset.x);
        let (cuts, per_closure) = cuts.eliminated(
            pivot.minus_inverse,
            pivot.free,
            |w| w.x,
            |w, row| Vector2::new(w.x * pivot.left, s.xy.mul_add(row, w.y)),
        );
        let relation = Self { mass: pivot.reduce(s), offset: pivot.force(s, applied, offset), torque, cuts };
        let per_acceleration = Vector2::new(-pivot.yielded, s.xy * pivot.minus_inverse);
        (relation, RelativeGain { per_acceleration, per_angular: T::zero(), free: pivot.free, per_closure })
    }
}

/// The components of a vector along a direction and its normal.
#[inline(always)]
pub fn along<T: Scalar>(v: Vector2<T>, direction: Vector2<T>) -> Vector2<T> {
    let (c, s) = (direction.x, direction.y);
    Vector2::new(c.mul_add(v.x, s * v.y), c.mul_add(v.y, -(s * v.x)))
}

/// The direction in which [`along`] gives the components back.
#[inline(always)]
pub fn back<T: Scalar>(direction: Vector2<T>) -> Vector2<T> {
    Vector2::new(direction.x, -direction.y)
}
