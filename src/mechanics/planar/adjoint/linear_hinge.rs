//! The costate sweep in the plane: hinges with linear springs, among them the joint of a chain that floats.
//!
//! The hinge turns what lies at the outboard point, and that point moves along its [axes](super::hinge_axes).

use super::hinge_axes::{Along, Moved, ReversingAxes};
use super::loads::Felt;
use super::{AtJoint, LAW_NUMBERS, NUMBERS_OF_JOINT, Outboard, Pulled, Stirred, Turning};
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::{ReversibleLaw, force, strain};
use crate::element::Springs;
use crate::mechanics::planar::linear_hinge::{LinearGains, Rotation};
use crate::mechanics::planar::{Acceleration, ElasticHinge, Joint, Linear, Planar, Wrench};
use crate::relation::Closures;
use crate::relation::planar::algebra::{add_scaled, dot};
use crate::relation::planar::{Relation, RelativeGain, Slides};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector2;

/// Costates of the numbers of the rotary law, of those along both axes, and of the mass.
#[cfg_attr(optimised, inline(always))]
fn parts<T>(sums: &mut [T; NUMBERS_OF_JOINT]) -> [&mut [T]; 4] {
    let (rotary, rest) = sums.split_at_mut(LAW_NUMBERS);
    let (one, rest) = rest.split_at_mut(LAW_NUMBERS);
    let (other, mass) = rest.split_at_mut(LAW_NUMBERS);
    [rotary, one, other, mass]
}

/// Of a joint's coordinates those along its axes.
#[inline(always)]
fn slides<T: Scalar>(list: &(T, T, T)) -> Vector2<T> {
    Vector2::new(list.0, list.1)
}

/// How the outboard point moves on a body inboard of one that turns so.
#[cfg_attr(optimised, inline(always))]
fn moved<T: Scalar>(outer: Turning<T>, rate: &(T, T, T), acceleration: &(T, T, T), own: &(T, T, T)) -> Moved<T> {
    let turning = Turning {
        rate: outer.rate - rate.2,
        acceleration: outer.acceleration - acceleration.2,
        stirring: outer.stirring - own.2,
    };
    Moved { rate: slides(rate), acceleration: slides(acceleration), own: slides(own), turning }
}

impl<T, C, R, X, Y, A, By> Takes<Planar<T>, Factor<C, By>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    C: Closures,
    R: ReversibleLaw<T> + Rotation<T, By>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
    By: Springs<T> + Along<A>,
{
    fn take(
        &self,
        walk: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (x, y, p, q, (position, rate, led), effort, kept, _): Of<'_, Planar<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let (offset, springs) = (A::offset(x, y, p, q), walk.springs);
        macro_rules! law {
            ($law:expr, $k:tt) => {
                force($law, [position.$k, rate.$k], [led.0.$k, led.1.$k, led.2.$k], springs)
            };
        }
        let ([torque, turn], [fx, kx], [fy, ky]) =
            (law!(&self.rotary, 2), law!(&self.linear.x, 0), law!(&self.linear.y, 1));
        let outer = outer.relation.with_mass(self.linear.lumped);
        let of_turn = (outer.angular + turn).recip();
        let relation = self.rotary.turn(springs, *effort + torque, turn, outer, &mut kept.rotation).full();
        let relation = A::enter(relation, offset);
        let of_y = (relation.linear.yy + ky).recip();
        let (relation, y) = relation.swapped().slid(fy, ky);
        let relation = relation.swapped();
        let of_x = (relation.linear.xx + kx).recip();
        let (relation, x) = relation.slid(fx, kx);
        (kept.y, kept.x, kept.pivots) = (y.swapped(), x, [of_x, of_y, of_turn]);
        Outboard::rigid(A::leave(relation, offset))
    }
}

impl<T, R, X, Y, A, C: Closures> Takes<Planar<T>, Reach<T, C>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (x, y, p, q, kept, acceleration, (_, reached, _)): Of<'_, Planar<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        let outer = self.recovered::<C>(inner, A::offset(x, y, p, q), kept, &walk.forces, acceleration);
        *reached = outer.linear;
        outer
    }
}

impl<T, R, X, Y, A, C: Closures> Takes<Planar<T>, Meet<T, C>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, kept, _, costate, _): Of<'_, Planar<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let (offset, [of_x, of_y, of_turn]) = (A::offset(x, y, p, q), kept.pivots);
        let LinearGains { rotation, y, x, .. } = kept;
        let swung = A::swung(slides(costate), offset);
        let left = costate.2 - outer.torque;
        let (force, torque) = (add_scaled(outer.force, -left, rotation.per_acceleration), -left * rotation.per_angular);
        let (mut force, mut torque) = (A::components(force, offset), outer.torque + torque);
        costate.2 = left * of_turn;
        walk.part(&rotation.per_closure, left);
        let mut slide = |costate: &mut T, gain: &RelativeGain<T, C>, along: usize, pivot: T| {
            let left = *costate - force[along];
            force = add_scaled(force, -left, gain.per_acceleration);
            torque = (-left).mul_add(gain.per_angular, torque);
            *costate = left * pivot;
            walk.part(&gain.per_closure, left);
        };
        slide(&mut costate.1, y, 1, of_y);
        slide(&mut costate.0, x, 0, of_x);
        let Wrench { force, torque } = A::inward(Wrench { force: A::inertial(force, offset), torque }, offset);
        Wrench { force, torque: torque - swung }
    }
}

