//! What joints that turn about axes do.

use super::columns::{Vectors, add, add_along, add_scaled_vectors, apply, crossed, none, parts, project};
use super::{Answering, Passing, Pulling, turned};
use crate::lift::Lift;
use crate::mechanics::spatial::axial::{Axial, Listed, Relative};
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::{Acceleration, Revolute, Spatial, Turn, Universal};
use crate::relation::Absent;
use crate::relation::spatial::algebra::{Columns, add_scaled, dot, zero};
use crate::relation::spatial::{Full, Pivot, Way};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::{At, Seeds, Sensitive};
use crate::spring::SpringLaw;
use nalgebra::Vector3;
use num_traits::Zero;

/// What a joint that turns about `D` axes keeps.
#[derive(Clone, Copy)]
pub struct AxialStore<T: Scalar, const K: usize, const D: usize> {
    pivots: [Pivot<T>; D],
    /// −1 / Δ of each.
    minus_inverse: [T; D],
    axes: [Vector3<T>; D],
    /// Columns of the axes.
    turned: [Vectors<T, K>; D],
    load: Effort<Jet<T, K>>,
}

/// Derivatives of joints that turn about axes.
macro_rules! axial {
    ($Joint:ident<$($Law:ident $Over:ident),*>, $D:literal) => {
        impl<T: Scalar, $($Law, $Over,)* const K: usize> Sensitive<Spatial<Jet<T, K>>> for $Joint<Jet<T, K>, $($Law),*>
        where
            $($Law: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T, Over = $Over>, $Over: SpringLaw<T>,)*
        {
            type Plain = $Joint<T, $($Over),*>;
            type Room = AxialStore<T, K, $D>;

            fn room(&self) -> Self::Room {
                AxialStore {
                    pivots: [Pivot::blank(); $D],
                    minus_inverse: [T::zero(); $D],
                    axes: [zero(); $D],
                    turned: [none(); $D],
                    load: Effort::default(),
                }
            }
            #[cfg_attr(optimised, inline(always))]
            fn read(
                position: &<Self as Axial<Jet<T, K>, $D>>::Coordinates,
                rate: &<Self as Axial<Jet<T, K>, $D>>::Coordinates,
                plain_position: &mut <Self::Plain as Axial<T, $D>>::Coordinates,
                plain_rate: &mut <Self::Plain as Axial<T, $D>>::Coordinates,
            ) {
                let of = |jets: &<Self as Axial<Jet<T, K>, $D>>::Coordinates| {
                    Listed::<T, $D>::from_list(Listed::<Jet<T, K>, $D>::list(jets).map(|x| x.re))
                };
                (*plain_position, *plain_rate) = (of(position), of(rate));
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
                let (position, rate) = (at.position.list(), at.rate.list());
                let stored = at.posture.x;
                let mut relation = outer;
                for i in (0..$D).rev() {
                    let axis = if i == 0 { stored.x } else { stored.y };
                    let load = if N::LOADS { store.load.0[i].re } else { T::zero() };
                    let force = load + at.plain.force(i, position[i].re, rate[i].re);
                    // The same quotient as in the elimination.
                    store.minus_inverse[i] = -dot(axis, relation.angular.apply(axis)).recip();
                    (relation, store.pivots[i]) = relation.released(Way::Turn, axis, force, Absent);
                    store.axes[i] = axis;
                }
                relation.turning(at.posture.y[1])
            }
            #[cfg_attr(optimised, inline(always))]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Passing<T, K>,
                store: &mut Self::Room,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let (position, rate) = (at.position.list(), at.rate.list());
                let inboard = carried.turn;
                let relative = at.plain.relative(&inboard, position.map(|x| x.re), rate.map(|x| x.re));
                // What seeds in the axes do besides.
                let seeded: Option<Relative<Jet<T, K>, $D>> = match N::PARAMETERS {
                    true => {
                        let Turn { attitude: Columns { x, y, z }, spin } = inboard;
                        let of = |v: Vector3<T>| v.map(Jet::of);
                        let turn = Turn { attitude: Columns { x: of(x), y: of(y), z: of(z) }, spin: of(spin) };
                        Some(self.relative(&turn, position, rate))
                    }
                    false => None,
                };
                carried.acceleration.angular += at.posture.y[1];
                let mut list = acceleration.list();
                let mut turn = carried.angle;
                for i in 0..$D {
                    let (n, s) = (store.axes[i], rate[i].re);
                    let Acceleration { linear, angular } = carried.acceleration;
                    let second = store.pivots[i].acceleration(linear, angular, &());
                    list[i].re = second;
                    carried.acceleration.angular = add_scaled(angular, second, n);
                    let mut of_axis = none();
                    match &seeded {
                        Some(relative) => {
                            of_axis = parts(&relative.axes[i]);
                            apply(&mut of_axis, &crossed(-n), &carried.angle);
                        }
                        None => apply(&mut of_axis, &crossed(-n), &turn),
                    }
                    // Of n q̈ + ω × n q̇.
                    let mut swept = none();
                    add_along(&mut swept, n, &rate[i].eps);
                    add_scaled_vectors(&mut swept, s, &of_axis);
                    apply(&mut carried.angular, &crossed(carried.turn.spin), &swept);
                    apply(&mut carried.angular, &crossed(-(n * s)), &{ carried.spin });
                    add_scaled_vectors(&mut carried.angular, second, &of_axis);
                    add(&mut carried.spin, &swept);
                    add_along(&mut turn, n, &position[i].eps);
                    carried.turn.spin = add_scaled(carried.turn.spin, s, n);
                    store.turned[i] = of_axis;
                }
                if let Some(relative) = &seeded {
                    turn = carried.angle;
                    add(&mut turn, &turned(&relative.attitude));
                }
                *acceleration = Listed::from_list(list);
                carried.angle = turn;
                carried.turn.attitude = relative.attitude;
            }
            #[cfg_attr(optimised, inline(always))]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Pulling<T, K>,
                store: &mut Self::Room,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let (position, rate) = (at.position.list(), at.rate.list());
                let mut list = acceleration.list();
                for i in (0..$D).rev() {
                    let load = if N::LOADS { store.load.0[i] } else { Jet::zero() };
                    let force = load + self.force(i, position[i], rate[i]);
                    let mut residual = force.eps.map(|x| -x);
                    project(&mut residual, store.axes[i], &carried.torques);
                    project(&mut residual, carried.torque, &store.turned[i]);
                    let Pivot { per_linear, per_angular, .. } = store.pivots[i];
                    add_along(&mut carried.forces, per_linear, &residual);
                    add_along(&mut carried.torques, per_angular, &residual);
                    let minus_inverse = store.minus_inverse[i];
                    list[i].eps = residual.map(|x| x * minus_inverse);
                }
                *acceleration = Listed::from_list(list);
            }
            #[cfg_attr(optimised, inline(always))]
            fn answer(
                &self,
                _: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Answering<T, K>,
                store: &Self::Room,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let mut list = acceleration.list();
                for i in 0..$D {
                    let Pivot { per_linear, per_angular, .. } = store.pivots[i];
                    project(&mut list[i].eps, per_linear, &carried.linear);
                    project(&mut list[i].eps, per_angular, &carried.angular);
                    add_along(&mut carried.angular, store.axes[i], &list[i].eps);
                }
                *acceleration = Listed::from_list(list);
            }
        }
    };
}
axial!(Revolute<L P>, 1);
axial!(Universal<L P, M Q>, 2);
