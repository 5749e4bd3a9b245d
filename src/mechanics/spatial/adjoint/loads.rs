//! The costate sweep in space: no loads on bodies and no implicit rules, for which these walks have nothing to do.

use crate::adjoint::laws::ReversibleLaw;
use crate::mechanics::spatial::{Ball, PointMass, Revolute, RigidBody, Rod, Spatial, Weld, Wrench};
use crate::relation::Absent;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::burden::Burden;
use crate::walks::pull_loads::PullLoads;
use crate::walks::strain::Strain;

macro_rules! unloaded {
    ($([$($L:ident)?] $Element:ty),*) => {$(
        impl<T: Scalar, $($L: ReversibleLaw<T>)?> Takes<Spatial<T>, Burden<T>> for $Element {
            fn take(&self, _: &mut Burden<T>, outer: Wrench<T>, _: Of<'_, Spatial<T>, Burden<T>, Self>) -> Wrench<T> {
                outer
            }
        }

        impl<T: Scalar, $($L: ReversibleLaw<T>)?> Takes<Spatial<T>, Strain> for $Element {
            fn take(&self, _: &mut Strain, (): (), _: Of<'_, Spatial<T>, Strain, Self>) {}
        }

        impl<T: Scalar, $($L: ReversibleLaw<T>)?> Takes<Spatial<T>, PullLoads<Absent, T>> for $Element {
            fn take(
                &self,
                _: &mut PullLoads<Absent, T>,
                outer: Absent,
                _: Of<'_, Spatial<T>, PullLoads<Absent, T>, Self>,
            ) -> Absent {
                outer
            }
        }
    )*};
}
unloaded!([] Rod<T>, [] RigidBody<T>, [] PointMass<T>, [] Ball, [] Weld<T>, [L] Revolute<T, L>);
