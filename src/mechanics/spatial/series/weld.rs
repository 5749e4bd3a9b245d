//! Taylor series in space: what a weld does. It hands on what it is given, in inertial axes.

use super::Swung;
use crate::mechanics::spatial::{Internal, Spatial, Weld};
use crate::relation::Closures;
use crate::relation::spatial::Full;
use crate::scalar::Scalar;
use crate::series::ExpandLoads;
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Begin<N>> for Weld<T> {
    #[inline(always)]
    fn take(&self, _: &mut Begin<N>, spin: Vector3<T>, _: Of<'_, Spatial<T>, Begin<N>, Self>) -> Vector3<T> {
        spin
    }
}

macro_rules! welded {
    ($([$($A:ident)?] $Walk:ty: $Carried:ty),*) => {$(
        impl<T: Scalar, $($A: ExpandLoads<Spatial<T>, N>,)? C: Closures, const N: usize> Takes<Spatial<T>, $Walk> for Weld<T> {
            #[inline(always)]
            fn take(&self, _: &mut $Walk, carried: $Carried, _: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                carried
            }
        }
    )*};
}
welded!(
    [] Articulate<Spatial<T>, N, C>: Full<T>,
    [A] Push<Spatial<T>, A, N, C>: Internal<T>,
    [A] Swing<Spatial<T>, A, N, C>: Swung<T>
);
