//! The costate sweep in space: joints that are driven.

use super::{Felt, Outboard, Pulled, Stirred};
use crate::adjoint::BodyLaw;
use crate::driven::Driven;
use crate::driven::backward::{ReversibleMotion, driven};
use crate::element::Springs;
use crate::kinematics::Kinematics;
use crate::mechanics::spatial::axial::Axial;
use crate::mechanics::spatial::{Acceleration, Prismatic, Revolute, Spatial, Turn, Wrench};
use crate::relation::spatial::algebra::{add_scaled, dot};
use crate::relation::{Additive, Closures};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};

macro_rules! axial {
    ($Joint:ty, |$joint:ident, $axis:ident, $pulled:ident, $met:ident| $momentum:expr) => {
        driven!(Spatial, [] $Joint, |$joint, axes, y, p, q| {
            drive: |outer, acceleration, gains| $joint.drive::<C>(outer.relation, (axes, y, p, q), acceleration, gains),
            numbers: |sums| &mut sums.law,
            momentum: |$pulled, $met| {
                let $axis = axes.x;
                $momentum
            },
        });
        oriented!([] $Joint);
    };
}
/// Orientations as the costate sweep stores them.
macro_rules! oriented {
    ([$($bounds:tt)*] $Joint:ty) => {
        driven!(@ Spatial, [$($bounds)*] $Joint, Orient, |driven, walk, turn: Turn<T>, (clock, _, x, y, p, q)| {
            let [position, rate, _] = driven.told(clock);
            driven.joint().take(walk, turn, (&position, &rate, x, y, p, q))
        });
    };
}
pub(crate) use oriented;

axial!(Revolute<T>, |joint, axis, pulled, met| dot(axis, pulled.angular));
axial!(Prismatic<T>, |joint, axis, pulled, met| dot(axis, add_scaled(pulled.momentum, joint.lumped(), met.velocity)));
