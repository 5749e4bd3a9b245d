//! Kinematics of joints with one coordinate in the plane: a relative angle, a line.

use super::axes::Axes;
use super::{JointMotion, Planar, Revolute, Slider, SpringState, Turn};
use crate::kinematics::{Acting, Driving, Kinematics, Outboard};
use crate::mechanics::planar::Joint;
use crate::relation::planar::{Full, RelativeGain, Rigid};
use crate::relation::{Closures, Term};
use crate::scalar::Scalar;
use crate::shape::JointPosture;

impl<T: Scalar, R: Rigid<T>> Outboard<Planar<T>> for R {
    type Closures = R::Closures;
    #[inline(always)]
    fn whole(self) -> Full<T, R::Closures> {
        self.full()
    }
}

impl<T: Scalar, M: Term<T>> Driving<Planar<T>> for M {
    #[inline(always)]
    fn onto(self, sum: T) -> T {
        self.add_to(sum)
    }
}

/// Kinematics of joints: what differs is the elimination, and where the force of a model is read.
macro_rules! kinematics {
    ($($Joint:ty { $eliminate:expr, $drive:expr, $spring:expr })*) => {$(
        impl<T: Scalar> Kinematics<Planar<T>> for $Joint {
            fn lump(&mut self, mass: T) -> T {
                Joint::lump(self, mass)
            }
            #[inline(always)]
            fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
                Joint::turned(self, position, rate, inboard)
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                position: &T,
                rate: &T,
                inboard: Turn<T>,
                x: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                y: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                p: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                q: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
            ) -> Turn<T> {
                Joint::orient(self, position, rate, inboard, x, y, p, q)
            }
            #[cfg_attr(optimised, inline(always))]
            fn resolve(
                x: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                y: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                p: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
                q: &mut <<Self as Joint<T>>::Axes as Axes>::Per<T>,
            ) {
                <Self as Joint<T>>::Axes::resolve::<T>(x, y, p, q);
            }
            #[cfg_attr(optimised, inline(always))]
            fn eliminate<C: Closures>(
                &self,
                outer: Full<T, C>,
                (x, y, p, q): JointPosture<'_, Planar<T>, Self>,
                force: T,
                resistance: T,
                kept: &mut <Self as Joint<T>>::Kept<C>,
            ) -> Full<T, C> {
                let offset = <Self as Joint<T>>::Axes::offset::<T>(x, y, p, q);
                $eliminate(self, outer, offset, force, resistance, kept)
            }
            #[cfg_attr(optimised, inline(always))]
            fn drive<C: Closures>(
                &self,
                outer: Full<T, C>,
                (x, y, p, q): JointPosture<'_, Planar<T>, Self>,
                acceleration: T,
                kept: &mut <Self as Joint<T>>::Kept<C>,
            ) -> Full<T, C> {
                let offset = <Self as Joint<T>>::Axes::offset::<T>(x, y, p, q);
                *kept = <Self as Joint<T>>::kept::<C>();
                (kept.per_angular, kept.free) = (T::zero(), acceleration);
                $drive(self, outer, offset, acceleration)
            }
            fn under(motion: JointMotion<T>, Acting { resistance, energy, inertia }: Acting<T>) -> JointMotion<T> {
                let (torque, force) = $spring(resistance.force);
                JointMotion { spring: SpringState { torque, force, energy }, inertia, ..motion }
            }
        }
    )*};
}
kinematics! {
    Revolute {
        |_: &Self, outer: Full<T, C>, (), force, resistance, kept: &mut RelativeGain<T, C>| {
            let (relation, gain) = outer.hinged(force, resistance);
            *kept = gain;
            relation
        },
        |_: &Self, outer: Full<T, C>, (), acceleration| outer.turning(acceleration),
        |torque| (torque, [T::zero(); 2])
    }
    Slider<T> { Slider::loosen, Slider::carry, |force| (T::zero(), [force, T::zero()]) }
}
