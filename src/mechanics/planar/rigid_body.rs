//! A rigid body with its mass centre and its outboard end anywhere.

use super::body::Base;
use super::{Body, Inertia, Planar, Pose};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::planar::{Full, Relation};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A rigid body. Its axes start at the inboard end; mass centre and outboard end may be anywhere, also at the inboard end
/// (a flywheel). A body whose mass centre lies on the line between its ends is cheaper as a [`Rod`](super::Rod).
///
/// ```
/// use catena::planar::RigidBody;
/// // A plate: mass (kg), moment of inertia about the mass centre (kg·m²), mass centre and outboard end (m).
/// let plate = RigidBody::new(2.0, 0.3, [0.4, 0.1], [0.8, -0.2]);
/// assert_eq!(plate.inertia().mass, 2.0);
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
    outboard: [T; 2],
    /// J_I = J_C + m |d_C|².
    about_inboard: T,
    /// Point mass that its outboard neighbour lumps at the outboard end, in a scene.
    lumped: T,
}

/// What a body is made from: what it is written as.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct Given<T> {
    inertia: Inertia<T>,
    outboard: [T; 2],
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
    pub fn massless(outboard: [T; 2]) -> Self {
        Self::new(T::zero(), T::zero(), [T::zero(); 2], outboard)
    }

    /// A body with mass (kg), moment of inertia about its mass centre (kg·m²), mass centre and outboard end (m, body axes).
    pub fn new(mass: T, about_centre: T, centre: [T; 2], outboard: [T; 2]) -> Self {
        let [x, y] = centre;
        Self {
            inertia: Inertia { mass, centre, about_centre },
            outboard,
            about_inboard: about_centre + mass * (x * x + y * y),
            lumped: T::zero(),
        }
    }
}

/// A vector of body axes in inertial axes.
#[inline(always)]
fn turned<T: Scalar>([x, y]: [T; 2], pose: Pose<T>) -> Vector2<T> {
    Vector2::new(pose.x.mul_add(x, -(pose.y * y)), pose.y.mul_add(x, pose.x * y))
}

impl<T: Scalar> Body<T> for RigidBody<T> {
    fn inertia(&self) -> Inertia<T> {
        self.inertia
    }

    fn outboard(&self) -> [T; 2] {
        self.outboard
    }

    // Its own mass counts as a point mass at the inboard end, and what is left is the first moment about that.
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        self.inertia.mass
    }

    fn size(&self) -> T {
        T::zero()
    }

    /// (x, y) is the direction of the body's axes, p = −ω².
    #[inline(always)]
    fn pose(_: T, angle: T, minus_spin2: T) -> Pose<T> {
        let (y, x) = angle.sin_cos();
        Pose { x, y, p: minus_spin2, q: T::zero() }
    }

    #[inline(always)]
    fn arm(&self, pose: Pose<T>) -> [Vector2<T>; 2] {
        let arm = turned(self.outboard, pose);
        [arm, arm * pose.p]
    }

    const MOMENT: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn base(&self) -> Base<T> {
        let Inertia { mass, centre, .. } = self.inertia;
        let moment = centre.map(|x| mass * x);
        Base { outboard: self.outboard, moment, inertia: self.about_inboard, lumped: self.lumped }
    }

    fn direction(&self, pose: Pose<T>) -> Vector2<T> {
        Vector2::new(pose.x, pose.y)
    }

    #[cfg_attr(optimised, inline(always))]
    fn condense<R: Relation<Planar<T>>>(&self, outer: R, pose: Pose<T>) -> Full<T, R::Closures> {
        let [arm, centripetal] = self.arm(pose);
        outer
            .with_mass(self.lumped)
            .carried_by(self.about_inboard, arm, centripetal)
            .with_first_moment(turned(self.inertia.centre, pose) * self.inertia.mass, pose.p)
    }

    fn check(&self) -> Result<(), Fault> {
        if !(self.outboard[0].is_finite() && self.outboard[1].is_finite()) {
            return Err(Fault::NotFinite { parameter: "outboard end" });
        }
        self.inertia.check()
    }
}

impl<T: PartialEq> PartialEq for RigidBody<T> {
    fn eq(&self, other: &Self) -> bool {
        (&self.inertia, &self.outboard) == (&other.inertia, &other.outboard)
    }
}

lift!(RigidBody { inertia, outboard, about_inboard, lumped });
