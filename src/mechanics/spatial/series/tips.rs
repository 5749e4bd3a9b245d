//! Taylor series in space: what holds tips, by forces and torques whose directions rest with the ground.

use crate::adjoint::ReversibleTip;
use crate::ends::{ExpandTip, Tip};
use crate::mechanics::spatial::{Clamped, Free, Hinged, Internal, Pinned, Rotation, Spatial};
use crate::relation::Closures;
use crate::scalar::Scalar;

/// Forces act ON the last body: F on the ground beyond it is the opposite.
macro_rules! held {
    ($($Tip:ty),*) => {$(
        impl<T: Scalar> ExpandTip<Spatial<T>> for $Tip {
            fn columns(&self) -> <<Self as Tip<Spatial<T>>>::Closures as Closures>::Each<Internal<T>> {
                <Self as Tip<Spatial<T>>>::Closures::map(&ReversibleTip::<Spatial<T>>::columns(self), |wrench: Internal<T>| -wrench)
            }
        }
    )*};
}
held!(Free, Pinned<[T; 3]>, Clamped<[T; 3], Rotation<T>>, Hinged<[T; 3], Rotation<T>, T>);
