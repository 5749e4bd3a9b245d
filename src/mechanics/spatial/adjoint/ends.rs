//! The costate sweep in space: ends.

use crate::adjoint::{ReversibleRoot, ReversibleTip};
use crate::mechanics::spatial::{Clamped, Free, Hinged, Pinned, Rotation, Spatial};
use crate::scalar::Scalar;

impl<T: Scalar> ReversibleRoot<Spatial<T>> for Pinned<[T; 3]> {}
impl<T: Scalar> ReversibleRoot<Spatial<T>> for Clamped<[T; 3], Rotation<T>> {}
impl<T: Scalar> ReversibleRoot<Spatial<T>> for Hinged<[T; 3], Rotation<T>, T> {}
impl<T: Scalar> ReversibleTip<Spatial<T>> for Free {
    fn columns(&self) {}
}
