//! The costate sweep in space: no loads on bodies and no implicit rules, for which these walks have nothing to do.

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

        impl<T: Scalar, $($L: ReversibleLaw<T>)?> Takes<Spatial<T>, Strain> for $Element {
            fn take(&self, _: &mut Strain, (): (), _: Of<'_, Spatial<T>, Strain, Self>) {}
        }

    )*};
}
unloaded!([] Rod<T>, [] RigidBody<T>, [] PointMass<T>, [] Ball, [] Weld<T>, [L] Revolute<T, L>);
