//! The cylindrical joint.

use super::Turn;
use super::axial::{Axial, Relative, check_axis, unit};
use super::maps::about;
use crate::element::Implicit;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};
use nalgebra::Vector3;

/// Two bodies slide along an axis and turn about it.
///
/// Its coordinates are how far (m) the outboard point has moved along the axis, and the angle (rad) of the outboard body.
/// [`System::at_rest`](crate::system::System::at_rest) takes the angle; [`Motion::set_coordinates_of`](crate::Motion::set_coordinates_of)
/// sets both.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector3<T>: serde::Serialize, L: serde::Serialize, M: serde::Serialize",
        deserialize = "Vector3<T>: serde::Deserialize<'de>, L: serde::Deserialize<'de>, M: serde::Deserialize<'de>, T: num_traits::Zero"
    ))
)]
pub struct Cylindrical<T, L = Spring, M = Spring> {
    axis: Vector3<T>,
    along: L,
    about: M,
    /// In a scene, the point mass that its outboard neighbour lumps at the outboard point.
    #[cfg_attr(feature = "serde", serde(skip, default = "num_traits::zero"))]
    lumped: T,
}

impl<T: Scalar> Cylindrical<T> {
    /// On an axis in body axes, of any length.
    pub fn on(axis: [T; 3]) -> Self {
        Self { axis: unit(axis), along: Spring::none(), about: Spring::none(), lumped: T::zero() }
    }

    /// With springs and dampers along and about the axis.
    pub fn with<L: SpringLaw<T>, M: SpringLaw<T>>(self, along: L, about: M) -> Cylindrical<T, L, M> {
        Cylindrical { axis: self.axis, along, about, lumped: self.lumped }
    }
}

impl<T: Scalar, L, M> Cylindrical<T, L, M> {
    /// The axis, a unit vector in body axes.
    pub(crate) fn axis(&self) -> Vector3<T> {
        self.axis
    }

    /// Springs and dampers along the axis and about it.
    pub(crate) fn laws(&self) -> (&L, &M) {
        (&self.along, &self.about)
    }
}

impl<T: Scalar, L: SpringLaw<T>, M: SpringLaw<T>> Axial<T, 2> for Cylindrical<T, L, M> {
    type Coordinates = [T; 2];
    const WAYS: [Way; 2] = [Way::Slide, Way::Turn];
    const SLIDES: bool = true;
    const TURNS: bool = true;
    const LINEAR: bool = L::LINEAR && M::LINEAR;

    #[cfg_attr(optimised, inline(always))]
    fn relative(&self, inboard: &Turn<T>, [slide, angle]: [T; 2], [sliding, turning]: [T; 2]) -> Relative<T, 2> {
        let n = inboard.attitude.apply(self.axis);
        Relative {
            attitude: inboard.attitude.times(&about(self.axis, angle)),
            axes: [n, n],
            spin: n * turning,
            arm: n * slide,
            sliding: n * sliding,
            extra: zero(),
        }
    }
    #[inline(always)]
    fn force(&self, k: usize, position: T, rate: T) -> T {
        if k == 0 { self.along.force(position, rate) } else { self.about.force(position, rate) }
    }
    #[inline(always)]
    fn pivot(&self, k: usize, position: T, rate: T, springs: Implicit<T::Real>) -> T {
        if k == 0 { self.along.pivot(position, rate, springs) } else { self.about.pivot(position, rate, springs) }
    }
    fn energy(&self, [slide, angle]: [T; 2]) -> T {
        self.along.energy(slide) + self.about.energy(angle)
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
        self.along.check()?;
        self.about.check()
    }
}

lift!(Cylindrical<T, L, M> { axis, along, about, lumped });
