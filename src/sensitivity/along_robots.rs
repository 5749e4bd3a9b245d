//! Gradients of runs of robots, along whatever parameters a scene is made of.

use super::along::Along;
use super::along_in_space::{Numbered, turn};
use crate::lift::Lift;
use crate::mechanics::spatial::body_axes::backward::{joints, links, mounts};
use crate::mechanics::spatial::body_axes::{Armature, Axis, Bearing, BodyAxes, Flange, Link, Mode, Offset, Upright};
use crate::mechanics::spatial::{Base, OfJoint, Spatial};
use crate::scalar::{Jet, Scalar};
use crate::shape::{Of, Takes};
use crate::spring::SpringLaw;

impl<T: Scalar, const K: usize, const MOMENT: u8, const TENSOR: u8> Takes<Spatial<Jet<T, K>>, Along<T, K>>
    for Link<Jet<T, K>, MOMENT, TENSOR>
{
    fn take(&self, walk: &mut Along<T, K>, (): (), (by, read, ()): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        let Base { moment, inertia, lumped, .. } = links::base(self);
        read.iter().zip(links::numbers(self)).for_each(|(by, x)| walk.add(*by, x));
        by.moment.iter().zip(moment).for_each(|(by, x)| walk.add(*by, x));
        by.inertia.iter().zip(inertia).for_each(|(by, x)| walk.add(*by, x));
        walk.add(by.lumped, lumped);
        walk.met += 1;
    }
}

impl<T, M, C, const PLACE: u8, L, A, B, const K: usize> Numbered<T, K> for Axis<Jet<T, K>, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<Jet<T, K>>,
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    A: Armature<Jet<T, K>>,
    B: Bearing,
{
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        let (axes, ahead, place, inertia, law) = joints::parts(self);
        walk.add_vector(by.turn, turn(&axes));
        walk.add(by.turn.z, ahead);
        walk.add_vector(by.place, place);
        walk.add(by.more[0], inertia);
        walk.add_joint(law, &by.law);
    }
}

impl<T, M, C, const PLACE: u8, L, A, B, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>>
    for Axis<Jet<T, K>, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<Jet<T, K>>,
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    A: Armature<Jet<T, K>>,
    B: Bearing,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        self.add_to(walk, by);
    }
}

impl<T: Scalar, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>> for Flange<Jet<T, K>> {
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        let (place, lumped) = mounts::parts(self);
        walk.add_vector(by.place, place);
        walk.add(by.more[0], lumped);
        walk.met += 1;
    }
}

macro_rules! mounts {
    ($($Mount:ident),*) => {$(
        impl<T: Scalar, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>> for $Mount {
            fn take(&self, walk: &mut Along<T, K>, (): (), _: Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
                walk.met += 1;
            }
        }
    )*};
}
mounts!(BodyAxes, Upright);
