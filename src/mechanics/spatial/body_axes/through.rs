//! Walks through robots that carry numbers from joint to joint and keep what they find in lists, in the order of the joints.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::link::Link;
use super::mount::BodyAxes;
use super::number::{Triangle, Triple};
use super::standing::Standing;
use super::turns::Offset;
use crate::mechanics::spatial::Spatial;
use crate::scalar::Scalar;
use crate::shape::{Of, Selective, Takes};
use crate::spring::SpringLaw;

/// What walks ask of a link.
pub trait Solid<T: Scalar>: Copy {
    /// m (kg).
    fn mass(&self) -> T;
    /// m r_C (kg·m).
    fn moment(&self) -> Triple<T>;
    /// J about the origin (kg·m²).
    fn tensor(&self) -> Triangle<T>;
    /// Force (N) and torque (N·m) that an angular velocity takes.
    fn gyroscopic(&self, spin: [T; 3]) -> [Triple<T>; 2];
    /// S p more than a force and torque.
    fn resisted(&self, p: [Triple<T>; 2], forces: [Triple<T>; 2]) -> [Triple<T>; 2];
}

/// A walk through a robot: what it does at a joint and at a link.
pub trait Through<T: Scalar>: Selective<Spatial<T>, Stores = ()> {
    /// Meets a joint.
    fn axis<A: Standing<T>>(&mut self, axis: &A, carried: Self::Carried) -> Self::Carried;
    /// Meets a link.
    fn link<B: Solid<T>>(&mut self, link: &B, carried: Self::Carried) -> Self::Carried;
}

impl<T, M, C, const PLACE: u8, L, A, B, W> Takes<Spatial<T>, W> for Axis<T, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<T>,
    L: SpringLaw<T>,
    A: Armature<T>,
    B: Bearing,
    W: Through<T>,
{
    #[inline(always)]
    fn take(&self, walk: &mut W, carried: W::Carried, (): Of<'_, Spatial<T>, W, Self>) -> W::Carried {
        walk.axis(self, carried)
    }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8, W: Through<T>> Takes<Spatial<T>, W> for Link<T, MOMENT, TENSOR> {
    #[inline(always)]
    fn take(&self, walk: &mut W, carried: W::Carried, (): Of<'_, Spatial<T>, W, Self>) -> W::Carried {
        walk.link(self, carried)
    }
}

impl<T: Scalar, W: Through<T>> Takes<Spatial<T>, W> for BodyAxes {
    #[inline(always)]
    fn take(&self, _: &mut W, carried: W::Carried, (): Of<'_, Spatial<T>, W, Self>) -> W::Carried {
        carried
    }
}

/// A walk through a robot, made of the plain walk and, where it goes inward, of what it does where an arm leaves.
macro_rules! through {
    ([$($generics:tt)*] $Walk:ty, $Carried:ty, inward, |$walk:ident, $carried:ident, $go:ident| $branch:expr) => {
        $crate::mechanics::spatial::body_axes::through::through!(@ [$($generics)*] $Walk, $Carried, {
            const OUTWARD: bool = false;
            type In<Y: $crate::shape::Way> = Self;

            #[inline(always)]
            fn branch(&mut self, $carried: $Carried, $go: impl FnOnce(&mut Self, $Carried) -> $Carried) -> $Carried {
                let $walk = self;
                $branch
            }
        });
    };
    ([$($generics:tt)*] $Walk:ty, $Carried:ty, outward) => {
        $crate::mechanics::spatial::body_axes::through::through!(@ [$($generics)*] $Walk, $Carried, {
            $crate::shape::alike_in_arms!();
        });
    };
    (@ [$($generics:tt)*] $Walk:ty, $Carried:ty, { $($items:tt)* }) => {
        impl<T: Scalar, $($generics)*> $crate::shape::Walk<$crate::mechanics::spatial::Spatial<T>> for $Walk {
            type Carried = $Carried;
            type Stores = ();
        }

        impl<T: Scalar, $($generics)*> $crate::shape::Selective<$crate::mechanics::spatial::Spatial<T>> for $Walk {
            $($items)*
        }
    };
}
pub(crate) use through;
