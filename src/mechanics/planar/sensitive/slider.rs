//! Derivatives through kept gains in the plane: what joints that slide do.
//!
//! Along the line n and across it, t = ẑ × n, the outboard point accelerates by n (s̈ − ω² s) + t (α s + 2 ω ṡ) more than the inboard one.

use super::{Answering, Passing, Pulling};
use crate::lift::Lift;
use crate::mechanics::planar::axes::Offset;
use crate::mechanics::planar::joint::offset;
use crate::mechanics::planar::{Acceleration, Planar, Slider};
use crate::relation::planar::algebra::{cross, normal};
use crate::relation::planar::{Full, Relation, RelativeGain, Slides, along, back};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive};
use crate::spring::SpringLaw;
use nalgebra::Vector2;

/// What a joint that slides keeps.
#[derive(Clone, Copy)]
pub struct SlideStore<T: Scalar, const K: usize> {
    gain: RelativeGain<T>,
    /// −1 / S_nn.
    minus_inverse: T,
    /// Acceleration of the outboard point (m/s²), and its columns.
    linear: Vector2<T>,
    x: [T; K],
    y: [T; K],
    /// Columns of the direction of the line.
    angle: [T; K],
    /// Force handed in.
    load: Jet<T, K>,
}

impl<T: Scalar, L, P, const K: usize> Sensitive<Planar<Jet<T, K>>> for Slider<Jet<T, K>, L>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T, Over = P>,
    P: SpringLaw<T>,
{
    type Plain = Slider<T, P>;
    type Room = SlideStore<T, K>;

    fn room(&self) -> Self::Room {
        let (zero, none) = (T::zero(), [T::zero(); K]);
        SlideStore {
            gain: RelativeGain::blank(),
            minus_inverse: zero,
            linear: Vector2::new(zero, zero),
            x: none,
            y: none,
            angle: none,
            load: Jet::of(zero),
        }
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
        let offset = offset::<T, Slider<T, P>>(at.posture);
        let force = at.plain.spring.force(at.position.re, at.rate.re);
        let force = if N::LOADS { force + store.load.re } else { force };
        // The same quotient as in the elimination: it is formed once.
        store.minus_inverse = -outer.with_mass(at.plain.lumped).along(offset.direction).linear.xx.recip();
        at.plain.loosen(outer, offset, force, T::zero(), &mut store.gain)
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let Offset { direction, arm, acceleration: bias } = offset::<T, Slider<T, P>>(at.posture);
        let inboard = carried.acceleration.shifted(arm, bias);
        let second = store.gain.relative(along(inboard.linear, direction), inboard.angular, &());
        acceleration.re = second;
        let linear = inboard.linear + direction * second;
        carried.acceleration = Acceleration { linear, ..inboard };
        store.linear = linear;
        let (n, t) = (direction, normal(direction));
        let (s, v, spin, angular) = (at.position.re, at.rate.re, carried.rate, inboard.angular);
        let (twice, spin2) = (spin + spin, spin * spin);
        // What n and t are multiplied by.
        let (on, across) = (second - spin2 * s, angular.mul_add(s, twice * v));
        let own = self.direction.eps;
        columns!(K; angle = carried.angle, own = own, spins = carried.spin, turn = carried.turn, q = at.position.eps, r = at.rate.eps; k:
            let turned = angle[k] + own[k],
            let of_on = -(spin2.mul_add(q[k], twice * (spins[k] * s))),
            let of_across = angular.mul_add(q[k], turn[k].mul_add(s, twice.mul_add(r[k], (spins[k] + spins[k]) * v))),
            let a = of_on - across * turned,
            let b = of_across + on * turned,
            mut x = carried.x => n.x.mul_add(a, t.x.mul_add(b, x[k])),
            mut y = carried.y => n.y.mul_add(a, t.y.mul_add(b, y[k])),
            mut line = store.angle => turned
        );
        (store.x, store.y) = (carried.x, carried.y);
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let Offset { direction: n, arm, .. } = offset::<T, Slider<T, P>>(at.posture);
        let (t, mass, p) = (normal(n), self.lumped, store.linear);
        let force = self.spring.force(*at.position, *at.rate);
        let force = if N::LOADS { force + store.load } else { force };
        let w = along(store.gain.per_acceleration, back(n));
        let (w_angular, minus_inverse) = (store.gain.per_angular, store.minus_inverse);
        carried.force += p * mass.re;
        let f = carried.force;
        let (along_t, swung) = (t.x.mul_add(f.x, t.y * f.y), cross(n, f));
        let (s, turning) = (at.position.re, cross(t, f));
        columns!(K; applied = force.eps, line = store.angle, of_mass = mass.eps, px = store.x, py = store.y, q = at.position.eps; k:
            let fx = mass.re.mul_add(px[k], of_mass[k].mul_add(p.x, x[k])),
            let fy = mass.re.mul_add(py[k], of_mass[k].mul_add(p.y, y[k])),
            let residual = n.x.mul_add(fx, n.y.mul_add(fy, along_t.mul_add(line[k], -applied[k]))),
            let fx = w.x.mul_add(residual, fx),
            let fy = w.y.mul_add(residual, fy),
            // d × f, with d = n s.
            let moved = arm.x.mul_add(fy, -(arm.y * fx)) + q[k].mul_add(swung, s * (turning * line[k])),
            mut x = carried.x => fx,
            mut y = carried.y => fy,
            mut torque = carried.torque => w_angular.mul_add(residual, torque[k] + moved),
            mut free = acceleration.eps => residual * minus_inverse
        );
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let Offset { direction: n, arm, .. } = offset::<T, Slider<T, P>>(at.posture);
        let w = along(store.gain.per_acceleration, back(n));
        let w_angular = store.gain.per_angular;
        columns!(K; angular = carried.angular; k:
            let ax = (-arm.y).mul_add(angular[k], x[k]),
            let ay = arm.x.mul_add(angular[k], y[k]),
            let slid = w.x.mul_add(ax, w.y.mul_add(ay, w_angular.mul_add(angular[k], free[k]))),
            mut x = carried.x => n.x.mul_add(slid, ax),
            mut y = carried.y => n.y.mul_add(slid, ay),
            mut free = acceleration.eps => slid
        );
    }
}
