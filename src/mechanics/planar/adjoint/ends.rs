//! The costate sweep in the plane: ends.

use crate::adjoint::{Reversed, ReversibleRoot, ReversibleTip};
use crate::chain::Named;
use crate::mechanics::planar::{Clamped, Free, Pinned, Planar};
use crate::scalar::Scalar;

impl<T: Scalar> ReversibleRoot<Planar<T>> for Pinned<[T; 2]> {}
impl<T: Scalar> ReversibleRoot<Planar<T>> for Clamped<[T; 2], T> {}
impl<S: Reversed, R: ReversibleRoot<S>> ReversibleRoot<S> for Named<R> {}
impl<T: Scalar> ReversibleTip<Planar<T>> for Free {}
