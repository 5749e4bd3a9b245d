//! Taylor series in the plane: what holds tips.

use crate::adjoint::ReversibleTip;
use crate::ends::{ExpandTip, Tip};
use crate::mechanics::planar::{Clamped, Free, Guided, Internal, Pinned, Planar};
use crate::relation::Closures;
use crate::scalar::Scalar;

/// Forces act ON the last body: F on the ground beyond it is the opposite.
macro_rules! held {
    ($($Tip:ty),*) => {$(
        impl<T: Scalar> ExpandTip<Planar<T>> for $Tip {
            fn columns(&self) -> <<Self as Tip<Planar<T>>>::Closures as Closures>::Each<Internal<T>> {
                <Self as Tip<Planar<T>>>::Closures::map(&ReversibleTip::<Planar<T>>::columns(self), |wrench: Internal<T>| -wrench)
            }
        }
    )*};
}
held!(Free, Pinned<[T; 2]>, Clamped<[T; 2], T>, Guided<[T; 2], T, T>);
