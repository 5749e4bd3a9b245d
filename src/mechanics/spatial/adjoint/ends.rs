//! The costate sweep in space: tips.

use super::Outboard;
use crate::adjoint::{Holds, ReversibleTip};
use crate::mechanics::spatial::{Acceleration, Free, Spatial};
use crate::scalar::Scalar;

impl<T: Scalar> Holds<Spatial<T>> for Free {}

impl<T: Scalar> ReversibleTip<Spatial<T>> for Free {
    fn beyond(&self, _: &Acceleration<T>) -> Outboard<T> {
        Outboard::nothing()
    }
    fn columns(&self) {}
}
