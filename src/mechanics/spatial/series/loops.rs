//! Taylor series in space: joints that close loops by forces and torques whose directions rest.

use crate::mechanics::spatial::loops::{holds, pulls};
use crate::mechanics::spatial::{Ball, Internal, Spatial, Weld};
use crate::relation::{Absent, Wrench};
use crate::scalar::Scalar;
use crate::series::{ExertClosing, ExpandClosing};

impl<T: Scalar> ExpandClosing<Spatial<T>> for Ball {
    #[inline(always)]
    fn columns(&self) -> [Internal<T>; 3] {
        pulls(-T::one()).map(Wrench::of_force)
    }
}

/// A torque in a ball turns with the main arm, of whose attitude the walk does not know.
impl<T: Scalar> ExertClosing<Spatial<T>, Absent> for Ball {
    #[inline(always)]
    fn exerted(&self, _: Absent) -> Internal<T> {
        Internal::none()
    }
}

impl<T: Scalar> ExpandClosing<Spatial<T>> for Weld<T> {
    #[inline(always)]
    fn columns(&self) -> [Internal<T>; 6] {
        let axes = pulls(T::one());
        holds(-T::one(), |k| axes[k])
    }
}

/// A torque in a weld does nothing.
impl<T: Scalar, Q> ExertClosing<Spatial<T>, Q> for Weld<T> {
    #[inline(always)]
    fn exerted(&self, _: Q) -> Internal<T> {
        Internal::none()
    }
}
