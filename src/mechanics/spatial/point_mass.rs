//! A point mass on a massless link.

use super::{Body, Inertia, Pose, Spatial, Turn};
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::relation::spatial::{Full, Relation};
use crate::scalar::Scalar;

/// A point mass at the outboard end of a massless rigid link along the x axis: the bob of a mathematical pendulum.
///
/// Nothing resists its spin about the link, so it hangs from joints that do not let it spin: a [`Universal`](super::Universal) or a
/// [`Revolute`](super::Revolute), not a ball.
///
/// ```
/// use catena::spatial::PointMass;
/// let bob = PointMass::new(1.5, 0.2); // length (m), mass (kg)
/// assert_eq!(bob.inertia().centre, [1.5, 0.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: serde::Deserialize<'de>, T: num_traits::Zero"))
)]
pub struct PointMass<T> {
    pub(super) length: T,
    mass: T,
    /// In a scene the mass together with what its outboard neighbour lumps there.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    pub(super) lumped: T,
}

impl<T: Scalar> PointMass<T> {
    /// A point mass (kg) at the end of a massless link with a length (m).
    pub fn new(length: T, mass: T) -> Self {
        Self { length, mass, lumped: mass }
    }
}

impl<T: Scalar> Body<T> for PointMass<T> {
    fn inertia(&self) -> Inertia<T> {
        let about_centre = [[T::zero(); 3]; 3];
        Inertia { mass: self.mass, centre: self.outboard(), about_centre }
    }

    fn outboard(&self) -> [T; 3] {
        [self.length, T::zero(), T::zero()]
    }

    fn lump(&mut self, mass: T) -> T {
        self.lumped = self.mass + mass;
        T::zero()
    }

    const AXES: bool = false;

    #[inline(always)]
    fn pose(&self, turn: &Turn<T>) -> Pose<T> {
        Pose::with_arm(turn, turn.attitude.x * self.length)
    }

    #[inline(always)]
    fn condense<R: Relation<Spatial<T>>>(&self, outer: R, pose: &Pose<T>) -> Full<T, R::Closures> {
        outer.with_mass(self.lumped).carried(pose.arm, pose.centripetal)
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
