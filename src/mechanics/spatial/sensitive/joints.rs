//! Derivatives through kept gains in space: what joints do.

use super::columns::{Vectors, add_along, apply, crossed, none, parts, project, transposed, value};
use super::{Answering, Passing, Pulling, turned};
use crate::lift::Lift;
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::{Ball, Rotation, Spatial, Turn, Weld};
use crate::relation::spatial::algebra::{Columns, zero};
use crate::relation::spatial::{Couple, Full, Gain, Point};
use crate::relation::{Absent, Additive, Term};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive};
use nalgebra::Vector3;

/// What a ball keeps.
#[derive(Clone, Copy)]
pub struct BallStore<T: Scalar, const K: usize> {
    gain: Gain<T>,
    /// −H⁻¹.
    minus_inverse: Columns<T>,
    /// Columns of φ.
    angle: Vectors<T, K>,
    load: Effort<Jet<T, K>>,
}

/// The φ of a quaternion's derivatives, 2 dq ∘ q̄.
#[cfg_attr(optimised, inline(always))]
fn angle_of<T: Scalar, const K: usize>(rotation: &Rotation<Jet<T, K>>) -> Vectors<T, K> {
    let two = T::literal(2.0);
    let (w, v) = (rotation.w.re * two, value(&rotation.v) * two);
    let mut angle = none();
    let Columns { x, y, z } = crossed(v);
    let turn = Columns {
        x: x + Vector3::new(w, T::zero(), T::zero()),
        y: y + Vector3::new(T::zero(), w, T::zero()),
        z: z + Vector3::new(T::zero(), T::zero(), w),
    };
    apply(&mut angle, &turn, &parts(&rotation.v));
    add_along(&mut angle, -v, &rotation.w.eps);
    angle
}

/// Carries a motion on to a body whose attitude, angular velocity and acceleration do not depend on what is inboard.
#[cfg_attr(optimised, inline(always))]
pub(super) fn vary_turn<T: Scalar, const K: usize>(
    attitude: &Columns<T>,
    (position, rate): (&Rotation<Jet<T, K>>, &[Jet<T, K>; 3]),
    angular: Vector3<T>,
    carried: &mut Passing<T, K>,
    acceleration: &mut [Jet<T, K>; 3],
) {
    let (attitude, rate) = (*attitude, Vector3::from(*rate));
    let spin = attitude.apply(value(&rate));
    let own: [T; 3] = attitude.transposed(angular).into();
    for (to, from) in acceleration.iter_mut().zip(own) {
        to.re = from;
    }
    carried.turn = Turn { attitude, spin };
    carried.acceleration.angular = angular;
    let angle = angle_of(position);
    carried.spin = none();
    apply(&mut carried.spin, &crossed(-spin), &angle);
    apply(&mut carried.spin, &attitude, &parts(&rate));
    carried.angular = none();
    apply(&mut carried.angular, &crossed(-angular), &angle);
    carried.angle = angle;
}

/// Columns of a vector in axes of a body, from those in inertial ones.
#[cfg_attr(optimised, inline(always))]
pub(super) fn in_own<T: Scalar, const K: usize>(
    &Columns { x, y, z }: &Columns<T>,
    columns: &Vectors<T, K>,
    own: &mut [Jet<T, K>; 3],
) {
    for (to, axis) in own.iter_mut().zip([x, y, z]) {
        to.eps = [T::zero(); K];
        project(&mut to.eps, axis, columns);
    }
}

fn full<T: Scalar>(point: Point<T, impl Term<Vector3<T>>>) -> Full<T> {
    Full { linear: point.mass, force: point.offset, torque: point.torque.add_to(zero()), ..Full::massless() }
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Ball {
    type Plain = Self;
    type Room = BallStore<T, K>;

    fn room(&self) -> Self::Room {
        BallStore { gain: Gain::blank(), minus_inverse: Columns::null(), angle: none(), load: Effort::default() }
    }
    #[cfg_attr(optimised, inline(always))]
    fn read(
        position: &Rotation<Jet<T, K>>,
        rate: &[Jet<T, K>; 3],
        plain_position: &mut Rotation<T>,
        plain_rate: &mut [T; 3],
    ) {
        *plain_position = position.lift(&mut |x: Jet<T, K>| x.re);
        *plain_rate = rate.map(|x| x.re);
    }
    fn load(&self, (): &(), in_joint: &Effort<Jet<T, K>>, store: &mut Self::Room) {
        store.load = *in_joint;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Room,
    ) -> Full<T> {
        let factor = outer.angular.factor();
        let Columns { x, y, z } = Columns::identity();
        store.minus_inverse = Columns { x: -factor.solve(x), y: -factor.solve(y), z: -factor.solve(z) };
        if N::LOADS {
            let Effort(torque) = store.load;
            let couple = at.posture.x.apply(Vector3::from(torque.map(|x| x.re)));
            let (relation, gain) = outer.balled(Couple(couple));
            store.gain = gain;
            return full(relation);
        }
        let (relation, gain) = outer.balled(Absent);
        store.gain = gain;
        full(relation)
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        let angular = store.gain.angular(carried.acceleration.linear, &());
        vary_turn(at.posture.x, (at.position, at.rate), angular, carried, acceleration);
        store.angle = carried.angle;
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        let mut applied = none();
        if N::LOADS {
            let torque = Vector3::from(store.load.0);
            let attitude = at.posture.x;
            apply(&mut applied, attitude, &parts(&torque));
            apply(&mut applied, &crossed(-attitude.apply(value(&torque))), &store.angle);
            for (residual, applied) in carried.torques.iter_mut().zip(&applied) {
                columns!(K; applied = *applied; k: mut residual = *residual => residual[k] - applied[k]);
            }
        }
        apply(&mut carried.forces, &transposed(&store.gain.per_acceleration), &carried.torques);
        let mut free = none();
        apply(&mut free, &store.minus_inverse, &carried.torques);
        for (to, from) in acceleration.iter_mut().zip(free) {
            to.eps = from;
        }
        carried.torques = applied;
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        carried.angular = acceleration.map(|x| x.eps);
        apply(&mut carried.angular, &store.gain.per_acceleration, &carried.linear);
        in_own(at.posture.x, &carried.angular, acceleration);
    }
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Weld<Jet<T, K>> {
    type Plain = Weld<T>;
    type Room = ();

    fn room(&self) {}
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, (): &(), _: &Effort<Jet<T, K>>, (): &mut ()) {}
    #[inline(always)]
    fn factor<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, outer: Full<T>, (): &mut ()) -> Full<T> {
        outer
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        (): &mut (),
        (): &mut (),
    ) {
        if N::PARAMETERS {
            apply(&mut carried.angle, &{ carried.turn.attitude }, &turned(self.attitude()));
        }
        carried.turn.attitude = *at.posture.x;
    }
    #[inline(always)]
    fn gather<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Pulling<T, K>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn answer(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Answering<T, K>, (): &(), (): &mut ()) {}
}
