//! The revolute joint.

use super::Turn;
use super::axial::{Axial, Relative, aside, check_axis, unit};
use super::maps::about;
use crate::element::Implicit;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};
use nalgebra::Vector3;

/// Two bodies share a point and an axis, and turn about it.
///
/// Its coordinate is the angle (rad) of the outboard body relative to the inboard one, whose axes coincide at zero. A
/// [`Weld`](super::Weld) beside it turns the axes of a body.
///
/// ```
/// use catena::spatial::*;
/// let rod = Rod::uniform(1.0, 0.1, 1.0);
/// let hinge = Revolute::about([0.0, 0.0, 1.0]).with(Spring::stiffness(20.0));
/// let arm = System::new(Clamped::origin(), (Revolute::about([0.0, 1.0, 0.0]), rod, hinge, rod), Free)?;
/// assert_eq!(arm.at_rest(&[0.3, -0.2])?.coordinates(), [0.3, -0.2]);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector3<T>: serde::Serialize, L: serde::Serialize",
        deserialize = "Vector3<T>: serde::Deserialize<'de>, L: serde::Deserialize<'de>"
    ))
)]
pub struct Revolute<T, L = Spring> {
    pub(super) axis: Vector3<T>,
    pub(super) law: L,
}

impl<T: Scalar> Revolute<T> {
    /// About an axis in body axes, of any length.
    pub fn about(axis: [T; 3]) -> Self {
        Self { axis: unit(axis), law: Spring::none() }
    }

    /// The axis, a unit vector in body axes.
    pub fn axis(&self) -> Vector3<T> {
        self.axis
    }

    /// With a spring, a damper, or both.
    pub fn with<L: SpringLaw<T>>(self, law: L) -> Revolute<T, L> {
        Revolute { axis: self.axis, law }
    }
}

impl<T: Scalar, L> Revolute<T, L> {
    /// Which of the body's own axes is not along that of the joint: the first one, or the second.
    #[inline(always)]
    pub(super) fn aside<const N: usize>(&self, first: [Vector3<T>; N], second: [Vector3<T>; N]) -> [Vector3<T>; N] {
        aside(self.axis, first, second)
    }

    /// The axis, and the spring or damper.
    pub(crate) fn parts(&self) -> (Vector3<T>, &L) {
        (self.axis, &self.law)
    }
}

impl<T: Scalar, L: SpringLaw<T>> Axial<T, 1> for Revolute<T, L> {
    type Coordinates = T;
    const WAYS: [Way; 1] = [Way::Turn];
    const SLIDES: bool = false;
    const TURNS: bool = true;
    const LINEAR: bool = L::LINEAR;

    #[cfg_attr(optimised, inline(always))]
    fn relative(&self, inboard: &Turn<T>, [angle]: [T; 1], [rate]: [T; 1]) -> Relative<T, 1> {
        let n = inboard.attitude.apply(self.axis);
        Relative {
            attitude: inboard.attitude.times(&about(self.axis, angle)),
            axes: [n],
            spin: n * rate,
            arm: zero(),
            sliding: zero(),
            extra: zero(),
        }
    }
    #[inline(always)]
    fn force(&self, _: usize, position: T, rate: T) -> T {
        self.law.force(position, rate)
    }
    #[inline(always)]
    fn pivot(&self, _: usize, position: T, rate: T, springs: Implicit<T::Real>) -> T {
        self.law.pivot(position, rate, springs)
    }
    fn energy(&self, [angle]: [T; 1]) -> T {
        self.law.energy(angle)
    }
    fn verify(&self) -> Result<(), Fault> {
        check_axis(self.axis)?;
        self.law.check()
    }
}

lift!(Revolute<T, L> { axis, law });
