//! The costate sweep in space: joints with modes.

use super::{Felt, Outboard, Pulled, Stirred};
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::ReversibleLaw;
use crate::element::Springs;
use crate::guarded::backward::guarded;
use crate::guarded::{Guard, Guarded};
use crate::kinematics::Kinematics;
use crate::mechanics::spatial::{Acceleration, Effort, Prismatic, Revolute, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Joint, Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};

/// An effort with a force along the coordinate.
pub(crate) fn under<T: Scalar>(effort: &Effort<T>, force: T) -> Effort<T> {
    let Effort([along, y, z]) = *effort;
    Effort([along + force, y, z])
}

macro_rules! axial {
    ($($Joint:ty),*) => {$(
        guarded!(Spatial, [] $Joint, |joint, axes, y, p, q| {
            drive: |outer, acceleration, gains| joint.drive::<C>(outer.relation, (axes, y, p, q), acceleration, gains),
            hold: |pivot| pivot.factor.set_number(T::zero()),
            under: |effort, force| under(effort, force),
            numbers: |sums| sums.law,
        });
        oriented!([] $Joint);
    )*};
}
/// Orientations as the costate sweep stores them.
macro_rules! oriented {
    ([$($bounds:tt)*] $Joint:ty) => {
        guarded!(@ Spatial, [$($bounds)*] $Joint, Orient, |guarded, walk, turn: Turn<T>, (position, rate, x, y, p, q)| {
            guarded.joint().take(walk, turn, (&position.coordinate, &rate.rate, x, y, p, q))
        });
    };
}
pub(crate) use oriented;

axial!(Revolute<T>, Prismatic<T>);
