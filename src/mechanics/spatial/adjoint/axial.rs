//! The costate sweep in space: how joints that slide, or turn about two axes, are eliminated and stirred.
//!
//! Such a joint is a row of joints with one coordinate each at one station, as if bodies without mass were between them: what its coordinates
//! do to attitudes and lengths stands in [`steps`](super::steps), one coordinate at a time.

use super::reversing::Reversing;
use super::{InJoint, Outboard, Pivot, Stirred};
use crate::adjoint::laws::ReversibleLaw;
use crate::element::{Element, Springs};
use crate::mechanics::spatial::axial::{Axial, Listed};
use crate::mechanics::spatial::{Acceleration, Cylindrical, Joint, Prismatic, Spatial, Turn, Universal, Wrench};
use crate::relation::spatial::algebra::{Columns, add_scaled, cross_onto, dot};
use crate::relation::spatial::{Pivot as Gain, Relation as _, Way};
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, Reach, Stir, Strain};
use nalgebra::Vector3;

/// The axis of a coordinate.
#[inline(always)]
pub(super) fn axis<T: Scalar>(axes: &Columns<T>, k: usize) -> Vector3<T> {
    if k == 0 { axes.x } else { axes.y }
}

/// What a coordinate along or about an axis meets of a wrench.
#[cfg_attr(optimised, inline(always))]
fn share<T: Scalar>(way: Way, n: Vector3<T>, w: &Wrench<T>) -> T {
    match way {
        Way::Turn => dot(n, w.torque),
        Way::Slide => dot(n, w.force),
    }
}

impl<T: Scalar> Pivot<T> {
    /// Inverses of the pivots of coordinates, one after the other.
    fn set(&mut self, k: usize, inverse: T) {
        if k == 0 { self.factor.set_number(inverse) } else { self.torque.x = inverse }
    }
    fn of(&self, k: usize) -> T {
        if k == 0 { self.factor.number() } else { self.torque.x }
    }
}

/// The inward half with another right-hand side: what is left in place of each costate, over its pivot.
#[cfg_attr(optimised, inline(always))]
fn met<T: Scalar, J: Axial<T, K>, C: Closures, const K: usize>(
    walk: &mut Meet<T, C>,
    outer: Wrench<T>,
    axes: &Columns<T>,
    (gain, pivot): (&[Gain<T, C>; K], &Pivot<T>),
    costates: &mut J::Coordinates,
) -> Wrench<T> {
    let (mut list, mut w) = (costates.list(), outer);
    for k in (0..K).rev() {
        let left = list[k] - share(J::WAYS[k], axis(axes, k), &w);
        list[k] = left * pivot.of(k);
        walk.part(&gain[k].per_closure, left);
        w.force = add_scaled(w.force, -left, gain[k].per_linear);
        w.torque = add_scaled(w.torque, -left, gain[k].per_angular);
    }
    *costates = J::Coordinates::from_list(list);
    if J::SLIDES { Wrench { torque: cross_onto(axes.z, w.force, w.torque), ..w } } else { w }
}

