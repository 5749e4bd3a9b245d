//! Derivatives through kept gains in space: where a chain floats.
//!
//! Its first station has the acceleration of the ground and its own, (a₀ + q̈, α), and columns of forces and torques on it, for which nothing
//! stands up, are accelerations −S⁻¹ (df, dt). Bodies count all of their mass themselves there, what they lump here, too.

use super::columns::{Vectors, none};
use super::joints::{in_own, vary_turn};
use super::{Answering, Passing, Pulling};
use crate::lift::Lift;
use crate::mechanics::spatial::ends::Floating;
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::{Acceleration, Rotation, Spatial};
use crate::relation::spatial::algebra::zero;
use crate::relation::spatial::{Factor6, Full, Relation};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::{At, Seeds, Sensitive};
use nalgebra::Vector3;

/// What a chain that floats keeps.
#[derive(Clone, Copy)]
pub struct FloatingStore<T: Scalar, const K: usize> {
    factor: Factor6<T>,
    /// Acceleration of the first station, in a frame that falls freely, and of its body.
    acceleration: Acceleration<T>,
    /// Columns of the accelerations that the forces cause.
    free: Answering<T, K>,
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Floating<Jet<T, K>> {
    type Plain = Floating<T>;
    type Room = FloatingStore<T, K>;

    fn room(&self) -> Self::Room {
        let free = Answering { linear: none(), angular: none() };
        FloatingStore { factor: Factor6::of_one(), acceleration: Acceleration::zero(), free }
    }
    #[inline(always)]
    fn read(
        (place, attitude): &([Jet<T, K>; 3], Rotation<Jet<T, K>>),
        (velocity, spin): &([Jet<T, K>; 3], [Jet<T, K>; 3]),
        plain_position: &mut ([T; 3], Rotation<T>),
        plain_rate: &mut ([T; 3], [T; 3]),
    ) {
        let of = |v: &[Jet<T, K>; 3]| v.map(|x| x.re);
        *plain_position = (of(place), attitude.lift(&mut |x: Jet<T, K>| x.re));
        *plain_rate = (of(velocity), of(spin));
    }
    fn load(&self, (): &(), _: &Effort<Jet<T, K>>, _: &mut Self::Room) {}
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Room,
    ) -> Full<T> {
        let outer = outer.with_mass(at.plain.lumped());
        store.factor = outer.factor();
        let (linear, angular) = store.factor.solve(-outer.force, -outer.torque);
        store.acceleration = Acceleration { linear, angular };
        Full::massless()
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        (of_place, of_turn): &mut ([Jet<T, K>; 3], [Jet<T, K>; 3]),
    ) {
        let Acceleration { linear, angular } = store.acceleration;
        let own: [T; 3] = (linear - carried.acceleration.linear).into();
        for (to, from) in of_place.iter_mut().zip(own) {
            to.re = from;
        }
        vary_turn(at.posture.x, (&at.position.1, &at.rate.1), angular, carried, of_turn);
        carried.acceleration.linear = linear;
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        _: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        _: &mut ([Jet<T, K>; 3], [Jet<T, K>; 3]),
    ) {
        let Pulling { forces, torques, .. } = *carried;
        let Answering { linear, angular } = &mut store.free;
        for k in 0..K {
            let column = |v: &Vectors<T, K>| -Vector3::new(v[0][k], v[1][k], v[2][k]);
            let (a, b) = store.factor.solve(column(&forces), column(&torques));
            for i in 0..3 {
                (linear[i][k], angular[i][k]) = (a[i], b[i]);
            }
        }
        let (force, torque) = (zero(), zero());
        *carried = Pulling { force, torque, forces: none(), torques: none() };
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        (of_place, of_turn): &mut ([Jet<T, K>; 3], [Jet<T, K>; 3]),
    ) {
        *carried = store.free;
        for (to, from) in of_place.iter_mut().zip(carried.linear) {
            to.eps = from;
        }
        in_own(at.posture.x, &carried.angular, of_turn);
    }
}
