//! What joints let move, for their transfer matrices.

use super::axial::{Axial, Listed};
use super::axial_motion::{angular_bias, linear_bias};
use super::rotary_spring::RotaryLaw;
use super::{Ball, ElasticHinge, Floating, JointMotion, Linear, Rotation, Spatial, Weld};
use crate::relation::spatial::algebra::{Columns, centripetal, cross, cross_onto, dot};
use crate::release::{Freedom, Resistance, Way, slopes};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// What a joint in space lets move.
pub type Release<T> = crate::release::Release<Spatial<T>>;

/// With turns about the axes of a body, against a law.
fn turning<T: Scalar>(release: Release<T>, axes: &Columns<T>, turns: [Turning<T>; 3]) -> Release<T> {
    let axes = [axes.x, axes.y, axes.z].into_iter().zip(turns);
    axes.fold(release, |release, (axis, (resistance, preload, linear))| {
        release.with(Freedom { linear, ..Freedom::smooth(Way::Turn, axis).against(resistance, preload) })
    })
}

/// What resists a turn, its preload, and whether it is linear.
type Turning<T> = (Resistance<T>, T, bool);

/// Nothing.
fn freely<T: Scalar>() -> [Turning<T>; 3] {
    [(Resistance::none(), T::zero(), true); 3]
}

/// A rotary law along the axes of the outboard body.
fn resisting<T: Scalar, R: RotaryLaw<T>>(law: &R, position: &Rotation<T>, rate: &[T; 3]) -> [Turning<T>; 3] {
    let (force, unturned) = (law.torque(position, rate), law.torque(&Rotation::identity(), &[T::zero(); 3]));
    let Columns { x, y, z } = position.matrix();
    let [stiffness, damping] = slopes::<T, _>(|springs| law.pivot(position, rate, springs));
    let along = [x, y, z].map(|axis| [stiffness, damping].map(|slope| dot(axis, slope.apply(axis))));
    core::array::from_fn(|k| {
        let [stiffness, damping] = along[k];
        (Resistance { force: force[k], stiffness, damping }, unturned[k], R::LINEAR)
    })
}

/// A coordinate that slides along an axis against a law.
fn sliding<T: Scalar>(axis: Vector3<T>, law: &impl SpringLaw<T>, position: T, rate: T) -> Freedom<Spatial<T>> {
    Freedom::smooth(Way::Slide, axis).undriven().sprung(law, [position, rate])
}

pub(super) fn weld<T: Scalar>(_: &Weld<T>, _: &JointMotion<T>, (): &(), (): &()) -> Release<T> {
    Release::nothing()
}

pub(super) fn ball<T: Scalar>(_: &Ball, motion: &JointMotion<T>, _: &Rotation<T>, _: &[T; 3]) -> Release<T> {
    let free = Release { carries: false, ..Release::nothing() };
    turning(free, &motion.outboard.turn.attitude, freely())
}

pub(super) fn rotary<T: Scalar, R: RotaryLaw<T>>(
    joint: &ElasticHinge<R>,
    motion: &JointMotion<T>,
    position: &Rotation<T>,
    rate: &[T; 3],
) -> Release<T> {
    let (inner, outer) = (motion.inboard.turn, motion.outboard.turn);
    let angular = cross(inner.spin, outer.spin - inner.spin);
    let release = Release { angular, ..Release::nothing() };
    turning(release, &outer.attitude, resisting(&joint.rotary, position, rate))
}

pub(super) fn elastic<T: Scalar, R: RotaryLaw<T>, X: SpringLaw<T>, Y: SpringLaw<T>, Z: SpringLaw<T>>(
    joint: &ElasticHinge<R, Linear<T, X, Y, Z>>,
    motion: &JointMotion<T>,
    (place, turn): &([T; 3], Rotation<T>),
    (moving, rate): &([T; 3], [T; 3]),
) -> Release<T> {
    let (inner, outer) = (motion.inboard.turn, motion.outboard.turn);
    let (arm, velocity) = (inner.attitude.apply(Vector3::from(*place)), inner.attitude.apply(Vector3::from(*moving)));
    let release = Release {
        linear: cross_onto(inner.spin, velocity + velocity, centripetal(inner.spin, arm)),
        angular: cross(inner.spin, outer.spin - inner.spin),
        ..Release::nothing()
    };
    let Linear { x, y, z, .. } = &joint.linear;
    let axes = inner.attitude;
    let release = release
        .with(sliding(axes.x, x, place[0], moving[0]))
        .with(sliding(axes.y, y, place[1], moving[1]))
        .with(sliding(axes.z, z, place[2], moving[2]));
    turning(release, &outer.attitude, resisting(&joint.rotary, turn, rate))
}

pub(super) fn floating<T: Scalar>(
    _: &Floating<T>,
    motion: &JointMotion<T>,
    _: &([T; 3], Rotation<T>),
    _: &([T; 3], [T; 3]),
) -> Release<T> {
    let Columns { x, y, z } = Columns::identity();
    let free = Release { carries: false, ..Release::nothing() };
    let free = [x, y, z].into_iter().fold(free, |free, axis| free.with(Freedom::smooth(Way::Slide, axis).undriven()));
    let mut free = turning(free, &motion.outboard.turn.attitude, freely());
    free.coordinates.iter_mut().flatten().for_each(|coordinate| coordinate.driven = false);
    free
}

pub(super) fn axial<T: Scalar, J: Axial<T, K>, const K: usize>(
    joint: &J,
    motion: &JointMotion<T>,
    position: &J::Coordinates,
    rate: &J::Coordinates,
) -> Release<T> {
    let (position, rate, zero) = (position.list(), rate.list(), T::zero());
    let turn = motion.inboard.turn;
    let relative = joint.relative(&turn, position, rate);
    let mut release = Release {
        linear: linear_bias::<T, J, K>(&turn, &relative),
        angular: angular_bias::<T, J, K>(&turn, &relative),
        ..Release::nothing()
    };
    for k in 0..K {
        let [stiffness, damping] = slopes::<T, _>(|springs| joint.pivot(k, position[k], rate[k], springs));
        let resistance = Resistance { force: joint.force(k, position[k], rate[k]), stiffness, damping };
        let preload = joint.force(k, zero, zero);
        let freedom = Freedom::smooth(J::WAYS[k], relative.axes[k]).against(resistance, preload);
        release = release.with(Freedom { linear: J::LINEAR, ..freedom });
    }
    release
}