impl<T, R, X, Y, A, C: Closures> Takes<Planar<T>, Stir<T, C>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        inner: Stirred<T>,
        (x, y, p, q, kept, (_, rate, acceleration, free), (_, at_joint, _), torque): Of<
            '_,
            Planar<T>,
            Stir<T, C>,
            Self,
        >,
    ) -> Stirred<T> {
        let mut gains = Self::homogeneous::<C>(kept);
        (gains.x.free, gains.y.free, gains.rotation.free) = *free;
        let offset = A::at_rest(A::offset(x, y, p, q));
        let velocity = self.recovered::<C>(inner.velocity, offset, &gains, &walk.forces, free);
        let swing = A::swing(inner.velocity, offset);
        (free.0, free.1) = (free.0 - swing.x, free.1 - swing.y);
        *torque += free.2;
        let turning = Turning {
            rate: inner.turning.rate + rate.2,
            acceleration: inner.turning.acceleration + acceleration.2,
            stirring: velocity.angular,
        };
        *at_joint = AtJoint { turning, velocity: velocity.linear };
        Stirred { velocity, turning }
    }
}

impl<T, R, X, Y, A> Takes<Planar<T>, PullBack> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (x, y, p, q, motion, (_, a, _, kept, ..), (_, sums), (of_position, of_rate)): Of<'_, Planar<T>, PullBack, Self>,
    ) -> Pulled<T> {
        let ((position, rate, acceleration, own), mass) = (motion, self.linear.lumped);
        let turned = outer.turned(kept.turning);
        let at = Pulled {
            momentum: add_scaled(outer.momentum, mass, kept.velocity),
            force: add_scaled(outer.force, mass, *a),
            ..outer.summed(Some(turned))
        };
        let moved = moved(kept.turning, rate, acceleration, own);
        let ([of_slide, of_sliding], inner) = A::pull_back(A::offset(x, y, p, q), &moved, at);
        *of_position = (of_slide.x, of_slide.y, turned[0]);
        *of_rate = (of_sliding.x, of_sliding.y, turned[1]);
        let [rotary, one, other, lumped] = parts(sums);
        lumped[0] -= dot(*a, kept.velocity);
        macro_rules! law {
            ($law:expr, $k:tt, $sums:expr) => {
                let [more, also] = $law.pull_back(position.$k, rate.$k, own.$k, $sums);
                (of_position.$k, of_rate.$k) = (of_position.$k + more, of_rate.$k + also);
            };
        }
        if walk.laws {
            law!(self.rotary, 2, rotary);
            law!(self.linear.x, 0, one);
            law!(self.linear.y, 1, other);
        }
        inner
    }
}

impl<T, R, X, Y, A> Takes<Planar<T>, Strain<T>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut Strain<T>,
        (): (),
        (position, rate, w, sums, of_position, of_rate, led, of_led): Of<'_, Planar<T>, Strain<T>, Self>,
    ) {
        let [rotary, one, other, _] = parts(sums);
        macro_rules! law {
            ($L:ident, $law:expr, $k:tt, $sums:expr) => {
                let at = ([position.$k, rate.$k, w.$k], [led.0.$k, led.1.$k, led.2.$k]);
                let ([more, also], [q, v, a]) = strain(const { !$L::LINEAR }, $law, walk, at, $sums);
                (of_position.$k, of_rate.$k) = (of_position.$k + more, of_rate.$k + also);
                if const { !$L::LINEAR } {
                    (of_led.0.$k, of_led.1.$k, of_led.2.$k) = (of_led.0.$k + q, of_led.1.$k + v, of_led.2.$k + a);
                }
            };
        }
        law!(R, &self.rotary, 2, rotary);
        law!(X, &self.linear.x, 0, one);
        law!(Y, &self.linear.y, 1, other);
    }
}

impl<T, R, X, Y, A, C: Closures> Takes<Planar<T>, Burden<T, C>> for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        walk: &mut Burden<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, (), kept, pivot): Of<'_, Planar<T>, Burden<T, C>, Self>,
    ) -> Wrench<T> {
        let mut more = Self::still().1;
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, &*kept, pivot, &mut more, &mut ()));
        kept.x.free += more.0;
        kept.y.free += more.1;
        kept.rotation.free += more.2;
        inner
    }
}

impl<T, R, X, Y, A, L: BodyLaw<Planar<T>>> Takes<Planar<T>, PullLoads<L, Planar<T>>>
    for ElasticHinge<R, Linear<T, X, Y, A>>
where
    T: Scalar,
    R: ReversibleLaw<T>,
    X: ReversibleLaw<T>,
    Y: ReversibleLaw<T>,
    A: ReversingAxes,
{
    fn take(
        &self,
        _: &mut PullLoads<L, Planar<T>>,
        outer: Felt<T>,
        (x, y, p, q, (_, rate, own), (.., kept, _), _, (of_position, of_rate)): Of<
            '_,
            Planar<T>,
            PullLoads<L, Planar<T>>,
            Self,
        >,
    ) -> Felt<T> {
        let moved = moved(kept.turning, rate, &Self::still().1, own);
        let ([of_slide, of_sliding], [turn, spin]) = A::felt(A::offset(x, y, p, q), &moved, &outer);
        let [turned, spun] = outer.turn;
        *of_position = (of_position.0 + of_slide.x, of_position.1 + of_slide.y, of_position.2 + turned);
        *of_rate = (of_rate.0 + of_sliding.x, of_rate.1 + of_sliding.y, of_rate.2 + spun);
        Felt { turn: [turned + turn, spun + spin], ..outer }
    }
}
