//! Kinematics of joints with one coordinate in space: an angle about an axis, a slide along one.

use super::axial::Axial;
use super::axial_walks::{carried, loosened};
use super::{Drive, Joint, JointMotion, Prismatic, Revolute, Spatial, Turn};
use crate::kinematics::{Acting, Driving, Kinematics, Outboard};
use crate::relation::Closures;
use crate::relation::spatial::algebra::Columns;
use crate::relation::spatial::{Full, Pivot, Rigid};
use crate::scalar::Scalar;
use crate::shape::JointPosture;
use nalgebra::Vector3;

impl<T: Scalar, R: Rigid<T>> Outboard<Spatial<T>> for R {
    type Closures = R::Closures;
    #[inline(always)]
    fn whole(self) -> Full<T, R::Closures> {
        self.full()
    }
}

impl<T: Scalar, D: Drive<T>> Driving<Spatial<T>> for D {
    #[inline(always)]
    fn onto(self, sum: T) -> T {
        Drive::onto(self, 0, sum)
    }
}

/// Kinematics of joints that turn about an axis or slide along one.
macro_rules! kinematics {
    ($($Joint:ident),*) => {$(
        impl<T: Scalar> Kinematics<Spatial<T>> for $Joint<T> {
            fn lump(&mut self, mass: T) -> T {
                Axial::lump(self, mass)
            }
            #[inline(always)]
            fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
                self.oriented(position, rate, inboard).0
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                position: &T,
                rate: &T,
                inboard: Turn<T>,
                x: &mut Columns<T>,
                y: &mut [Vector3<T>; 2],
                _: &mut Vector3<T>,
                _: &mut Vector3<T>,
            ) -> Turn<T> {
                let (outboard, stored) = self.oriented(position, rate, inboard);
                <Self as Joint<T>>::store(stored, x, y);
                outboard
            }
            #[inline(always)]
            fn resolve(_: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
            #[cfg_attr(optimised, inline(always))]
            fn eliminate<C: Closures>(
                &self,
                outer: Full<T, C>,
                posture: JointPosture<'_, Spatial<T>, Self>,
                force: T,
                resistance: T,
                kept: &mut [Pivot<T, C>; 1],
            ) -> Full<T, C> {
                loosened(self, outer, (posture.0, posture.1), |_| (force, resistance), kept)
            }
            #[cfg_attr(optimised, inline(always))]
            fn drive<C: Closures>(
                &self,
                outer: Full<T, C>,
                posture: JointPosture<'_, Spatial<T>, Self>,
                acceleration: T,
                kept: &mut [Pivot<T, C>; 1],
            ) -> Full<T, C> {
                *kept = [Pivot { free: acceleration, ..Pivot::blank() }];
                carried(self, outer, (posture.0, posture.1), acceleration)
            }
            fn under(motion: JointMotion<T>, acting: Acting<T>) -> JointMotion<T> {
                let Acting { resistance, energy, inertia } = acting;
                let only = |x| [x, T::zero(), T::zero()];
                JointMotion { effort: only(resistance.force), energy, inertia: only(inertia), ..motion }
            }
        }
    )*};
}
kinematics!(Revolute, Prismatic);
