//! Taylor series in the plane: what joints do.

use super::Articulated;
use crate::element::Posture;
use crate::mechanics::planar::{Acceleration, ElasticHinge, Internal, Joint, Pin, Planar, Turn, Weld};
use crate::relation::planar::algebra::{add_scaled, plus_dot};
use crate::relation::{Absent, Coefficient, Symmetric, Term};
use crate::scalar::Scalar;
use crate::series::{Expand, Instant, Order, Origin};
use crate::spring::{Spring, SpringLaw};
use nalgebra::Vector2;

/// What a joint that turns keeps.
#[derive(Clone, Copy, Debug)]
pub struct TurnSeries<T, const N: usize> {
    /// −1 / D, and how its angular acceleration depends on the acceleration of the station.
    minus_inverse: T,
    gain: Vector2<T>,
    /// The angular acceleration of the present order if the station stays where it is.
    free: T,
    /// Coefficients of its rate: number k is that of the power k + 1.
    rates: [T; N],
}

impl<T: Scalar, const N: usize> TurnSeries<T, N> {
    fn new() -> Self {
        let zero = T::zero();
        Self { minus_inverse: zero, gain: Vector2::new(zero, zero), free: zero, rates: [zero; N] }
    }

    /// Eliminates the rotation.
    #[inline(always)]
    fn factor(&mut self, Articulated { linear, coupling, angular }: Articulated<T>) -> Articulated<T> {
        self.minus_inverse = -angular.recip();
        self.gain = coupling * self.minus_inverse;
        let zero = T::zero();
        Articulated {
            linear: linear.plus_outer(coupling, self.gain),
            coupling: Vector2::new(zero, zero),
            angular: zero,
        }
    }

    /// Frees the rotation of what is missed of no torque.
    #[inline(always)]
    fn release(&mut self, force: Vector2<T>, missed: T) -> Vector2<T> {
        self.free = missed * self.minus_inverse;
        add_scaled(force, missed, self.gain)
    }

    /// The angular acceleration of the outboard body.
    #[inline(always)]
    fn angular(&self, linear: Vector2<T>) -> T {
        plus_dot(self.free, self.gain, linear)
    }

    /// Keeps the coefficient of the rate that an acceleration of the coordinate makes.
    #[inline(always)]
    fn keep(&mut self, order: &Order<T::Real>, acceleration: T) -> T {
        let rate = acceleration.scale(order.once);
        self.rates[order.k] = rate;
        rate
    }

    /// Angle and rate after a time (Horner's rule for both).
    #[inline(always)]
    fn sum(&self, at: Instant<'_, T::Real>, [position, rate, acceleration]: [T; 3]) -> [T; 2] {
        let (mut once, mut twice) = (T::zero(), T::zero());
        let Instant { time, shares } = at;
        for (coefficient, share) in self.rates[1..].iter().zip(&shares[2..]).rev() {
            once = coefficient.add_scaled(time, once);
            twice = coefficient.scale(*share).add_scaled(time, twice);
        }
        once = acceleration.add_scaled(time, once);
        twice = acceleration.scale(shares[1]).add_scaled(time, twice);
        [position.add_scaled(time, rate.add_scaled(time, twice)), rate.add_scaled(time, once)]
    }
}

impl<T: Scalar, const N: usize> Expand<Planar<T>, N> for Pin {
    type Room = TurnSeries<T, N>;

    fn room(&self) -> Self::Room {
        TurnSeries::new()
    }
    #[inline(always)]
    fn begin(
        &self,
        _: Posture<'_, Planar<T>, Self>,
        position: &T,
        rate: &T,
        turn: Turn<T>,
        _: &mut Self::Room,
    ) -> Turn<T> {
        Joint::turned(self, position, rate, turn)
    }
    #[inline(always)]
    fn factor(&self, outer: Articulated<T>, room: &mut Self::Room) -> Articulated<T> {
        room.factor(outer)
    }
    #[inline(always)]
    fn push(&self, _: &Order<T::Real>, outer: Internal<T>, room: &mut Self::Room) -> Internal<T> {
        Internal { force: room.release(outer.force, outer.torque), torque: T::zero() }
    }
    #[inline(always)]
    fn swing(
        &self,
        order: &Order<T::Real>,
        inboard: Acceleration<T>,
        room: &mut Self::Room,
        acceleration: &mut T,
    ) -> Acceleration<T> {
        let angular = room.angular(inboard.linear);
        room.keep(order, angular);
        *acceleration = angular;
        Acceleration { angular, ..inboard }
    }
    #[inline(always)]
    fn sum(
        room: &Self::Room,
        at: Instant<'_, T::Real>,
        origin: Origin<'_, Planar<T>, Self>,
        position: &mut T,
        rate: &mut T,
    ) {
        [*position, *rate] = room.sum(at, [*origin.position, *origin.rate, *origin.acceleration]);
    }
    #[inline(always)]
    fn show(room: &Self::Room, each: &mut impl FnMut(&[T])) {
        each(&room.rates[1..]);
    }
}

