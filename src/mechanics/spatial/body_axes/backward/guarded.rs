//! The costate sweep in body axes: hinges and slides with modes.

use super::super::axis::{Armature, Axis, Bearing, Mode};
use super::super::relation::Local;
use super::super::turns::Offset;
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::ReversibleLaw;
use crate::element::Springs;
use crate::guarded::backward::guarded;
use crate::guarded::{Guard, Guarded};
use crate::mechanics::spatial::adjoint::guarded::{oriented, under};
use crate::mechanics::spatial::adjoint::{Felt, Outboard, Pulled, Stirred};
use crate::mechanics::spatial::{Acceleration, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Joint, Of, Takes};
use crate::spring::Spring;
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};

macro_rules! axis {
    ([$($bounds:tt)*] $Joint:ty) => {
        guarded!(Spatial, [$($bounds)*] $Joint, |joint, x, y, p, q| {
            drive: |outer, acceleration, gains| {
                let (stand, [swung, bias]) = <$Joint>::posture(x, y);
                let (relation, cuts) = <$Joint>::led(Local::of_own(&outer.relation), bias, acceleration, gains);
                joint.at_parent(relation.at_joint(M::TURNS, stand), cuts, (stand, swung)).full()
            },
            hold: |pivot| pivot.factor.set_number(T::zero()),
            under: |effort, force| under(effort, force),
            numbers: |sums| sums.law,
        });
        oriented!([$($bounds)*] $Joint);
    };
}
axis!([M: Mode, O: Offset<T>, const PLACE: u8, A: Armature<T>, B: Bearing] Axis<T, M, O, PLACE, Spring, A, B>);
