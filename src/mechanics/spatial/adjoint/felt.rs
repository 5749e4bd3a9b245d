//! The costate sweep in space: what closures and loads on bodies read, places and attitudes of stations, and their velocities.
//!
//! With X, Y, F, Ω and M the costates of the place p, of the velocity v, of the virtual velocity W, of the angular velocity and of the
//! virtual one of a station, all that lies outboard of a body reads its arm d by X·(p + d) + Y·(v + ω × d) + F·(W + w × d), and Θ is what a
//! turn of all that has been met since the last balls, with its ω and w, does:
//!
//! ```text
//! Θ ← Θ + d × X + (ω × d) × Y + (w × d) × F        Ω ← Ω + d × Y        M ← M + d × F        d̄ = X − ω × Y − w × F
//! ball       Ψ̄ = Aᵀ Θ                        ω̄ = Aᵀ Ω             then Θ = Ω = M = 0
//! revolute   q̄ = s·(Θ − ω × Ω − w × M)       q̇⁻ = s·Ω             Θ_I = Θ_O − s × X, of both brackets, with X = −q̇ Ω − q̇_w M
//! ```
//!
//! Closures read nothing virtual: F and M are those of loads, which [`read`](super::read) adds.

use super::Turning;
use super::read::numbers;
use super::revolute::of_axis;
use crate::adjoint::laws::ReversibleLaw;
use crate::adjoint::{BodyLaw, ReversibleLoads};
use crate::mechanics::spatial::{Ball, PointMass, Revolute, RigidBody, Rod, Spatial, Weld, Wrench};
use crate::relation::Additive;
use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot, zero};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::pull_loads::PullLoads;
use core::ops::Add;
use nalgebra::Vector3;

/// Costates of a station, by what closures and loads read outboard of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt<T> {
    /// X, of its place.
    pub place: Vector3<T>,
    /// Y, of its velocity.
    pub velocity: Vector3<T>,
    /// F, of its virtual velocity.
    pub stirring: Vector3<T>,
    /// Θ, of turns of all that has been met since the last balls, with its ω and w.
    pub turn: Vector3<T>,
    /// Ω, of its angular velocity.
    pub spin: Vector3<T>,
    /// M, of its w.
    pub torque: Vector3<T>,
}

impl<T: Scalar> Felt<T> {
    /// Of an end that turns with ω, from the costates of its place and attitude and of its velocities.
    #[inline(always)]
    pub(super) fn at(of_place: Wrench<T>, of_velocity: Wrench<T>, spin: Vector3<T>) -> Self {
        let turn = cross_onto(spin, of_velocity.torque, of_place.torque);
        Self { place: of_place.force, velocity: of_velocity.force, turn, spin: of_velocity.torque, ..Self::null() }
    }
    /// The costate of a turn of all that has been met since the last balls, where the body on the inboard side turns with ω as it does: a
    /// rotation vector, inertial axes.
    #[inline(always)]
    pub fn turned(&self, spin: Vector3<T>) -> Vector3<T> {
        self.turn - cross(spin, self.spin)
    }
    /// The costate of such a turn under a law `L` of loads, where the body on the inboard side has the w of its own, too.
    #[inline(always)]
    pub fn turned_under<L: BodyLaw<Spatial<T>>>(&self, met: &Turning<T>) -> Vector3<T> {
        let turned = self.turned(met.spin);
        if const { L::ON } { turned - cross(met.stirring, self.torque) } else { turned }
    }
}

impl<T: Scalar> Felt<T> {
    /// In other axes.
    #[inline(always)]
    pub fn mapped(&self, axes: impl Fn(Vector3<T>) -> Vector3<T>) -> Self {
        let Self { place, velocity, stirring, turn, spin, torque } = *self;
        let (place, velocity, stirring) = (axes(place), axes(velocity), axes(stirring));
        Self { place, velocity, stirring, turn: axes(turn), spin: axes(spin), torque: axes(torque) }
    }

