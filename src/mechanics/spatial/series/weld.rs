//! Taylor series in space: what a weld does. It hands on what it is given, in inertial axes.

use crate::mechanics::spatial::{Acceleration, Internal, Spatial, Weld};
use crate::relation::Part;
use crate::relation::spatial::Full;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

macro_rules! welded {
    ($([$($Q:ident)?] $Walk:ty: $Carried:ty),*) => {$(
        impl<T: Scalar, $($Q: Part,)? const N: usize> Takes<Spatial<T>, $Walk> for Weld<T> {
            #[inline(always)]
            fn take(&self, _: &mut $Walk, carried: $Carried, _: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                carried
            }
        }
    )*};
}
welded!(
    [] Begin<N>: Vector3<T>,
    [] Articulate<Spatial<T>, N>: Full<T>,
    [Q] Push<Spatial<T>, Q, N>: Internal<T>,
    [] Swing<Spatial<T>, N>: Acceleration<T>
);
