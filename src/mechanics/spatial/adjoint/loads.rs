//! The costate sweep in space: no loads on bodies, for which walks have nothing to do, and bodies and joints without a law.

use crate::adjoint::laws::ReversibleLaw;
use crate::mechanics::spatial::{Ball, PointMass, Revolute, RigidBody, Rod, Spatial, Weld, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::burden::Burden;
use crate::walks::strain::Strain;

macro_rules! unloaded {
    ($([$($L:ident)?] $Element:ty),*) => {$(
        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>)?> Takes<Spatial<T>, Burden<T, C>> for $Element {
            fn take(
                &self,
                _: &mut Burden<T, C>,
                outer: Wrench<T>,
                _: Of<'_, Spatial<T>, Burden<T, C>, Self>,
            ) -> Wrench<T> {
                outer
            }
        }
    )*};
}
unloaded!([] Rod<T>, [] RigidBody<T>, [] PointMass<T>, [] Ball, [] Weld<T>, [L] Revolute<T, L>);

/// What has no law.
macro_rules! lawless {
    ($($Element:ty),*) => {$(
        impl<T: Scalar> Takes<Spatial<T>, Strain> for $Element {
            #[inline(always)]
            fn take(&self, _: &mut Strain, (): (), _: Of<'_, Spatial<T>, Strain, Self>) {}
        }
    )*};
}
lawless!(Rod<T>, RigidBody<T>, PointMass<T>, Ball, Weld<T>);