    /// Carried inward over an arm d of a body that turns so, to whose costate that of d is added.
    pub fn over(&self, d: Vector3<T>, Turning { spin, stirring, .. }: &Turning<T>, of_arm: &mut Vector3<T>) -> Self {
        let Self { place, velocity, stirring: force, .. } = *self;
        *of_arm += place - cross(*spin, velocity) - cross(*stirring, force);
        let turn = cross_onto(cross(*stirring, d), force, cross_onto(cross(*spin, d), velocity, self.turn));
        let (spin, torque) = (cross_onto(d, velocity, self.spin), cross_onto(d, force, self.torque));
        Self { turn: cross_onto(d, place, turn), spin, torque, ..*self }
    }
}

impl<T: Scalar> Add for Felt<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            place: self.place + other.place,
            velocity: self.velocity + other.velocity,
            stirring: self.stirring + other.stirring,
            turn: self.turn + other.turn,
            spin: self.spin + other.spin,
            torque: self.torque + other.torque,
        }
    }
}

impl<T: Scalar> Additive for Felt<T> {
    fn null() -> Self {
        let none = zero();
        Self { place: none, velocity: none, stirring: none, turn: none, spin: none, torque: none }
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, L: ReversibleLoads<Spatial<T>>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>> for $Body<T> {
            fn take(
                &self,
                walk: &mut PullLoads<L, Spatial<T>>,
                outer: Felt<T>,
                (_, _, &arm, _, _, ((frame, _), met, ..), (sums, ()), _): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
            ) -> Felt<T> {
                let Felt { place, velocity, stirring, turn, spin: of_spin, torque } = outer;
                let spin = frame.turn.spin;
                let of_arm = place - cross(spin, velocity);
                let swept = cross_onto(cross(spin, arm), velocity, turn);
                let felt = Felt { spin: cross_onto(arm, velocity, of_spin), ..outer };
                if const { !L::ON } {
                    let of_arm = frame.turn.attitude.transposed(of_arm);
                    sums.iter_mut().zip(of_arm.iter()).for_each(|(sum, more)| *sum += *more);
                    return Felt { turn: cross_onto(arm, place, swept), ..felt };
                }
                walk.body = walk.body.saturating_sub(1);
                let (w, moved) = (met.turning.stirring, cross(met.turning.stirring, arm));
                let of_arm = frame.turn.attitude.transposed(of_arm - cross(w, stirring));
                sums.iter_mut().zip(of_arm.iter()).for_each(|(sum, more)| *sum += *more);
                let more = L::felt(walk, numbers(self), frame, (met.velocity - moved, w), sums);
                Felt {
                    place: place + more.place,
                    velocity: velocity + more.velocity,
                    stirring: stirring + more.stirring,
                    turn: more.turn + cross_onto(arm, place, cross_onto(moved, stirring, swept)),
                    spin: felt.spin + more.spin,
                    torque: cross_onto(arm, stirring, torque + more.torque),
                }
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

impl<T: Scalar, L: BodyLaw<Spatial<T>>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>> for Ball {
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (attitude, .., (of_position, of_rate)): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        *of_position = attitude.transposed_onto(outer.turn, Vector3::from(*of_position)).into();
        *of_rate = attitude.transposed_onto(outer.spin, Vector3::from(*of_rate)).into();
        Felt { turn: zero(), spin: zero(), torque: zero(), ..outer }
    }
}

impl<T: Scalar, L: BodyLaw<Spatial<T>>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>> for Weld<T> {
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (attitude, .., (.., kept, _), (_, sums), _): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        sums.turn = attitude.transposed_onto(outer.turned_under::<L>(&kept.turning), sums.turn);
        outer
    }
}

impl<T: Scalar, L: BodyLaw<Spatial<T>>, R: ReversibleLaw<T>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>>
    for Revolute<T, R>
{
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (axes, .., (_, rate, own), (.., kept, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullLoads<L, Spatial<T>>,
            Self,
        >,
    ) -> Felt<T> {
        let turned = outer.turned_under::<L>(&kept.turning);
        *of_position += dot(axes.x, turned);
        *of_rate += dot(axes.x, outer.spin);
        let x = add_scaled(zero(), -*rate, outer.spin);
        let x = if const { L::ON } { add_scaled(x, -*own, outer.torque) } else { x };
        of_axis(axes, turned, x, &mut sums.turn);
        outer
    }
}
