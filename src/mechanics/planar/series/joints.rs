//! Taylor series in the plane: what joints do.

use super::Articulated;
use crate::mechanics::planar::{Acceleration, ElasticHinge, Internal, Joint, Pin, Planar, Turn, Weld};
use crate::relation::planar::algebra::{add_scaled, plus_dot};
use crate::relation::{Closures, Cuts, Part, Symmetric, Term};
use crate::scalar::Scalar;
use crate::series::{AffineLaw, Strain};
use crate::shape::{Of, Takes};
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
    /// What spring and damper make of coordinate and rate.
    pub(super) strain: Strain<T>,
}

impl<T: Scalar> JointSeries<T> {
    pub(super) fn new() -> Self {
        let zero = T::zero();
        let gain = Vector2::new(zero, zero);
        Self { minus_inverse: zero, gain, gain_of_turning: zero, free: zero, place: zero, strain: Strain::none() }
    }

    /// Eliminates the rotation.
    #[cfg_attr(optimised, inline(always))]
    fn loosen<C: Closures>(
        &mut self,
        Articulated { linear, coupling, angular }: Articulated<T>,
        cuts: &mut Cuts<Internal<T>, T, C>,
        columns: &mut C::Each<Internal<T>>,
    ) -> Articulated<T> {
        self.minus_inverse = -angular.recip();
        self.gain = coupling * self.minus_inverse;
        *columns = C::map(&cuts.columns, |w| w);
        let moved = |w: Internal<T>, _| Internal { force: add_scaled(w.force, w.torque, self.gain), torque: T::zero() };
        (*cuts, _) = cuts.eliminated(self.minus_inverse, T::zero(), |w| w.torque, moved);
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
    fn angular<C: Closures>(&self, linear: Vector2<T>, columns: &C::Each<Internal<T>>, forces: &C::Each<T>) -> T {
        plus_dot(self.held::<C>(columns, forces), self.gain, linear)
    }

    /// The acceleration of the present order under closure forces if the station stays where it is.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn held<C: Closures>(&self, columns: &C::Each<Internal<T>>, forces: &C::Each<T>) -> T {
        let mut free = self.free;
        C::zip(columns, forces, |w, by| free = (w.torque * self.minus_inverse).mul_add(by, free));
        free
    }
}

impl<T: Scalar, const N: usize> Takes<Planar<T>, Begin<N>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (_, _, _, (position, rate), _): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        Joint::turned(self, position, rate, turn)
    }
}

impl<T: Scalar, C: Closures, const N: usize> Takes<Planar<T>, Articulate<Planar<T>, N, C>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Planar<T>, N, C>,
        outer: Articulated<T>,
        ((), room, columns): Of<'_, Planar<T>, Articulate<Planar<T>, N, C>, Self>,
    ) -> Articulated<T> {
        room.loosen(outer, cuts, columns)
    }
}

impl<T: Scalar, Q: Term<T>, C: Closures, const N: usize> Takes<Planar<T>, Push<Planar<T>, Q, N, C>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Planar<T>, Q, N, C>,
        outer: Internal<T>,
        (((), room, columns), efforts): Of<'_, Planar<T>, Push<Planar<T>, Q, N, C>, Self>,
    ) -> Internal<T> {
        let effort = efforts[order.k];
        let force = room.release(outer.force, effort.take_from(outer.torque));
        *gaps = C::zip(gaps, columns, |gap, w| (-w.torque).mul_add(room.free, gap));
        Internal { force, torque: effort.add_to(T::zero()) }
    }
}

impl<T: Scalar, C: Closures, const N: usize> Takes<Planar<T>, Swing<Planar<T>, N, C>> for Pin {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { forces, .. }: &mut Swing<Planar<T>, N, C>,
        inboard: Acceleration<T>,
        (((), room, columns), acceleration): Of<'_, Planar<T>, Swing<Planar<T>, N, C>, Self>,
    ) -> Acceleration<T> {
        *acceleration = room.angular::<C>(inboard.linear, columns, forces);
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
        impl<T: Scalar, $($Q: Part,)? C: Closures, const N: usize> Takes<Planar<T>, $Walk> for Weld<T> {
            #[inline(always)]
            fn take(&self, _: &mut $Walk, carried: $Carried, _: Of<'_, Planar<T>, $Walk, Self>) -> $Carried {
                carried
            }
        }
    )*};
}
welded!(
    [] Articulate<Planar<T>, N, C>: Articulated<T>,
    [Q] Push<Planar<T>, Q, N, C>: Internal<T>,
    [] Swing<Planar<T>, N, C>: Acceleration<T>
);

impl<T: Scalar, L: AffineLaw<T>, const N: usize> Takes<Planar<T>, Begin<N>> for ElasticHinge<L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (_, _, _, (position, rate), ((), room)): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        room.strain = Strain::begin([*position, *rate], &self.rotary);
        Joint::turned(self, position, rate, turn)
    }
}

impl<T: Scalar, L: AffineLaw<T>, C: Closures, const N: usize> Takes<Planar<T>, Articulate<Planar<T>, N, C>>
    for ElasticHinge<L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Planar<T>, N, C>,
        outer: Articulated<T>,
        ((), room, columns): Of<'_, Planar<T>, Articulate<Planar<T>, N, C>, Self>,
    ) -> Articulated<T> {
        room.loosen(outer, cuts, columns)
    }
}

impl<T: Scalar, L: AffineLaw<T>, Q: Term<T>, C: Closures, const N: usize> Takes<Planar<T>, Push<Planar<T>, Q, N, C>>
    for ElasticHinge<L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Planar<T>, Q, N, C>,
        outer: Internal<T>,
        (((), room, columns), efforts): Of<'_, Planar<T>, Push<Planar<T>, Q, N, C>, Self>,
    ) -> Internal<T> {
        let torque = efforts[order.k].add_to(room.strain.effort);
        let force = room.release(outer.force, outer.torque - torque);
        *gaps = C::zip(gaps, columns, |gap, w| (-w.torque).mul_add(room.free, gap));
        Internal { force, torque }
    }
}

impl<T: Scalar, L: AffineLaw<T>, C: Closures, const N: usize> Takes<Planar<T>, Swing<Planar<T>, N, C>>
    for ElasticHinge<L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces }: &mut Swing<Planar<T>, N, C>,
        inboard: Acceleration<T>,
        (((), room, columns), acceleration): Of<'_, Planar<T>, Swing<Planar<T>, N, C>, Self>,
    ) -> Acceleration<T> {
        let angular = room.angular::<C>(inboard.linear, columns, forces);
        *acceleration = angular - inboard.angular;
        room.strain.follow(order, *acceleration, &self.rotary);
        Acceleration { angular, ..inboard }
    }
}
