//! What joints let move, for their transfer matrices.

use super::axial::{Axial, Listed};
use super::axial_walks::{angular_bias, linear_bias};
use super::rotary_spring::RotaryLaw;
use super::{Ball, ElasticHinge, Floating, JointMotion, Linear, Rotation, Weld};
use crate::relation::space::Way;
use crate::relation::space::algebra::{Columns, centripetal, cross, cross_onto, zero};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// What a joint lets move at an instant, in inertial axes: p_O = X p_I + c + Φ q̈, Φᵀ F = τ.
#[derive(Clone, Copy, Debug)]
pub struct Release<T> {
    /// Its coordinates: how each moves, its axis, and the generalised force of its springs and dampers ON the outboard body.
    pub coordinates: [Option<(Way, Vector3<T>, T)>; 6],
    /// Whether its outboard body turns with the inboard one. Coordinates of a ball are absolute.
    pub carries: bool,
    /// Whether efforts act on its coordinates.
    pub driven: bool,
    /// c: what the outboard point accelerates by besides the inboard body (m/s²).
    pub linear: Vector3<T>,
    /// And by what its body does (rad/s²).
    pub angular: Vector3<T>,
}

impl<T: Scalar> Release<T> {
    /// A joint that lets nothing move.
    pub fn nothing() -> Self {
        Self { coordinates: [None; 6], carries: true, driven: true, linear: zero(), angular: zero() }
    }

    /// With turns about the axes of a body.
    fn turning(self, axes: &Columns<T>, [x, y, z]: [T; 3]) -> Self {
        let turn = |axis, spring| Some((Way::Turn, axis, spring));
        let turns = [turn(axes.x, x), turn(axes.y, y), turn(axes.z, z)];
        let mut coordinates = self.coordinates;
        coordinates.iter_mut().filter(|c| c.is_none()).zip(turns).for_each(|(c, turn)| *c = turn);
        Self { coordinates, ..self }
    }
}

pub(super) fn weld<T: Scalar>(_: &Weld<T>, _: &JointMotion<T>, (): &(), (): &()) -> Release<T> {
    Release::nothing()
}

pub(super) fn ball<T: Scalar>(_: &Ball, motion: &JointMotion<T>, _: &Rotation<T>, _: &[T; 3]) -> Release<T> {
    let free = Release { carries: false, ..Release::nothing() };
    free.turning(&motion.outboard.turn.attitude, [T::zero(); 3])
}

pub(super) fn rotary<T: Scalar, R: RotaryLaw<T>>(
    joint: &ElasticHinge<R>,
    motion: &JointMotion<T>,
    position: &Rotation<T>,
    rate: &[T; 3],
) -> Release<T> {
    let (inner, outer) = (motion.inboard.turn, motion.outboard.turn);
    let springs = joint.rotary.torque(position, rate);
    let angular = cross(inner.spin, outer.spin - inner.spin);
    Release { angular, ..Release::nothing() }.turning(&outer.attitude, springs.into())
}

pub(super) fn elastic<T: Scalar, R: RotaryLaw<T>, X: SpringLaw<T>, Y: SpringLaw<T>, Z: SpringLaw<T>>(
    joint: &ElasticHinge<R, Linear<T, X, Y, Z>>,
    motion: &JointMotion<T>,
    (place, turn): &([T; 3], Rotation<T>),
    (sliding, turning): &([T; 3], [T; 3]),
) -> Release<T> {
    let (inner, outer) = (motion.inboard.turn, motion.outboard.turn);
    let (arm, velocity) = (inner.attitude.apply(Vector3::from(*place)), inner.attitude.apply(Vector3::from(*sliding)));
    let release = Release {
        linear: cross_onto(inner.spin, velocity + velocity, centripetal(inner.spin, arm)),
        angular: cross(inner.spin, outer.spin - inner.spin),
        ..Release::nothing()
    };
    // Turns come first: efforts act on them.
    let mut release = release.turning(&outer.attitude, joint.rotary.torque(turn, turning).into());
    let forces = joint.linear.force(*place, *sliding);
    let Columns { x, y, z } = inner.attitude;
    for (k, (axis, force)) in [x, y, z].into_iter().zip([forces.x, forces.y, forces.z]).enumerate() {
        release.coordinates[3 + k] = Some((Way::Slide, axis, force));
    }
    release
}

pub(super) fn floating<T: Scalar>(
    _: &Floating<T>,
    motion: &JointMotion<T>,
    _: &([T; 3], Rotation<T>),
    _: &([T; 3], [T; 3]),
) -> Release<T> {
    let Columns { x, y, z } = Columns::identity();
    let mut free = Release { carries: false, driven: false, ..Release::nothing() };
    for (coordinate, axis) in free.coordinates.iter_mut().zip([x, y, z]) {
        *coordinate = Some((Way::Slide, axis, T::zero()));
    }
    free.turning(&motion.outboard.turn.attitude, [T::zero(); 3])
}

pub(super) fn axial<T: Scalar, J: Axial<T, K>, const K: usize>(
    joint: &J,
    motion: &JointMotion<T>,
    position: &J::Coordinates,
    rate: &J::Coordinates,
) -> Release<T> {
    let (position, rate) = (position.list(), rate.list());
    let turn = motion.inboard.turn;
    let relative = joint.relative(&turn, position, rate);
    let mut release = Release {
        linear: linear_bias::<T, J, K>(&turn, &relative),
        angular: angular_bias::<T, J, K>(&turn, &relative),
        ..Release::nothing()
    };
    for k in 0..K {
        let spring = joint.force(k, position[k], rate[k]);
        release.coordinates[k] = Some((J::WAYS[k], relative.axes[k], spring));
    }
    release
}
