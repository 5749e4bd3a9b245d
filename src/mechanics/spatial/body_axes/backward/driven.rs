//! The costate sweep in body axes: hinges and slides that are driven.

use super::super::axis::{Armature, Axis, Bearing, Mode};
use super::super::relation::Local;
use super::super::turns::Offset;
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::ReversibleLaw;
use crate::driven::Driven;
use crate::driven::backward::{ReversibleMotion, driven};
use crate::element::Springs;
use crate::mechanics::spatial::adjoint::driven::oriented;
use crate::mechanics::spatial::adjoint::{Felt, Outboard, Pulled, Stirred};
use crate::mechanics::spatial::{Acceleration, Spatial, Turn, Wrench};
use crate::relation::{Additive, Closures};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};

macro_rules! axis {
    ([$($bounds:tt)*] $Joint:ty) => {
        driven!(Spatial, [$($bounds)*] $Joint, |joint, x, y, p, q| {
            drive: |outer, acceleration, gains| {
                let (stand, [swung, bias]) = <$Joint>::posture(x, y);
                let (relation, cuts) = <$Joint>::led(Local::of_own(&outer.relation), bias, acceleration, gains);
                joint.at_parent(relation.at_joint(M::TURNS, stand), cuts, (stand, swung)).full()
            },
            numbers: |sums| &mut sums.law,
            momentum: |pulled, met| if M::TURNS { pulled.angular.z } else { pulled.momentum.z },
        });
        oriented!([$($bounds)*] $Joint);
    };
}
axis!([M: Mode, O: Offset<T>, const PLACE: u8, L: ReversibleLaw<T>, A: Armature<T>, B: Bearing] Axis<T, M, O, PLACE, L, A, B>);
