//! The costate sweep in space: what joints that slide, or turn about two axes, do, one coordinate after the other.
//!
//! Turns are those of a [`revolute`](super::revolute) joint. With n the axis of a slide, d = s n the arm from I to O, ω, α and w those of both
//! bodies, and G and F at O those of the point mass μ there included,
//!
//! ```text
//! A_O = A_I + α × d + ω × (ω × d) + 2 ω × n ṡ + n s̈        W_O = W_I + w × d + n w_s
//!
//! Θ ← Θ + F × (W_O − W_I) + G × (A_O − A_I)        M ← M + d × F        H ← H + d × G        Ω ← Ω + ∂/∂ω G·A_O
//! s̄ = n·N        ṡ̄ = −2 G·(ω × n)        τ̄ = w_s        μ̄ = −A_O·W_O        N = −[G × α + ω (ω·G) − ω² G + F × w]
//! n̄ = s N − 2 ṡ G × ω − s̈ G − w_s F
//! ```
//!
//! and turns of the axis have the costate n × n̄. What loads and closures read is carried as in [`felt`](super::felt), with n ṡ and n w_s.

use super::axial::axis;
use super::inertial::swept;
use super::reversing::Reversing;
use super::revolute::of_axis;
use super::{Felt, Pulled, Turning};
use crate::adjoint::laws::ReversibleLaw;
use crate::adjoint::{BodyLaw, Reversed, unless_rows};
use crate::mechanics::spatial::axial::{Axial, Listed};
use crate::mechanics::spatial::{Cylindrical, Prismatic, Spatial, Universal};
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{Columns, add_scaled, centripetal, cross, cross_onto, dot};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{PullBack, PullLoads};
use nalgebra::Vector3;

/// A coordinate: its axis and columns beside it, rate, acceleration and virtual rate.
pub struct Step<T> {
    pub axes: Columns<T>,
    pub rate: T,
    pub acceleration: T,
    pub own: T,
}

impl<T: Scalar> Step<T> {
    /// How the body on the inboard side of a turn turns.
    pub fn before(&self, outer: Turning<T>) -> Turning<T> {
        let n = self.axes.x;
        let spin = add_scaled(outer.spin, -self.rate, n);
        let acceleration = add_scaled(outer.acceleration, -self.acceleration, n) - cross(spin, n * self.rate);
        Turning { spin, acceleration, stirring: add_scaled(outer.stirring, -self.own, n) }
    }

    /// Virtual velocity and acceleration of where a slide begins, from those of where it has led, by an arm `d`.
    pub fn before_slide(&self, d: Vector3<T>, [w, a]: [Vector3<T>; 2], met: &Turning<T>) -> [Vector3<T>; 2] {
        let (n, &Turning { spin, acceleration, stirring }) = (self.axes.x, met);
        let sliding = n * (self.rate + self.rate);
        let moved = cross_onto(spin, sliding, cross_onto(acceleration, d, centripetal(spin, d)));
        [w - cross_onto(stirring, d, n * self.own), a - add_scaled(moved, self.acceleration, n)]
    }

    /// What turns of the axis of a slide do: n × n̄ along e, and along n × e.
    fn of_slide(&self, of_axis: Vector3<T>) -> Vector3<T> {
        let Columns { x: n, y: e, .. } = self.axes;
        let turned = cross(n, of_axis);
        Vector3::new(dot(turned, e), dot(turned, cross(n, e)), T::zero())
    }

    /// A turn, as in a revolute joint: costates of angle and rate, and of turns of the axis.
    pub fn turned(&self, carried: &mut Pulled<T>, turning: Turning<T>) -> ([T; 2], Vector3<T>) {
        let (n, turned) = (self.axes.x, carried.turned(turning));
        let beside = cross(n, carried.angular);
        let of_rate = -(dot(n, carried.spin) + dot(turning.spin, beside));
        carried.spin = add_scaled(carried.spin, self.rate, beside);
        let x = add_scaled(carried.torque * self.own, self.acceleration, carried.angular);
        let x = add_scaled(x, self.rate, carried.spin - cross(turning.spin, carried.angular));
        let mut by_axis = Vector3::new(T::zero(), T::zero(), T::zero());
        of_axis(&self.axes, turned, x, &mut by_axis);
        ([dot(n, turned), of_rate], by_axis)
    }

