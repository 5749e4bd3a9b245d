//! A rigid body with its mass centre and its outboard end anywhere.

use super::{Body, Inertia, Pose, Spatial, Turn};
use crate::error::Fault;
use crate::error::checks::finite;
use crate::lift::lift;
use crate::relation::spatial::algebra::Symmetric3;
use crate::relation::spatial::{Full, Relation};
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// A rigid body. Its axes start at the inboard end; mass centre and outboard end may be anywhere, also at the inboard end. A body
/// that is alike around the line between its ends, its mass centre on that line, is cheaper as a [`Rod`](super::Rod).
///
/// ```
/// use catena::spatial::RigidBody;
/// // Mass (kg), inertia tensor about the mass centre (kg·m²), mass centre and outboard end (m).
/// let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
/// let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
/// assert_eq!(body.inertia().mass, 1.0);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: Scalar + serde::Serialize", deserialize = "T: Scalar + serde::Deserialize<'de>"))
)]
#[cfg_attr(feature = "serde", serde(from = "Given<T>", into = "Given<T>"))]
pub struct RigidBody<T> {
    inertia: Inertia<T>,
    outboard: [T; 3],
    /// J_I.
    pub(super) about_inboard: Symmetric3<T>,
    /// m r_C.
    pub(super) moment: [T; 3],
    /// Point mass that its outboard neighbour lumps at the outboard end, in a scene.
    pub(super) lumped: T,
}

/// What a body is made from: what it is written as.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Given<T> {
    inertia: Inertia<T>,
    outboard: [T; 3],
}

#[cfg(feature = "serde")]
impl<T: Scalar> From<Given<T>> for RigidBody<T> {
    fn from(given: Given<T>) -> Self {
        let Inertia { mass, centre, about_centre } = given.inertia;
        Self::new(mass, about_centre, centre, given.outboard)
    }
}

#[cfg(feature = "serde")]
impl<T: Scalar> From<RigidBody<T>> for Given<T> {
    fn from(body: RigidBody<T>) -> Self {
        Self { inertia: body.inertia, outboard: body.outboard }
    }
}

impl<T: Scalar> RigidBody<T> {
    /// A body without mass that reaches to an outboard end (m, body axes): a distance between two joints that turns with them, or
    /// from the ground to a joint.
    pub fn massless(outboard: [T; 3]) -> Self {
        Self::new(T::zero(), [[T::zero(); 3]; 3], [T::zero(); 3], outboard)
    }

    /// A body with mass (kg), inertia tensor about its mass centre (kg·m²), mass centre and outboard end (m), in body axes.
    pub fn new(mass: T, about_centre: [[T; 3]; 3], centre: [T; 3], outboard: [T; 3]) -> Self {
        let inertia = Inertia { mass, centre, about_centre };
        let moment = centre.map(|x| x * mass);
        Self { inertia, outboard, about_inboard: inertia.about_inboard(), moment, lumped: T::zero() }
    }
}

impl<T: Real> RigidBody<T> {
    /// This body with the nearest inertia that a body has: see [`Inertia::repaired`].
    ///
    /// ```
    /// use catena::spatial::RigidBody;
    /// // From a robot description file, rounded: 0.012 and 0.004 are less than 0.0161.
    /// let tensor = [[0.0161, 0.0, 0.0], [0.0, 0.012, 0.0], [0.0, 0.0, 0.004]];
    /// let link = RigidBody::new(0.8, tensor, [0.05, 0.0, 0.0], [0.1, 0.0, 0.0]);
    /// assert!(link.inertia().doubt().is_some() && link.repaired().inertia().doubt().is_none());
    /// ```
    #[must_use]
    pub fn repaired(self) -> Self {
        let Inertia { mass, centre, about_centre } = self.inertia.repaired();
        Self::new(mass, about_centre, centre, self.outboard)
    }
}

impl<T: Scalar> Body<T> for RigidBody<T> {
    fn inertia(&self) -> Inertia<T> {
        self.inertia
    }

    fn outboard(&self) -> [T; 3] {
        self.outboard
    }

    // Its own mass counts as a point mass at the inboard end, and what is left is the first moment about that.
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        self.inertia.mass
    }

    const AXES: bool = true;

    #[inline(always)]
    fn pose(&self, turn: &Turn<T>) -> Pose<T> {
        Pose::with_arm(turn, turn.attitude.apply(Vector3::from(self.outboard)))
    }

    #[cfg_attr(optimised, inline(always))]
    fn condense<R: Relation<Spatial<T>>>(&self, outer: R, pose: &Pose<T>) -> Full<T, R::Closures> {
        outer
            .with_mass(self.lumped)
            .carried(pose.arm, pose.centripetal)
            .with_first_moment(pose.attitude.apply(Vector3::from(self.moment)), pose.turning)
            .with_inertia(self.about_inboard.turned(&pose.attitude), pose.turning)
    }

    fn check(&self) -> Result<(), Fault> {
        finite("outboard end", &self.outboard)?;
        self.inertia.check()
    }
}

impl<T: PartialEq> PartialEq for RigidBody<T> {
    fn eq(&self, other: &Self) -> bool {
        (&self.inertia, &self.outboard) == (&other.inertia, &other.outboard)
    }
}

lift!(RigidBody { inertia, outboard, about_inboard, moment, lumped });
