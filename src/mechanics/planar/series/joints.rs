//! Taylor series in the plane: what joints do.

use super::{Articulated, Pushed, Swung, applied_onto};
use crate::mechanics::planar::{Acceleration, ElasticHinge, Internal, Joint, Pin, Planar, Turn, Weld};
use crate::relation::planar::algebra::{add_scaled, plus_dot};
use crate::relation::{Closures, Cuts, Symmetric, Term};
use crate::scalar::Scalar;
use crate::series::{ExpandLaw, ExpandLoads, Strain};
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector2;

/// What a joint keeps.
#[derive(Clone, Copy, Debug)]
pub struct JointSeries<T, const N: usize> {
    /// −1 / D, and how the acceleration of its coordinate (of its outboard body, where it turns) depends on that of the station.
    pub(super) minus_inverse: T,
    pub(super) gain: Vector2<T>,
    /// 1 + gain ⊗ lever of the body that begins outboard, by columns, and its transpose: F where it ends as felt inboard, and a as it moves it.
    pub(super) through: [[Vector2<T>; 2]; 2],
    /// How the acceleration of the coordinate depends on the force where the body that begins outboard ends.
    pub(super) gain_of_force: Vector2<T>,
    /// How the acceleration along a line depends on the angular one.
    pub(super) gain_of_turning: T,
    /// The acceleration of the present order if the station stays where it is.
    pub(super) free: T,
    /// Where the coordinate sets out.
    pub(super) place: T,
    /// What spring and damper make of coordinate and rate.
    pub(super) strain: Strain<T, N>,
}

impl<T: Scalar, const N: usize> JointSeries<T, N> {
    pub(super) fn new() -> Self {
        let zero = T::zero();
        let gain = Vector2::new(zero, zero);
        Self {
            minus_inverse: zero,
            gain,
            through: [[gain; 2]; 2],
            gain_of_force: gain,
            gain_of_turning: zero,
            free: zero,
            place: zero,
            strain: Strain::none(),
        }
    }

    /// Eliminates the rotation.
    #[cfg_attr(optimised, inline(always))]
    fn loosen<C: Closures>(
        &mut self,
        Articulated { linear, coupling, angular, lever }: Articulated<T>,
        cuts: &mut Cuts<Internal<T>, T, C>,
        columns: &mut C::Each<Internal<T>>,
    ) -> Articulated<T> {
        self.minus_inverse = -angular.recip();
        self.gain = coupling * self.minus_inverse;
        if let Some(lever) = lever {
            let (one, zero, gain) = (T::one(), T::zero(), self.gain);
            let unit = [Vector2::new(one, zero), Vector2::new(zero, one)];
            let sheared = |v: Vector2<T>, by: Vector2<T>| [add_scaled(unit[0], by.x, v), add_scaled(unit[1], by.y, v)];
            self.through = [sheared(gain, lever), sheared(lever, gain)];
            self.gain_of_force = lever * self.minus_inverse;
        }
        *columns = C::map(&cuts.columns, |w| w);
        let moved = |w: Internal<T>, _| Internal { force: add_scaled(w.force, w.torque, self.gain), torque: T::zero() };
        (*cuts, _) = cuts.eliminated(self.minus_inverse, T::zero(), |w| w.torque, moved);
        let zero = T::zero();
        Articulated {
            linear: linear.plus_outer(coupling, self.gain),
            coupling: Vector2::new(zero, zero),
            angular: zero,
            lever: None,
        }
    }

    /// Frees the rotation of the torque that is missed, given that which is known: the force inboard.
    #[cfg_attr(optimised, inline(always))]
    fn release(&mut self, outer: Pushed<T>, missed: impl FnOnce(T) -> T) -> Vector2<T> {
        if let Pushed::Levered { known, force, .. } = outer {
            let missed = missed(known.torque);
            self.free = plus_dot(missed * self.minus_inverse, self.gain_of_force, force);
            return applied_onto(self.through[0], force, add_scaled(known.force, missed, self.gain));
        }
        let Internal { force, torque } = outer.felt();
        let missed = missed(torque);
        self.free = missed * self.minus_inverse;
        add_scaled(force, missed, self.gain)
    }