macro_rules! axial {
    ([$($L:ident)*] $Joint:ty, $K:literal) => {
        impl<T: Scalar, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Orient> for $Joint {
            /// Stores columns beside the axes, too.
            fn take(
                &self,
                _: &mut Orient,
                turn: Turn<T>,
                (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
            ) -> Turn<T> {
                let outboard = self.orient(position, rate, turn, x, y, p, q);
                self.store_asides([&turn.attitude, &outboard.attitude], position, (x, y, p, q));
                outboard
            }
        }

        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>,)* By: Springs<T>>
            Takes<Spatial<T>, Factor<C, By>> for $Joint
        {
            /// Under an implicit rule the pivots know the stiffness.
            fn take(
                &self,
                walk: &mut Factor<C, By>,
                outer: Outboard<T, C>,
                (axes, bias, .., (position, rate, led), torque, gain, pivot): Of<'_, Spatial<T>, Factor<C, By>, Self>,
            ) -> Outboard<T, C> {
                // Laws that are not linear are read where the last sweep has led.
                let follows = const { !<Self as Axial<T, $K>>::LINEAR && By::STIFF };
                let (position, rate) = if follows { (led.0, led.1) } else { (position, rate) };
                let (position, rate) = (Listed::<T, $K>::list(position), Listed::<T, $K>::list(rate));
                let led = Listed::<T, $K>::list(led.2);
                let mut relation = outer.relation;
                if <Self as Axial<T, $K>>::SLIDES {
                    relation = relation.with_mass(self.lumped());
                }
                for k in (0..$K).rev() {
                    let (way, n) = (<Self as Axial<T, $K>>::WAYS[k], axis(axes, k));
                    let mut force = torque.0[k] + Axial::force(self, k, position[k], rate[k]);
                    let inertia = match way {
                        Way::Turn => dot(n, relation.angular.apply(n)),
                        Way::Slide => dot(n, relation.linear.apply(n)),
                    };
                    (relation, gain[k]) = if const { By::STIFF } {
                        let stiffness = self.stiffness(k, [position[k], rate[k]], walk.springs);
                        if follows {
                            force = stiffness.mul_add(led[k], force);
                        }
                        pivot.set(k, (inertia + stiffness).recip());
                        relation.released(way, n, force, stiffness)
                    } else {
                        pivot.set(k, inertia.recip());
                        relation.released(way, n, force, Absent)
                    };
                }
                if <Self as Axial<T, $K>>::TURNS {
                    relation = relation.turning(bias[1]);
                }
                if <Self as Axial<T, $K>>::SLIDES {
                    relation = relation.carried(axes.z, bias[0]);
                }
                Outboard::rigid(relation)
            }
        }

        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Reach<T, C>> for $Joint {
            fn take(
                &self,
                walk: &mut Reach<T, C>,
                inner: Acceleration<T>,
                stores: Of<'_, Spatial<T>, Reach<T, C>, Self>,
            ) -> Acceleration<T> {
                let (x, y, _, _, gain, acceleration, (_, reached, _)) = stores;
                let outer = Joint::recovered(self, inner, (x, y), gain, &walk.forces, acceleration);
                *reached = outer.linear;
                outer
            }
        }

        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Meet<T, C>> for $Joint {
            fn take(
                &self,
                walk: &mut Meet<T, C>,
                outer: Wrench<T>,
                (axes, .., gain, pivot, costates, _): Of<'_, Spatial<T>, Meet<T, C>, Self>,
            ) -> Wrench<T> {
                met::<T, Self, C, $K>(walk, outer, axes, (gain, pivot), costates)
            }
        }

        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Burden<T, C>> for $Joint {
            fn take(
                &self,
                walk: &mut Burden<T, C>,
                outer: Wrench<T>,
                (axes, .., gain, pivot): Of<'_, Spatial<T>, Burden<T, C>, Self>,
            ) -> Wrench<T> {
                let mut more = Listed::<T, $K>::from_list([T::zero(); $K]);
                let inner = met::<T, Self, C, $K>(&mut walk.0, outer, axes, (&*gain, pivot), &mut more);
                gain.iter_mut().zip(Listed::<T, $K>::list(&more)).for_each(|(gain, more)| gain.free += more);
                inner
            }
        }

        impl<T: Scalar, C: Closures, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Stir<T, C>> for $Joint {
            fn take(
                &self,
                walk: &mut Stir<T, C>,
                Stirred { velocity, turning: inner }: Stirred<T>,
                stores: Of<'_, Spatial<T>, Stir<T, C>, Self>,
            ) -> Stirred<T> {
                let (axes, bias, _, _, gain, (_, rate, acceleration, free), (_, kept, _), torque) = stores;
                let mut own = Listed::<T, $K>::list(free);
                let (rate, acceleration) = (Listed::<T, $K>::list(rate), Listed::<T, $K>::list(acceleration));
                let mut virtually = Acceleration { linear: velocity, angular: inner.stirring };
                if <Self as Axial<T, $K>>::SLIDES {
                    virtually = virtually.swung(axes.z);
                }
                let mut turning = inner;
                if <Self as Axial<T, $K>>::TURNS {
                    turning.acceleration += bias[1];
                }
                for k in 0..$K {
                    let n = axis(axes, k);
                    let gain = Gain { free: own[k], ..gain[k] };
                    own[k] = gain.acceleration(virtually.linear, virtually.angular, &walk.forces);
                    torque.0[k] += own[k];
                    match <Self as Axial<T, $K>>::WAYS[k] {
                        Way::Turn => {
                            virtually.angular = add_scaled(virtually.angular, own[k], n);
                            turning.spin = add_scaled(turning.spin, rate[k], n);
                            turning.acceleration = add_scaled(turning.acceleration, acceleration[k], n);
                        }
                        Way::Slide => virtually.linear = add_scaled(virtually.linear, own[k], n),
                    }
                }
                *free = Listed::<T, $K>::from_list(own);
                turning.stirring = virtually.angular;
                *kept = InJoint { turning, velocity: virtually.linear };
                Stirred { velocity: virtually.linear, turning }
            }
        }

        impl<T: Scalar, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, Strain<T>> for $Joint {
            fn take(
                &self,
                walk: &mut Strain<T>,
                (): (),
                (position, rate, w, sums, of_position, of_rate, led, of_led): Of<'_, Spatial<T>, Strain<T>, Self>,
            ) {
                let [q, v, w] = [position, rate, w].map(Listed::<T, $K>::list);
                let led = [led.0, led.1, led.2].map(Listed::<T, $K>::list);
                let mut by = [&*of_position, &*of_rate].map(Listed::<T, $K>::list);
                let mut by_led = [&*of_led.0, &*of_led.1, &*of_led.2].map(Listed::<T, $K>::list);
                for k in 0..$K {
                    let at = ([q[k], v[k], w[k]], led.map(|list| list[k]));
                    let (more, of_led) = self.strain_law(k, walk, at, &mut sums.law);
                    by.iter_mut().zip(more).for_each(|(by, more)| by[k] += more);
                    by_led.iter_mut().zip(of_led).for_each(|(by, more)| by[k] += more);
                }
                [*of_position, *of_rate] = by.map(Listed::from_list);
                [*of_led.0, *of_led.1, *of_led.2] = by_led.map(Listed::from_list);
            }
        }
    };
}
axial!([L] Prismatic<T, L>, 1);
axial!([L M] Cylindrical<T, L, M>, 2);
axial!([L M] Universal<T, L, M>, 2);
