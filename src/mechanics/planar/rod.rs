//! A body whose mass centre lies on the line between its ends.

use super::body::Base;
use super::{Body, Inertia, Planar, Pose};
use crate::error::Fault;
use crate::error::checks::positive;
use crate::lift::lift;
use crate::relation::planar::{Full, Relation};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector2;

/// A rigid rod along its x axis, from the inboard end to the outboard end at (length, 0), its mass centre on the axis.
///
/// For the dynamics it is two point masses at its ends and a rotary inertia J′, which is negative for a uniform rod: these
/// and the length are all that a sweep reads.
///
/// ```
/// use catena::planar::Rod;
/// let rod = Rod::uniform(2.0, 3.0);
/// assert_eq!(rod.inertia().about_centre, 1.0); // m l² / 12
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: serde::Deserialize<'de>, T: num_traits::Zero"))
)]
pub struct Rod<T> {
    length: T,
    /// Point mass at the inboard end, m (1 − η) with η the mass centre's share of the length.
    inner: T,
    /// Point mass at the outboard end, m η.
    outer: T,
    /// J′ = J_C + m η² l² − m η l².
    rest: T,
    /// Point mass at the outboard end, in a scene together with what its outboard neighbour lumps there.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar> Rod<T> {
    /// A uniform thin rod: length (m), mass (kg).
    pub fn uniform(length: T, mass: T) -> Self {
        let half = T::Real::of(0.5);
        let about_centre = (mass * length * length).scale(T::Real::of(1.0 / 12.0));
        Self::new(length, mass, length.scale(half), about_centre)
    }

    /// A rod with length (m), mass (kg), distance of the mass centre from the inboard end (m) and moment of inertia about
    /// the mass centre (kg·m²).
    pub fn new(length: T, mass: T, centre: T, about_centre: T) -> Self {
        let outer = mass * centre / length;
        let rest = about_centre - outer * (length - centre) * length;
        Self { length, inner: mass - outer, outer, rest, lumped: outer }
    }

    /// Length (m).
    pub fn length(&self) -> T {
        self.length
    }
}

impl<T: Scalar> Body<T> for Rod<T> {
    fn inertia(&self) -> Inertia<T> {
        let mass = self.inner + self.outer;
        let centre = self.outer * self.length / mass;
        let about_centre = self.rest + self.outer * (self.length - centre) * self.length;
        Inertia { mass, centre: [centre, T::zero()], about_centre }
    }

    fn outboard(&self) -> [T; 2] {
        [self.length, T::zero()]
    }

    fn lump(&mut self, mass: T) -> T {
        self.lumped = self.outer + mass;
        self.inner
    }

    fn size(&self) -> T {
        self.length
    }

    #[inline(always)]
    fn pose(length: T, angle: T, minus_spin2: T) -> Pose<T> {
        Pose::of_link(length, angle, minus_spin2)
    }

    #[inline(always)]
    fn arm(&self, pose: Pose<T>) -> [Vector2<T>; 2] {
        pose.link()
    }

    #[inline(always)]
    fn base(&self) -> Base<T> {
        let zero = T::zero();
        Base { outboard: [self.length, zero], moment: [zero; 2], inertia: self.rest, lumped: self.lumped }
    }

    fn direction(&self, pose: Pose<T>) -> Vector2<T> {
        Vector2::new(pose.x, pose.y) * self.length.recip()
    }

    #[inline(always)]
    fn condense<R: Relation<Planar<T>>>(&self, outer: R, pose: Pose<T>) -> Full<T, R::Closures> {
        let [arm, centripetal] = pose.link();
        outer.with_mass(self.lumped).carried_by(self.rest, arm, centripetal)
    }

    fn check(&self) -> Result<(), Fault> {
        positive("length", self.length)?;
        positive("mass", self.inner + self.outer)?; // a link without mass is a `PointMass`, or a `RigidBody`
        self.inertia().check()
    }
}

impl<T: PartialEq> PartialEq for Rod<T> {
    fn eq(&self, other: &Self) -> bool {
        let Self { length, inner, outer, rest, .. } = self;
        (length, inner, outer, rest) == (&other.length, &other.inner, &other.outer, &other.rest)
    }
}

lift!(Rod { length, inner, outer, rest, lumped });
