//! Motion of joints that turn about axes or slide along them.
//!
//! p_O = X p_I + c + Φ q̈ with X = [[1, −d~], [0, 1]], Φ one column (0, n) or (n, 0) for each coordinate, and
//! c = (ω × (ω × d) + 2 ω × ḋ, ω × ω_rel + …), ω that of the inboard body.

use super::axial::{Axial, Listed, Relative};
use super::stored::Stored;
use super::{Acceleration, Frame, JointMotion, Turn};
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{Columns, add_scaled, centripetal, cross, cross_onto, zero};
use crate::scalar::Scalar;
use nalgebra::Vector3;

#[cfg_attr(optimised, inline(always))]
pub(super) fn oriented<T: Scalar, J: Axial<T, K>, const K: usize>(
    joint: &J,
    position: &J::Coordinates,
    rate: &J::Coordinates,
    inboard: Turn<T>,
) -> (Turn<T>, Stored<T>) {
    let relative = joint.relative(&inboard, position.list(), rate.list());
    let bias = [linear_bias::<T, J, K>(&inboard, &relative), angular_bias::<T, J, K>(&inboard, &relative)];
    let axis = |k: usize| if k < K { relative.axes[k] } else { zero() };
    let stored = (Columns { x: axis(0), y: axis(1), z: relative.arm }, bias);
    (outboard::<T, J, K>(inboard, &relative), stored)
}

#[inline(always)]
fn outboard<T: Scalar, J: Axial<T, K>, const K: usize>(inboard: Turn<T>, relative: &Relative<T, K>) -> Turn<T> {
    let spin = if J::TURNS { inboard.spin + relative.spin } else { inboard.spin };
    Turn { attitude: relative.attitude, spin }
}

#[cfg_attr(optimised, inline(always))]
pub(super) fn linear_bias<T: Scalar, J: Axial<T, K>, const K: usize>(
    inboard: &Turn<T>,
    relative: &Relative<T, K>,
) -> Vector3<T> {
    if J::SLIDES {
        let twice = relative.sliding + relative.sliding;
        cross_onto(inboard.spin, twice, centripetal(inboard.spin, relative.arm))
    } else {
        zero()
    }
}

#[cfg_attr(optimised, inline(always))]
pub(super) fn angular_bias<T: Scalar, J: Axial<T, K>, const K: usize>(
    inboard: &Turn<T>,
    relative: &Relative<T, K>,
) -> Vector3<T> {
    if !J::TURNS {
        zero()
    } else if K == 1 {
        cross(inboard.spin, relative.spin)
    } else {
        cross_onto(inboard.spin, relative.spin, relative.extra)
    }
}

#[cfg_attr(optimised, inline(always))]
pub(super) fn moved<T: Scalar, J: Axial<T, K>, const K: usize>(
    joint: &J,
    inboard: Frame<T>,
    position: &J::Coordinates,
    rate: &J::Coordinates,
    acceleration: &J::Coordinates,
) -> JointMotion<T> {
    let turn = inboard.turn;
    let relative = joint.relative(&turn, position.list(), rate.list());
    let Relative { axes, arm, sliding, .. } = relative;
    let mut moved = inboard.acceleration.shifted(arm, linear_bias::<T, J, K>(&turn, &relative));
    moved.angular += angular_bias::<T, J, K>(&turn, &relative);
    for (k, second) in acceleration.list().into_iter().enumerate() {
        moved = pushed(moved, J::WAYS[k], axes[k], second);
    }
    let outboard = Frame {
        place: inboard.place + arm,
        velocity: cross_onto(turn.spin, arm, inboard.velocity + sliding),
        turn: outboard::<T, J, K>(turn, &relative),
        acceleration: moved,
    };
    let padded = |list: [T; K]| core::array::from_fn(|k| if k < K { list[k] } else { T::zero() });
    let energy = joint.energy(position.list());
    let (position, rate) = (position.list(), rate.list());
    let effort = padded(core::array::from_fn(|k| joint.force(k, position[k], rate[k])));
    JointMotion {
        inboard,
        outboard,
        position: padded(position),
        rate: padded(rate),
        effort,
        energy,
        inertia: [T::zero(); 3],
    }
}

/// An acceleration with a coordinate's added.
#[cfg_attr(optimised, inline(always))]
pub(super) fn pushed<T: Scalar>(p: Acceleration<T>, way: Way, n: Vector3<T>, second: T) -> Acceleration<T> {
    match way {
        Way::Turn => Acceleration { angular: add_scaled(p.angular, second, n), ..p },
        Way::Slide => Acceleration { linear: add_scaled(p.linear, second, n), ..p },
    }
}
