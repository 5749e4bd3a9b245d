//! The costate sweep in the plane: joints with modes.

use super::loads::Felt;
use super::{Outboard, Pulled, Stirred};
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::ReversibleLaw;
use crate::element::Springs;
use crate::guarded::backward::guarded;
use crate::guarded::{Guard, Guarded};
use crate::kinematics::Kinematics;
use crate::mechanics::planar::{Acceleration, Planar, Revolute, Slider, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Joint, Of, Takes};
use crate::walks::{Burden, Factor, Meet, PullBack, PullLoads, Reach, Stir, Strain};

guarded!(Planar, [] Revolute, |joint, x, y, p, q| {
    drive: |outer, acceleration, gains| joint.drive::<C>(outer.relation, (x, y, p, q), acceleration, gains),
    hold: |pivot| *pivot = T::zero(),
    under: |torque, force| *torque + force,
    numbers: |sums| sums,
});
guarded!(Planar, [] Slider<T>, |joint, x, y, p, q| {
    drive: |outer, acceleration, gains| joint.drive::<C>(outer.relation, (x, y, p, q), acceleration, gains),
    hold: |pivot| *pivot = T::zero(),
    under: |torque, force| *torque + force,
    numbers: |sums| sums[2..],
});
