//! The costate sweep in the plane: joints that are driven.

use super::loads::Felt;
use super::{Outboard, Pulled, Stirred};
use crate::adjoint::BodyLaw;
use crate::driven::Driven;
use crate::driven::backward::{ReversibleMotion, driven};
use crate::element::Springs;
use crate::kinematics::Kinematics;
use crate::mechanics::planar::axes::{Axes, Inboard};
use crate::mechanics::planar::{Acceleration, Planar, Revolute, Slider, Wrench};
use crate::relation::planar::algebra::{add_scaled, dot};
use crate::relation::{Additive, Closures};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, PullBack, PullLoads, Reach, Stir, Strain};

driven!(Planar, [] Revolute, |joint, x, y, p, q| {
    drive: |outer, acceleration, gains| joint.drive::<C>(outer.relation, (x, y, p, q), acceleration, gains),
    numbers: |sums| sums,
    momentum: |pulled, met| pulled.angular,
});
driven!(Planar, [] Slider<T>, |joint, x, y, p, q| {
    drive: |outer, acceleration, gains| joint.drive::<C>(outer.relation, (x, y, p, q), acceleration, gains),
    numbers: |sums| &mut sums[2..],
    momentum: |pulled, met| {
        let line = Inboard::offset(x, y, p, q).direction;
        dot(line, add_scaled(pulled.momentum, joint.lumped, met.velocity))
    },
});