impl<T: Scalar, const N: usize> Expand<Planar<T>, N> for Weld<T> {
    type Room = ();

    fn room(&self) {}
    #[inline(always)]
    fn begin(&self, _: Posture<'_, Planar<T>, Self>, (): &(), (): &(), turn: Turn<T>, (): &mut ()) -> Turn<T> {
        Joint::turned(self, &(), &(), turn)
    }
    #[inline(always)]
    fn factor(&self, outer: Articulated<T>, (): &mut ()) -> Articulated<T> {
        outer
    }
    #[inline(always)]
    fn push(&self, _: &Order<T::Real>, outer: Internal<T>, (): &mut ()) -> Internal<T> {
        outer
    }
    #[inline(always)]
    fn swing(&self, _: &Order<T::Real>, inboard: Acceleration<T>, (): &mut (), (): &mut ()) -> Acceleration<T> {
        inboard
    }
    #[inline(always)]
    fn sum((): &(), _: Instant<'_, T::Real>, _: Origin<'_, Planar<T>, Self>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn show((): &(), _: &mut impl FnMut(&[T])) {}
}

/// A law that is affine in angle and rate: that of its coefficients is the same without what is constant.
pub trait AffineLaw<T: Scalar>: SpringLaw<T> {
    /// What coefficients of order one and more cause.
    fn change(&self, position: T, rate: T) -> T;
}

impl<T: Scalar> AffineLaw<T> for Absent {
    #[inline(always)]
    fn change(&self, _: T, _: T) -> T {
        T::zero()
    }
}

impl<T: Scalar, K: Coefficient<T>, D: Coefficient<T>, P: Term<T>> AffineLaw<T> for Spring<K, D, P> {
    #[inline(always)]
    fn change(&self, position: T, rate: T) -> T {
        self.unstrained().force(position, rate)
    }
}

/// What a hinge keeps.
#[derive(Clone, Copy, Debug)]
pub struct HingeSeries<T, const N: usize> {
    turn: TurnSeries<T, N>,
    /// Coefficients of its angle and rate of the present order.
    now: [T; 2],
    /// The torque that they cause.
    torque: T,
}

impl<T: Scalar, L: AffineLaw<T>, const N: usize> Expand<Planar<T>, N> for ElasticHinge<L> {
    type Room = HingeSeries<T, N>;

    fn room(&self) -> Self::Room {
        HingeSeries { turn: TurnSeries::new(), now: [T::zero(); 2], torque: T::zero() }
    }
    #[inline(always)]
    fn begin(
        &self,
        _: Posture<'_, Planar<T>, Self>,
        position: &T,
        rate: &T,
        turn: Turn<T>,
        room: &mut Self::Room,
    ) -> Turn<T> {
        room.now = [*position, *rate];
        room.torque = self.rotary.force(*position, *rate);
        Joint::turned(self, position, rate, turn)
    }
    #[inline(always)]
    fn factor(&self, outer: Articulated<T>, room: &mut Self::Room) -> Articulated<T> {
        room.turn.factor(outer)
    }
    #[inline(always)]
    fn push(&self, _: &Order<T::Real>, outer: Internal<T>, room: &mut Self::Room) -> Internal<T> {
        let force = room.turn.release(outer.force, outer.torque - room.torque);
        Internal { force, torque: room.torque }
    }
    #[inline(always)]
    fn swing(
        &self,
        order: &Order<T::Real>,
        inboard: Acceleration<T>,
        room: &mut Self::Room,
        acceleration: &mut T,
    ) -> Acceleration<T> {
        let angular = room.turn.angular(inboard.linear);
        *acceleration = angular - inboard.angular;
        let [_, rate] = room.now;
        room.now = [rate.scale(order.once), room.turn.keep(order, *acceleration)];
        room.torque = self.rotary.change(room.now[0], room.now[1]);
        Acceleration { angular, ..inboard }
    }
    #[inline(always)]
    fn sum(
        room: &Self::Room,
        at: Instant<'_, T::Real>,
        origin: Origin<'_, Planar<T>, Self>,
        position: &mut T,
        rate: &mut T,
    ) {
        [*position, *rate] = room.turn.sum(at, [*origin.position, *origin.rate, *origin.acceleration]);
    }
    #[inline(always)]
    fn show(room: &Self::Room, each: &mut impl FnMut(&[T])) {
        each(&room.turn.rates[1..]);
    }
}
