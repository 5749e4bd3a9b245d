//! A body that is alike around the line between its ends.

use super::{Body, Inertia, Pose, Spatial, Turn};
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::relation::Symmetric;
use crate::relation::spatial::algebra::{cross, dot};
use crate::relation::spatial::{Full, Relation};
use crate::scalar::{Real, Scalar};

/// A rigid rod along its x axis, from the inboard end to the outboard end at (length, 0, 0), alike around that axis.
///
/// For the dynamics it is two point masses at its ends and moments of inertia J′ along and across, the latter negative for a
/// uniform rod. A rod on a [`Ball`](super::Ball) needs a moment of inertia along its axis, for nothing else resists the spin.
///
/// ```
/// use catena::spatial::Rod;
/// let rod = Rod::uniform(2.0, 0.5, 3.0); // length, radius (m), mass (kg)
/// assert_eq!(rod.inertia().about_centre[0][0], 0.375); // m r² / 2
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: serde::Deserialize<'de>, T: num_traits::Zero"))
)]
pub struct Rod<T> {
    pub(super) length: T,
    /// Point mass at the inboard end, m (1 − η) with η the mass centre's share of the length.
    inner: T,
    /// Point mass at the outboard end, m η.
    outer: T,
    /// J′ across the axis, J_C − m η (1 − η) l².
    pub(super) rest: T,
    /// J along the axis.
    pub(super) axial: T,
    /// (J − J′) / l², along less across.
    pub(super) excess: T,
    /// Point mass at the outboard end, in a scene together with what its outboard neighbour lumps there.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    pub(super) lumped: T,
}

impl<T: Scalar> Rod<T> {
    /// A uniform round rod: length, radius (m), mass (kg).
    pub fn uniform(length: T, radius: T, mass: T) -> Self {
        let (half, square) = (T::Real::of(0.5), mass * radius * radius);
        let across = (mass * length * length).scale(T::Real::of(1.0 / 12.0)) + square.scale(T::Real::of(0.25));
        Self::new(length, mass, length.scale(half), square.scale(half), across)
    }

    /// A rod with length (m), mass (kg), distance of the mass centre from the inboard end (m), and moments of inertia about the
    /// mass centre (kg·m²) along and across its axis.
    pub fn new(length: T, mass: T, centre: T, axial: T, across: T) -> Self {
        let outer = mass * centre / length;
        let rest = across - outer * (length - centre) * length;
        let excess = (axial - rest) / (length * length);
        Self { length, inner: mass - outer, outer, rest, axial, excess, lumped: outer }
    }

    /// Length (m).
    pub fn length(&self) -> T {
        self.length
    }
}

impl<T: Scalar> Body<T> for Rod<T> {
    fn inertia(&self) -> Inertia<T> {
        let (mass, o) = (self.inner + self.outer, T::zero());
        let centre = self.outer * self.length / mass;
        let across = self.rest + self.outer * (self.length - centre) * self.length;
        let about_centre = [[self.axial, o, o], [o, across, o], [o, o, across]];
        Inertia { mass, centre: [centre, o, o], about_centre }
    }

    fn outboard(&self) -> [T; 3] {
        [self.length, T::zero(), T::zero()]
    }

    fn lump(&mut self, mass: T) -> T {
        self.lumped = self.outer + mass;
        self.inner
    }

    const AXES: bool = false;

    // J′ = J′⊥ 1 + (J∥ − J′⊥) d dᵀ / l², so that ω × J′ ω = (J∥ − J′⊥) (d·ω) ω × d / l².
    #[cfg_attr(optimised, inline(always))]
    fn pose(&self, turn: &Turn<T>) -> Pose<T> {
        let pose = Pose::with_arm(turn, turn.attitude.x * self.length);
        let share = dot(pose.arm, turn.spin) * self.excess;
        Pose { turning: cross(turn.spin, pose.arm) * share, ..pose }
    }

    #[cfg_attr(optimised, inline(always))]
    fn condense<R: Relation<Spatial<T>>>(&self, outer: R, pose: &Pose<T>) -> Full<T, R::Closures> {
        let d = pose.arm;
        let full = outer.with_mass(self.lumped).carried(d, pose.centripetal);
        Full {
            angular: full.angular.plus_diagonal(self.rest).plus_outer(d, d * self.excess),
            torque: full.torque + pose.turning,
            ..full
        }
    }

    fn check(&self) -> Result<(), Fault> {
        positive("length", self.length)?;
        positive("mass", self.inner + self.outer)?; // a link without mass is a `PointMass`, or a `RigidBody`
        not_negative("moment of inertia", self.axial)?;
        let Inertia { about_centre, mass, .. } = self.inertia();
        let across = about_centre[1][1];
        // It may have been rounded when the rod was built from its base parameters.
        let scale = mass * self.length * self.length + self.axial;
        not_negative("moment of inertia", across + scale.scale(T::Real::EPSILON * T::Real::of(8.0)))
    }
}

impl<T: PartialEq> PartialEq for Rod<T> {
    fn eq(&self, other: &Self) -> bool {
        let Self { length, inner, outer, rest, axial, .. } = self;
        (length, inner, outer, rest, axial) == (&other.length, &other.inner, &other.outer, &other.rest, &other.axial)
    }
}

lift!(Rod { length, inner, outer, rest, axial, excess, lumped });