    /// Turns what lies outboard: its angular acceleration, under closure forces, and how it depends on the acceleration of the station.
    #[inline(always)]
    fn swing<C: Closures>(
        &self,
        inboard: Swung<T>,
        columns: &C::Each<Internal<T>>,
        forces: &C::Each<T>,
    ) -> (T, Swung<T>) {
        let free = self.held::<C>(columns, forces);
        let Acceleration { linear, .. } = inboard.acceleration();
        if let Swung::Still = inboard {
            return (free, Swung::At(Acceleration { linear, angular: free }));
        }
        let angular = plus_dot(free, self.gain, linear);
        (angular, Swung::Turned { at: Acceleration { linear, angular }, free, through: self.through[1] })
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

impl<T: Scalar, A: ExpandLoads<Planar<T>, N, InJoint: Term<T>>, C: Closures, const N: usize>
    Takes<Planar<T>, Push<Planar<T>, A, N, C>> for Pin
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Planar<T>, A, N, C>,
        outer: Pushed<T>,
        (((), room, columns), efforts, ()): Of<'_, Planar<T>, Push<Planar<T>, A, N, C>, Self>,
    ) -> Pushed<T> {
        let effort = order.among(efforts);
        let force = room.release(outer, |torque| effort.take_from(torque));
        *gaps = C::zip(gaps, columns, |gap, w| (-w.torque).mul_add(room.free, gap));
        // To add −0 changes nothing, and compilers leave it out.
        Pushed::Felt(Internal { force, torque: effort.add_to(-T::zero()) })
    }
}

impl<T: Scalar, A: ExpandLoads<Planar<T>, N>, C: Closures, const N: usize> Takes<Planar<T>, Swing<Planar<T>, A, N, C>>
    for Pin
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { forces, .. }: &mut Swing<Planar<T>, A, N, C>,
        inboard: Swung<T>,
        (((), room, columns), acceleration, ()): Of<'_, Planar<T>, Swing<Planar<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let (angular, swung) = room.swing::<C>(inboard, columns, forces);
        *acceleration = angular;
        swung
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
    ($([$($A:ident)?] $Walk:ty: $Carried:ty),*) => {$(
        impl<T: Scalar, $($A: ExpandLoads<Planar<T>, N>,)? C: Closures, const N: usize> Takes<Planar<T>, $Walk> for Weld<T> {
            #[inline(always)]
            fn take(&self, _: &mut $Walk, carried: $Carried, _: Of<'_, Planar<T>, $Walk, Self>) -> $Carried {
                carried
            }
        }
    )*};
}
welded!(
    [] Articulate<Planar<T>, N, C>: Articulated<T>,
    [A] Push<Planar<T>, A, N, C>: Pushed<T>,
    [A] Swing<Planar<T>, A, N, C>: Swung<T>
);

impl<T: Scalar, L: ExpandLaw<T, N>, const N: usize> Takes<Planar<T>, Begin<N>> for ElasticHinge<L> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        turn: Turn<T>,
        (_, _, _, (position, rate), ((), room)): Of<'_, Planar<T>, Begin<N>, Self>,
    ) -> Turn<T> {
        self.rotary.begin(&mut room.strain, *position, *rate);
        Joint::turned(self, position, rate, turn)
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, C: Closures, const N: usize> Takes<Planar<T>, Articulate<Planar<T>, N, C>>
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

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Planar<T>, N, InJoint: Term<T>>, C: Closures, const N: usize>
    Takes<Planar<T>, Push<Planar<T>, A, N, C>> for ElasticHinge<L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Planar<T>, A, N, C>,
        outer: Pushed<T>,
        (((), room, columns), efforts, ()): Of<'_, Planar<T>, Push<Planar<T>, A, N, C>, Self>,
    ) -> Pushed<T> {
        let torque = order.among(efforts).add_to(room.strain.effort);
        let force = room.release(outer, |known| known - torque);
        *gaps = C::zip(gaps, columns, |gap, w| (-w.torque).mul_add(room.free, gap));
        Pushed::Felt(Internal { force, torque })
    }
}

impl<T: Scalar, L: ExpandLaw<T, N>, A: ExpandLoads<Planar<T>, N>, C: Closures, const N: usize>
    Takes<Planar<T>, Swing<Planar<T>, A, N, C>> for ElasticHinge<L>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces, .. }: &mut Swing<Planar<T>, A, N, C>,
        inboard: Swung<T>,
        (((), room, columns), acceleration, ()): Of<'_, Planar<T>, Swing<Planar<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let (angular, swung) = room.swing::<C>(inboard, columns, forces);
        *acceleration = angular - inboard.acceleration().angular;
        self.rotary.follow(&mut room.strain, order, *acceleration);
        swung
    }
}