    /// A slide by the arm `d`, on a body that turns so.
    pub fn slid(&self, position: T, d: Vector3<T>, carried: &mut Pulled<T>, met: &Turning<T>) -> ([T; 2], Vector3<T>) {
        let (n, &Turning { spin, acceleration, stirring }) = (self.axes.x, met);
        let Pulled { momentum, force, .. } = *carried;
        let sliding = n * (self.rate + self.rate);
        let moved = cross_onto(acceleration, d, centripetal(spin, d));
        let moved = cross_onto(spin, sliding, add_scaled(moved, self.acceleration, n));
        let stirred = cross_onto(stirring, d, n * self.own);
        let square = dot(spin, spin);
        let reach = add_scaled(cross(momentum, acceleration) + spin * dot(spin, momentum), -square, momentum);
        let reach = -cross_onto(force, stirring, reach);
        let whirled = cross(momentum, spin);
        let by_axis = reach * position - whirled * (self.rate + self.rate);
        let by_axis = add_scaled(add_scaled(by_axis, -self.acceleration, momentum), -self.own, force);
        carried.turn = cross_onto(force, stirred, cross_onto(momentum, moved, carried.turn));
        carried.torque = cross_onto(d, force, carried.torque);
        carried.angular = cross_onto(d, momentum, carried.angular);
        carried.spin = swept(spin, d, momentum, cross_onto(sliding, momentum, carried.spin));
        let pulled = dot(n, whirled);
        ([dot(n, reach), -(pulled + pulled)], self.of_slide(by_axis))
    }

    /// A turn that loads and closures read.
    pub fn turned_felt<L: BodyLaw<Spatial<T>>>(&self, felt: &Felt<T>, turning: &Turning<T>) -> ([T; 2], Vector3<T>) {
        let (n, turned) = (self.axes.x, felt.turned_under::<L>(turning));
        let x = -(felt.spin * self.rate + felt.torque * self.own);
        let mut by_axis = Vector3::new(T::zero(), T::zero(), T::zero());
        of_axis(&self.axes, turned, x, &mut by_axis);
        ([dot(n, turned), dot(n, felt.spin)], by_axis)
    }

    /// A slide that loads and closures read.
    pub fn slid_felt(&self, position: T, d: Vector3<T>, felt: &mut Felt<T>, met: &Turning<T>) -> ([T; 2], Vector3<T>) {
        let (n, &Turning { spin, stirring, .. }) = (self.axes.x, met);
        let &mut Felt { place, velocity, stirring: force, .. } = felt;
        let reach = place - cross(spin, velocity) - cross(stirring, force);
        let by_axis = add_scaled(add_scaled(reach * position, self.rate, velocity), self.own, force);
        let swept = cross_onto(cross_onto(spin, d, n * self.rate), velocity, felt.turn);
        felt.turn = cross_onto(d, place, cross_onto(cross_onto(stirring, d, n * self.own), force, swept));
        felt.spin = cross_onto(d, velocity, felt.spin);
        felt.torque = cross_onto(d, force, felt.torque);
        ([dot(n, reach), dot(n, velocity)], self.of_slide(by_axis))
    }
}

