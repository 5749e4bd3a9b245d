//! Taylor series in the plane: what joints do.

use super::Articulated;
use crate::mechanics::planar::{Acceleration, ElasticHinge, Internal, Joint, Pin, Planar, Turn, Weld};
use crate::relation::planar::algebra::{add_scaled, plus_dot};
use crate::relation::{Absent, Coefficient, Part, Symmetric, Term};
use crate::scalar::Scalar;
use crate::series::Order;
use crate::shape::{Of, Takes};
use crate::spring::{Spring, SpringLaw};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector2;

/// What a joint keeps.
#[derive(Clone, Copy, Debug)]
pub struct JointSeries<T> {
    /// −1 / D, and how the acceleration of its coordinate (of its outboard body, where it turns) depends on that of the station.
    pub(super) minus_inverse: T,
    pub(super) gain: Vector2<T>,
    /// How the acceleration along a line depends on the angular one.
    pub(super) gain_of_turning: T,
    /// The acceleration of the present order if the station stays where it is.
    pub(super) free: T,
    /// Where the coordinate sets out.
    pub(super) place: T,
    /// Coefficients of coordinate and rate of the present order, and what spring and damper make of them.
    now: [T; 2],
    pub(super) effort: T,
}

impl<T: Scalar> JointSeries<T> {
    pub(super) fn new() -> Self {
        let zero = T::zero();
        let gain = Vector2::new(zero, zero);
        Self { minus_inverse: zero, gain, gain_of_turning: zero, free: zero, place: zero, now: [zero; 2], effort: zero }
    }

    /// Keeps coordinate and rate, and what spring and damper make of them.
    #[inline(always)]
    pub(super) fn start(&mut self, now: [T; 2], law: &impl AffineLaw<T>) {
        (self.place, self.now, self.effort) = (now[0], now, law.force(now[0], now[1]));
    }

    /// Eliminates the rotation.
    #[inline(always)]
    fn loosen(&mut self, Articulated { linear, coupling, angular }: Articulated<T>) -> Articulated<T> {
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

    /// What spring and damper make of the next order, after an acceleration of the coordinate.
    #[inline(always)]
    pub(super) fn strain(&mut self, order: &Order<T::Real>, acceleration: T, law: &impl AffineLaw<T>) {
        let [_, rate] = self.now;
        self.now = [rate.scale(order.once), acceleration.scale(order.once)];
        self.effort = law.change(self.now[0], self.now[1]);
    }
}

impl<T: Scalar, const N: usize> Takes<Planar<T>, Begin<N>> for Pin {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (_, _, (position, rate), _): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        Joint::turned(self, position, rate, turn)
    }
}

impl<T: Scalar, const N: usize> Takes<Planar<T>, Articulate<N>> for Pin {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Articulate<N>,
        outer: Articulated<T>,
        ((), room): Of<'_, Planar<T>, Articulate<N>, Self>,
    ) -> Articulated<T> {
        room.loosen(outer)
    }
}

impl<T: Scalar, Q: Term<T>, const N: usize> Takes<Planar<T>, Push<Planar<T>, Q, N>> for Pin {
    #[inline(always)]
    fn take(
        &self,
        Push(order, _): &mut Push<Planar<T>, Q, N>,
        outer: Internal<T>,
        (((), room), efforts): Of<'_, Planar<T>, Push<Planar<T>, Q, N>, Self>,
    ) -> Internal<T> {
        let effort = efforts[order.k];
        Internal { force: room.release(outer.force, effort.take_from(outer.torque)), torque: effort.add_to(T::zero()) }
    }
}

impl<T: Scalar, const N: usize> Takes<Planar<T>, Swing<Planar<T>, N>> for Pin {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Swing<Planar<T>, N>,
        inboard: Acceleration<T>,
        (((), room), acceleration): Of<'_, Planar<T>, Swing<Planar<T>, N>, Self>,
    ) -> Acceleration<T> {
        *acceleration = room.angular(inboard.linear);
        Acceleration { angular: *acceleration, ..inboard }
    }
}

impl<T: Scalar, const N: usize> Takes<Planar<T>, Begin<N>> for Weld<T> {
    #[inline(always)]
    fn take(&self, _: &mut Begin<N>, turn: Turn<T>, _: Of<'_, Planar<T>, Begin<N>, Self>) -> Turn<T> {
        Joint::turned(self, &(), &(), turn)
    }
}

/// Walks that a weld hands on.
macro_rules! welded {
    ($([$($Q:ident)?] $Walk:ty: $Carried:ty),*) => {$(
        impl<T: Scalar, $($Q: Part,)? const N: usize> Takes<Planar<T>, $Walk> for Weld<T> {
            #[inline(always)]
            fn take(&self, _: &mut $Walk, carried: $Carried, _: Of<'_, Planar<T>, $Walk, Self>) -> $Carried {
                carried
            }
        }
    )*};
}
welded!([] Articulate<N>: Articulated<T>, [Q] Push<Planar<T>, Q, N>: Internal<T>, [] Swing<Planar<T>, N>: Acceleration<T>);

/// A law that is affine in coordinate and rate: that of its coefficients is the same without what is constant.
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

impl<T: Scalar, L: AffineLaw<T>, const N: usize> Takes<Planar<T>, Begin<N>> for ElasticHinge<L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (_, _, (position, rate), ((), room)): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        room.start([*position, *rate], &self.rotary);
        Joint::turned(self, position, rate, turn)
    }
}

impl<T: Scalar, L: AffineLaw<T>, const N: usize> Takes<Planar<T>, Articulate<N>> for ElasticHinge<L> {
    #[inline(always)]
    fn take(
        &self,
        _: &mut Articulate<N>,
        outer: Articulated<T>,
        ((), room): Of<'_, Planar<T>, Articulate<N>, Self>,
    ) -> Articulated<T> {
        room.loosen(outer)
    }
}

impl<T: Scalar, L: AffineLaw<T>, Q: Term<T>, const N: usize> Takes<Planar<T>, Push<Planar<T>, Q, N>>
    for ElasticHinge<L>
{
    #[inline(always)]
    fn take(
        &self,
        Push(order, _): &mut Push<Planar<T>, Q, N>,
        outer: Internal<T>,
        (((), room), efforts): Of<'_, Planar<T>, Push<Planar<T>, Q, N>, Self>,
    ) -> Internal<T> {
        let torque = efforts[order.k].add_to(room.effort);
        Internal { force: room.release(outer.force, outer.torque - torque), torque }
    }
}

impl<T: Scalar, L: AffineLaw<T>, const N: usize> Takes<Planar<T>, Swing<Planar<T>, N>> for ElasticHinge<L> {
    #[inline(always)]
    fn take(
        &self,
        Swing(order): &mut Swing<Planar<T>, N>,
        inboard: Acceleration<T>,
        (((), room), acceleration): Of<'_, Planar<T>, Swing<Planar<T>, N>, Self>,
    ) -> Acceleration<T> {
        let angular = room.angular(inboard.linear);
        *acceleration = angular - inboard.angular;
        room.strain(order, *acceleration, &self.rotary);
        Acceleration { angular, ..inboard }
    }
}
