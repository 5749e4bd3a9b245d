//! The universal joint.

use super::Turn;
use super::axial::{Axial, Relative, check_axis, unit};
use super::maps::about;
use crate::element::Implicit;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{cross, dot, zero};
use crate::scalar::{Real, Scalar};
use crate::spring::{Spring, SpringLaw};
use nalgebra::Vector3;

/// Two bodies share a point, and turn about two axes: the first fixed to the inboard body, the second to the outboard one.
///
/// Its coordinates are the angles (rad) about these, zero where the axes of both bodies coincide.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector3<T>: serde::Serialize, L: serde::Serialize, M: serde::Serialize",
        deserialize = "Vector3<T>: serde::Deserialize<'de>, L: serde::Deserialize<'de>, M: serde::Deserialize<'de>"
    ))
)]
pub struct Universal<T, L = Spring, M = Spring> {
    axes: [Vector3<T>; 2],
    first: L,
    second: M,
}

impl<T: Scalar> Universal<T> {
    /// About two axes in body axes, of any length, that are not parallel.
    pub fn about(first: [T; 3], second: [T; 3]) -> Self {
        Self { axes: [unit(first), unit(second)], first: Spring::none(), second: Spring::none() }
    }

    /// With springs and dampers about the first and the second axis.
    pub fn with<L: SpringLaw<T>, M: SpringLaw<T>>(self, first: L, second: M) -> Universal<T, L, M> {
        Universal { axes: self.axes, first, second }
    }
}

impl<T: Scalar, L, M> Universal<T, L, M> {
    /// The axes, unit vectors in body axes.
    pub(crate) fn axes(&self) -> [Vector3<T>; 2] {
        self.axes
    }

    /// Springs and dampers about the first and the second axis.
    pub(crate) fn laws(&self) -> (&L, &M) {
        (&self.first, &self.second)
    }
}

impl<T: Scalar, L: SpringLaw<T>, M: SpringLaw<T>> Axial<T, 2> for Universal<T, L, M> {
    type Coordinates = [T; 2];
    const WAYS: [Way; 2] = [Way::Turn, Way::Turn];
    const SLIDES: bool = false;
    const TURNS: bool = true;
    const LINEAR: bool = L::LINEAR && M::LINEAR;

    #[cfg_attr(optimised, inline(always))]
    fn relative(&self, inboard: &Turn<T>, [one, two]: [T; 2], [first, second]: [T; 2]) -> Relative<T, 2> {
        let between = inboard.attitude.times(&about(self.axes[0], one));
        // The first turn leaves its own axis where it was.
        let axes = self.axes.map(|axis| between.apply(axis));
        let (own, other) = (axes[0] * first, axes[1] * second);
        Relative {
            attitude: between.times(&about(self.axes[1], two)),
            axes,
            spin: own + other,
            arm: zero(),
            sliding: zero(),
            extra: cross(own, other), // the second axis turns with the first
        }
    }
    #[inline(always)]
    fn force(&self, k: usize, position: T, rate: T) -> T {
        if k == 0 { self.first.force(position, rate) } else { self.second.force(position, rate) }
    }
    #[inline(always)]
    fn pivot(&self, k: usize, position: T, rate: T, springs: Implicit<T::Real>) -> T {
        if k == 0 { self.first.pivot(position, rate, springs) } else { self.second.pivot(position, rate, springs) }
    }
    fn energy(&self, [one, two]: [T; 2]) -> T {
        self.first.energy(one) + self.second.energy(two)
    }
    fn verify(&self) -> Result<(), Fault> {
        self.axes.into_iter().try_for_each(check_axis)?;
        let normal = cross(self.axes[0], self.axes[1]);
        let short = T::constant(T::Real::EPSILON) - dot(normal, normal);
        if short.if_negative(T::zero(), T::one()).real() > T::Real::of(0.0) {
            return Err(Fault::ParallelAxes);
        }
        self.first.check()?;
        self.second.check()
    }
}

lift!(Universal<T, L, M> { axes, first, second });
