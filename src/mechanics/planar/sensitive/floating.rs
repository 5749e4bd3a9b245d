//! Derivatives through kept gains in the plane: where a chain floats.
//!
//! Its first station has the acceleration of the ground and its own, a₀ + (ẍ, ÿ), its body the angular acceleration of the coordinate. Columns of
//! forces and torques on them, for which nothing stands up, are eliminated as those of a pin, and then accelerate what is left of the
//! mass, −L⁻¹ df.

use super::joints::TurnStore;
use super::{Answering, Passing, Pulling};
use crate::mechanics::planar::ends::Floating;
use crate::mechanics::planar::{Acceleration, Planar};
use crate::relation::planar::algebra::Symmetric2;
use crate::relation::planar::{Full, Relation};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive, Varied};
use nalgebra::Vector2;

/// What a chain that floats keeps.
#[derive(Clone, Copy)]
pub struct FloatingStore<T: Scalar, const K: usize> {
    turn: TurnStore<T, K>,
    /// L⁻¹, once the rotation is gone.
    inverse: Symmetric2<T>,
    /// Acceleration of the first station, in a frame that falls freely, and its columns.
    linear: Vector2<T>,
    x: [T; K],
    y: [T; K],
}

fn inverse<T: Scalar>(Symmetric2 { xx, xy, yy }: Symmetric2<T>) -> Symmetric2<T> {
    let one_over = (xx * yy - xy * xy).recip();
    Symmetric2 { xx: yy * one_over, xy: -xy * one_over, yy: xx * one_over }
}

impl<T: Scalar, const K: usize> Sensitive<Planar<Jet<T, K>>> for Floating<Jet<T, K>> {
    type Plain = Floating<T>;
    type Room = FloatingStore<T, K>;

    fn room(&self) -> Self::Room {
        let (zero, none) = (T::zero(), [T::zero(); K]);
        let inverse = Symmetric2 { xx: zero, xy: zero, yy: zero };
        FloatingStore { turn: TurnStore::new(), inverse, linear: Vector2::new(zero, zero), x: none, y: none }
    }
    #[inline(always)]
    fn read(
        (x, y, angle): &(Jet<T, K>, Jet<T, K>, Jet<T, K>),
        (u, v, spin): &(Jet<T, K>, Jet<T, K>, Jet<T, K>),
        plain_position: &mut (T, T, T),
        plain_rate: &mut (T, T, T),
    ) {
        *plain_position = (x.re, y.re, angle.re);
        *plain_rate = (u.re, v.re, spin.re);
    }
    fn load(&self, (): &(), in_joint: &Jet<T, K>, store: &mut Self::Room) {
        store.turn.load = *in_joint;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(&self, at: At<'_, Planar<Jet<T, K>>, Self>, outer: Full<T>, store: &mut Self::Room) -> Full<T> {
        let (_, lumped) = at.plain.parts();
        let outer = outer.with_mass(lumped);
        let torque = if N::LOADS { store.turn.load.re } else { T::zero() };
        let left = store.turn.factor(outer, torque);
        store.inverse = inverse(left.linear);
        store.linear = -store.inverse.apply(left.force);
        Full::massless()
    }
    #[cfg_attr(optimised, inline(always))]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut (Jet<T, K>, Jet<T, K>, Jet<T, K>),
    ) {
        let (linear, angular) = (store.linear, store.turn.gain.angular(store.linear, &()));
        let own = linear - carried.acceleration.linear;
        (acceleration.0.re, acceleration.1.re, acceleration.2.re) = (own.x, own.y, angular);
        carried.acceleration = Acceleration { linear, angular };
        carried.rate = at.rate.2.re;
        (carried.angle, carried.spin) = (at.position.2.eps, at.rate.2.eps);
        (store.x, store.y) = (carried.x, carried.y);
    }
    #[cfg_attr(optimised, inline(always))]
    fn gather<N: Seeds>(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        (of_x, of_y, of_angle): &mut (Jet<T, K>, Jet<T, K>, Jet<T, K>),
    ) {
        let (_, mass) = self.parts();
        let (p, Symmetric2 { xx, xy, yy }) = (store.linear, store.inverse);
        columns!(K; of_mass = mass.eps, px = store.x, py = store.y; k:
            mut x = carried.x => mass.re.mul_add(px[k], of_mass[k].mul_add(p.x, x[k])),
            mut y = carried.y => mass.re.mul_add(py[k], of_mass[k].mul_add(p.y, y[k]))
        );
        match N::LOADS {
            true => store.turn.gather_under(&store.turn.load.eps, carried, of_angle),
            false => store.turn.gather(carried, of_angle),
        }
        columns!(K; x = carried.x, y = carried.y; k:
            mut free_x = of_x.eps => -xx.mul_add(x[k], xy * y[k]),
            mut free_y = of_y.eps => -xy.mul_add(x[k], yy * y[k])
        );
        *carried = Planar::<Jet<T, K>>::no_pull();
    }
    #[cfg_attr(optimised, inline(always))]
    fn answer(
        &self,
        _: At<'_, Planar<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        (of_x, of_y, of_angle): &mut (Jet<T, K>, Jet<T, K>, Jet<T, K>),
    ) {
        (carried.x, carried.y) = (of_x.eps, of_y.eps);
        store.turn.answer(carried, of_angle);
    }
}
