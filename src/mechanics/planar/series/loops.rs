//! Taylor series in the plane: joints that close loops.

use crate::mechanics::planar::loops::{holds, pulls};
use crate::mechanics::planar::{Internal, Pin, Planar, Weld};
use crate::relation::{Term, Wrench};
use crate::scalar::Scalar;
use crate::series::{ExertClosing, ExpandClosing};
use nalgebra::Vector2;

impl<T: Scalar> ExpandClosing<Planar<T>> for Pin {
    #[inline(always)]
    fn columns(&self) -> [Internal<T>; 2] {
        pulls(-T::one()).map(Wrench::of_force)
    }
}

impl<T: Scalar, Q: Term<T>> ExertClosing<Planar<T>, Q> for Pin {
    #[inline(always)]
    fn exerted(&self, effort: Q) -> Internal<T> {
        let zero = T::zero();
        Internal { force: Vector2::new(zero, zero), torque: effort.add_to(zero) }
    }
}

impl<T: Scalar> ExpandClosing<Planar<T>> for Weld<T> {
    #[inline(always)]
    fn columns(&self) -> [Internal<T>; 3] {
        holds(-T::one())
    }
}

/// A torque in a weld does nothing.
impl<T: Scalar, Q> ExertClosing<Planar<T>, Q> for Weld<T> {
    #[inline(always)]
    fn exerted(&self, _: Q) -> Internal<T> {
        Internal::none()
    }
}
