//! Derivatives through kept gains in the plane: what joints do.

use super::{Answering, Passing, Pulling};
use crate::lift::Lift;
use crate::mechanics::planar::{ElasticHinge, Pin, Planar, Weld};
use crate::relation::planar::{Full, Gain, Slides};
use crate::relation::{Absent, Coefficient, Minus, Term};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive};
use crate::spring::{Spring, SpringLaw};

/// What a joint that turns keeps.
#[derive(Clone, Copy)]
pub struct TurnStore<T: Scalar, const K: usize> {
    pub(super) gain: Gain<T>,
    /// −1 / D.
    minus_inverse: T,
    /// Torque handed in.
    pub(super) load: Jet<T, K>,
}

impl<T: Scalar, const K: usize> TurnStore<T, K> {
    pub(super) fn new() -> Self {
        Self { gain: Gain::blank(), minus_inverse: T::zero(), load: Jet::of(T::zero()) }
    }

    /// Eliminates the rotation under a torque.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn factor(&mut self, outer: Full<T>, torque: impl Term<T>) -> Full<T> {
        // The same quotient as in the elimination: it is formed once.
        self.minus_inverse = -outer.angular.recip();
        let (relation, gain) = outer.pinned(torque);
        self.gain = gain;
        relation.full()
    }

    /// Turns residuals in a joint without torque into angular accelerations.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn gather(&self, carried: &mut Pulling<T, K>, acceleration: &mut Jet<T, K>) {
        let (w, minus_inverse) = (self.gain.per_acceleration, self.minus_inverse);
        columns!(K; ; k:
            mut x = carried.x => w.x.mul_add(torque[k], x[k]),
            mut y = carried.y => w.y.mul_add(torque[k], y[k]),
            mut free = acceleration.eps => torque[k] * minus_inverse,
            mut torque = carried.torque => T::zero()
        );
    }

    /// Turns residuals in a joint under a torque into angular accelerations.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn gather_under(&self, applied: &[T; K], carried: &mut Pulling<T, K>, acceleration: &mut Jet<T, K>) {
        let (w, minus_inverse) = (self.gain.per_acceleration, self.minus_inverse);
        columns!(K; applied = *applied; k:
            let residual = torque[k] - applied[k],
            mut x = carried.x => w.x.mul_add(residual, x[k]),
            mut y = carried.y => w.y.mul_add(residual, y[k]),
            mut free = acceleration.eps => residual * minus_inverse,
            mut torque = carried.torque => applied[k]
        );
    }

    /// Columns of the body's angular acceleration, the coordinate being the body's.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn answer(&self, carried: &mut Answering<T, K>, acceleration: &mut Jet<T, K>) {
        let w = self.gain.per_acceleration;
        columns!(K; x = carried.x, y = carried.y; k:
            let turned = w.x.mul_add(x[k], w.y.mul_add(y[k], free[k])),
            mut angular = carried.angular => turned,
            mut free = acceleration.eps => turned
        );
    }
}

impl<T: Scalar, const K: usize> Sensitive<Planar<Jet<T, K>>> for Pin {
    type Plain = Self;
    type Room = TurnStore<T, K>;

    fn room(&self) -> Self::Room {
        TurnStore::new()
    }
    #[inline(always)]
    fn read(position: &Jet<T, K>, rate: &Jet<T, K>, plain_position: &mut T, plain_rate: &mut T) {
        (*plain_position, *plain_rate) = (position.re, rate.re);
    }
    fn load(&self, (): &(), in_joint: &Jet<T, K>, store: &mut Self::Room) {
        store.load = *in_joint;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(&self, _: At<'_, Planar<Jet<T, K>>, Self>, outer: Full<T>, store: &mut Self::Room) -> Full<T> {
        match N::LOADS {
            true => store.factor(outer, store.load.re),
            false => store.factor(outer, Absent),
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        acceleration.re = store.gain.angular(carried.acceleration.linear, &());
        carried.acceleration.angular = acceleration.re;
        carried.rate = at.rate.re;
        carried.angle = at.position.eps;
        carried.spin = at.rate.eps;
        if N::PARAMETERS {
            carried.turn = [T::zero(); K];
            carried.turning = false;
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        match N::LOADS {
            true => store.gather_under(&store.load.eps, carried, acceleration),
            false => store.gather(carried, acceleration),
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        store.answer(carried, acceleration);
    }
}

impl<T, D, P, E, Q, const K: usize> Sensitive<Planar<Jet<T, K>>> for ElasticHinge<Spring<Jet<T, K>, D, P>>
where
    T: Scalar,
    D: Coefficient<Jet<T, K>> + Lift<Jet<T, K>, T, Over = E>,
    P: Term<Jet<T, K>> + Lift<Jet<T, K>, T, Over = Q>,
    E: Coefficient<T>,
    Q: Term<T>,
{
    type Plain = ElasticHinge<Spring<T, E, Q>>;
    type Room = TurnStore<T, K>;

    fn room(&self) -> Self::Room {
        TurnStore::new()
    }
    #[inline(always)]
    fn read(position: &Jet<T, K>, rate: &Jet<T, K>, plain_position: &mut T, plain_rate: &mut T) {
        (*plain_position, *plain_rate) = (position.re, rate.re);
    }
    fn load(&self, (): &(), in_joint: &Jet<T, K>, store: &mut Self::Room) {
        store.load = *in_joint;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(&self, at: At<'_, Planar<Jet<T, K>>, Self>, outer: Full<T>, store: &mut Self::Room) -> Full<T> {
        let torque = at.plain.rotary.force(at.position.re, at.rate.re);
        let torque = if N::LOADS { torque + store.load.re } else { torque };
        store.factor(outer, Minus(-torque))
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let angular = store.gain.angular(carried.acceleration.linear, &());
        acceleration.re = angular - carried.acceleration.angular;
        carried.acceleration.angular = angular;
        carried.rate += at.rate.re;
        columns!(K; q = at.position.eps, v = at.rate.eps; k:
            mut angle = carried.angle => angle[k] + q[k],
            mut spin = carried.spin => spin[k] + v[k]
        );
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let torque = self.rotary.force(*at.position, *at.rate);
        let torque = if N::LOADS { torque + store.load } else { torque };
        store.gather_under(&torque.eps, carried, acceleration);
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let w = store.gain.per_acceleration;
        columns!(K; x = carried.x, y = carried.y; k:
            let turned = w.x.mul_add(x[k], w.y.mul_add(y[k], free[k])),
            mut free = acceleration.eps => turned - angular[k],
            mut angular = carried.angular => turned
        );
    }
}

impl<T: Scalar, const K: usize> Sensitive<Planar<Jet<T, K>>> for Weld<Jet<T, K>> {
    type Plain = Weld<T>;
    type Room = ();

    fn room(&self) {}
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, (): &(), _: &Jet<T, K>, (): &mut ()) {}
    #[inline(always)]
    fn factor<N: Seeds>(&self, _: At<'_, Planar<Jet<T, K>>, Self>, outer: Full<T>, (): &mut ()) -> Full<T> {
        outer
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        (): &mut (),
        (): &mut (),
    ) {
        if N::PARAMETERS {
            let Jet { eps, .. } = self.angle();
            columns!(K; more = eps; k: mut angle = carried.angle => angle[k] + more[k]);
        }
    }
    #[inline(always)]
    fn gather<N: Seeds>(&self, _: At<'_, Planar<Jet<T, K>>, Self>, _: &mut Pulling<T, K>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn answer(&self, _: At<'_, Planar<Jet<T, K>>, Self>, _: &mut Answering<T, K>, (): &(), (): &mut ()) {}
}
