//! A point mass on a massless link.

use super::body::Base;
use super::{Body, Inertia, Planar, Pose};
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::relation::planar::{Full, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A point mass at the outboard end of a massless rigid link along the x axis: the bob of a mathematical pendulum.
///
/// (40) of the paper cannot transfer such a body: its outboard end is the centre of percussion of its inboard end, where
/// the pivot Ū₄₃ vanishes. A condensed relation has the pivot n·S n > 0 instead.
///
/// ```
/// use catena::planar::PointMass;
/// let bob = PointMass::new(1.5, 0.2); // length (m), mass (kg)
/// assert_eq!(bob.inertia().centre, [1.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: serde::Deserialize<'de>, T: num_traits::Zero"))
)]
pub struct PointMass<T> {
    length: T,
    mass: T,
    /// In a scene the mass together with what its outboard neighbour lumps there.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar> PointMass<T> {
    /// A point mass (kg) at the end of a massless link with a length (m).
    pub fn new(length: T, mass: T) -> Self {
        Self { length, mass, lumped: mass }
    }
}

impl<T: Scalar> Body<T> for PointMass<T> {
    fn inertia(&self) -> Inertia<T> {
        Inertia { mass: self.mass, centre: [self.length, T::zero()], about_centre: T::zero() }
    }

    fn outboard(&self) -> [T; 2] {
        [self.length, T::zero()]
    }

    fn lump(&mut self, mass: T) -> T {
        self.lumped = self.mass + mass;
        T::zero()
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
        Base { outboard: [self.length, zero], moment: [zero; 2], inertia: zero, lumped: self.lumped }
    }

    fn direction(&self, pose: Pose<T>) -> Vector2<T> {
        Vector2::new(pose.x, pose.y) * self.length.recip()
    }

    #[inline(always)]
    fn condense<R: Relation<Planar<T>>>(&self, outer: R, pose: Pose<T>) -> Full<T, R::Closures> {
        let [arm, centripetal] = pose.link();
        outer.with_mass(self.lumped).carried(arm, centripetal)
    }

    fn check(&self) -> Result<(), Fault> {
        positive("length", self.length)?;
        not_negative("mass", self.mass)
    }
}

impl<T: PartialEq> PartialEq for PointMass<T> {
    fn eq(&self, other: &Self) -> bool {
        (&self.length, &self.mass) == (&other.length, &other.mass)
    }
}

lift!(PointMass { length, mass, lumped });