macro_rules! axial {
    ([$($L:ident)*] $Joint:ty, $K:literal) => {
        impl<T: Scalar, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, PullBack> for $Joint {
            fn take(
                &self,
                walk: &mut PullBack,
                outer: Pulled<T>,
                (x, y, p, q, motion, (_, a, _, kept, _, _), (_, sums), (of_position, of_rate)): Of<
                    '_,
                    Spatial<T>,
                    PullBack,
                    Self,
                >,
            ) -> Pulled<T> {
                let (_, _, mut unread) = Spatial::of_nothing();
                let sums = unless_rows::<T, _>(sums, &mut unread);
                let (position, rate) = (Listed::<T, $K>::list(motion.0), Listed::<T, $K>::list(motion.1));
                let (acceleration, own) = (Listed::<T, $K>::list(motion.2), Listed::<T, $K>::list(motion.3));
                let (mut carried, mut turning, mut by) = (outer, kept.turning, [[T::zero(); $K]; 2]);
                if <Self as Axial<T, $K>>::SLIDES {
                    let lumped = Axial::lumped(self);
                    carried.momentum = add_scaled(carried.momentum, lumped, kept.velocity);
                    carried.force = add_scaled(carried.force, lumped, *a);
                    sums.more[0] -= dot(*a, kept.velocity);
                }
                for k in (0..$K).rev() {
                    let [inner, outer] = Self::asides(k, (x, y, p, q));
                    let axes = Columns { x: axis(x, k), y: inner, z: outer };
                    let step = Step { axes, rate: rate[k], acceleration: acceleration[k], own: own[k] };
                    let at = [position[k], rate[k], own[k]];
                    let none = [T::zero(); 2];
                    let of_law = if walk.laws { self.pull_law(k, at, &mut sums.law) } else { none };
                    let (of, by_axis) = match <Self as Axial<T, $K>>::WAYS[k] {
                        Way::Turn => {
                            let found = step.turned(&mut carried, turning);
                            turning = step.before(turning);
                            found
                        }
                        Way::Slide => step.slid(position[k], x.z, &mut carried, &turning),
                    };
                    Self::add_axis(k, by_axis, sums);
                    (by[0][k], by[1][k]) = (of_law[0] + of[0], of_law[1] + of[1]);
                }
                *of_position = Listed::<T, $K>::from_list(by[0]);
                *of_rate = Listed::<T, $K>::from_list(by[1]);
                carried
            }
        }

        impl<T: Scalar, N: BodyLaw<Spatial<T>>, $($L: ReversibleLaw<T>),*> Takes<Spatial<T>, PullLoads<N, Spatial<T>>>
            for $Joint
        {
            fn take(
                &self,
                _: &mut PullLoads<N, Spatial<T>>,
                outer: Felt<T>,
                (x, y, p, q, motion, (.., kept, _), (_, sums), (of_position, of_rate)): Of<
                    '_,
                    Spatial<T>,
                    PullLoads<N, Spatial<T>>,
                    Self,
                >,
            ) -> Felt<T> {
                let (position, rate) = (Listed::<T, $K>::list(motion.0), Listed::<T, $K>::list(motion.1));
                let own = Listed::<T, $K>::list(motion.2);
                let (mut felt, mut turning) = (outer, kept.turning);
                let mut by = [&*of_position, &*of_rate].map(Listed::<T, $K>::list);
                for k in (0..$K).rev() {
                    let [inner, outer] = Self::asides(k, (x, y, p, q));
                    let axes = Columns { x: axis(x, k), y: inner, z: outer };
                    let step = Step { axes, rate: rate[k], acceleration: T::zero(), own: own[k] };
                    let (of, by_axis) = match <Self as Axial<T, $K>>::WAYS[k] {
                        Way::Turn => {
                            let found = step.turned_felt::<N>(&felt, &turning);
                            turning = step.before(turning);
                            found
                        }
                        Way::Slide => step.slid_felt(position[k], x.z, &mut felt, &turning),
                    };
                    Self::add_axis(k, by_axis, sums);
                    (by[0][k], by[1][k]) = (by[0][k] + of[0], by[1][k] + of[1]);
                }
                *of_position = Listed::<T, $K>::from_list(by[0]);
                *of_rate = Listed::<T, $K>::from_list(by[1]);
                felt
            }
        }
    };
}
axial!([L] Prismatic<T, L>, 1);
axial!([L M] Cylindrical<T, L, M>, 2);
axial!([L M] Universal<T, L, M>, 2);
