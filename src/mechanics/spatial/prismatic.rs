//! The prismatic joint.

use super::Turn;
use super::axial::{Axial, Relative, check_axis, unit};
use crate::element::Implicit;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};
use nalgebra::Vector3;

/// Two bodies slide along an axis without turning.
///
/// Its coordinate is how far (m) the outboard point has moved along the axis, which is fixed to the inboard body. [`System::at_rest`]
/// leaves it zero; [`Motion::set_coordinates_of`](crate::Motion::set_coordinates_of) sets it.
///
/// [`System::at_rest`]: crate::system::System::at_rest
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector3<T>: serde::Serialize, L: serde::Serialize",
        deserialize = "Vector3<T>: serde::Deserialize<'de>, L: serde::Deserialize<'de>, T: num_traits::Zero"
    ))
)]
pub struct Prismatic<T, L = Spring> {
    axis: Vector3<T>,
    law: L,
    /// In a scene, the point mass that its outboard neighbour lumps at the outboard point.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar> Prismatic<T> {
    /// Along an axis in body axes, of any length.
    pub fn along(axis: [T; 3]) -> Self {
        Self { axis: unit(axis), law: Spring::none(), lumped: T::zero() }
    }

    /// With a spring, a damper, or both.
    pub fn with<L: SpringLaw<T>>(self, law: L) -> Prismatic<T, L> {
        Prismatic { axis: self.axis, law, lumped: self.lumped }
    }
}

impl<T: Scalar, L> Prismatic<T, L> {
    /// The axis, a unit vector in body axes.
    pub(crate) fn axis(&self) -> Vector3<T> {
        self.axis
    }

    /// The spring or damper.
    pub(crate) fn law(&self) -> &L {
        &self.law
    }
}

impl<T: Scalar, L: SpringLaw<T>> Axial<T, 1> for Prismatic<T, L> {
    type Coordinates = T;
    const WAYS: [Way; 1] = [Way::Slide];
    const SLIDES: bool = true;
    const TURNS: bool = false;
    const LINEAR: bool = L::LINEAR;

    #[cfg_attr(optimised, inline(always))]
    fn relative(&self, inboard: &Turn<T>, [slide]: [T; 1], [rate]: [T; 1]) -> Relative<T, 1> {
        let n = inboard.attitude.apply(self.axis);
        Relative {
            attitude: inboard.attitude,
            axes: [n],
            spin: zero(),
            arm: n * slide,
            sliding: n * rate,
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
    fn energy(&self, [slide]: [T; 1]) -> T {
        self.law.energy(slide)
    }
    fn lump(&mut self, mass: T) -> T {
        self.lumped = mass;
        T::zero()
    }
    #[inline(always)]
    fn lumped(&self) -> T {
        self.lumped
    }
    fn verify(&self) -> Result<(), Fault> {
        check_axis(self.axis)?;
        self.law.check()
    }
}

lift!(Prismatic<T, L> { axis, law, lumped });
