//! The costate sweep in space: tips.

use crate::adjoint::ReversibleTip;
use crate::mechanics::spatial::{Free, Spatial};
use crate::scalar::Scalar;

impl<T: Scalar> ReversibleTip<Spatial<T>> for Free {
    fn columns(&self) {}
}
