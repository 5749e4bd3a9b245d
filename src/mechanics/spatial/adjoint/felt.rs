//! The costate sweep in space: what closures read, places and attitudes of stations, and their velocities.
//!
//! With X, Y and Ω the costates of the place p, of the velocity v and of the angular velocity of a station, all that lies outboard of a body
//! reads its arm d by X·(p + d) + Y·(v + ω × d), and Θ is what a turn of all that has been met since the last balls, with its ω, does:
//!
//! ```text
//! Θ ← Θ + d × X + (ω × d) × Y        Ω ← Ω + d × Y        d̄ = X − ω × Y
//! ball       Ψ̄ = Aᵀ Θ                ω̄ = Aᵀ Ω             then Θ = Ω = 0
//! revolute   q̄ = s·(Θ − ω × Ω)       q̇⁻ = s·Ω             Θ_I = Θ_O − s × X, of both brackets, with X = −q̇ Ω
//! ```

use super::revolute::of_axis;
use crate::adjoint::laws::ReversibleLaw;
use crate::mechanics::spatial::{Ball, PointMass, Revolute, RigidBody, Rod, Spatial, Weld, Wrench};
use crate::relation::spatial::algebra::{add_scaled, cross, cross_onto, dot, zero};
use crate::relation::{Absent, Additive};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::pull_loads::PullLoads;
use core::ops::Add;
use nalgebra::Vector3;

/// Costates of a station, by what closures read outboard of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt<T> {
    /// X, of its place.
    pub(super) place: Vector3<T>,
    /// Y, of its velocity.
    pub(super) velocity: Vector3<T>,
    /// Θ, of turns of all that has been met since the last balls, with its ω.
    pub(super) turn: Vector3<T>,
    /// Ω, of its angular velocity.
    pub(super) spin: Vector3<T>,
}

impl<T: Scalar> Felt<T> {
    /// Of an end that turns with ω, from the costates of its place and attitude and of its velocities.
    #[inline(always)]
    pub(super) fn at(of_place: Wrench<T>, of_velocity: Wrench<T>, spin: Vector3<T>) -> Self {
        let turn = cross_onto(spin, of_velocity.torque, of_place.torque);
        Self { place: of_place.force, velocity: of_velocity.force, turn, spin: of_velocity.torque }
    }
    /// The costate of a turn of all that has been met since the last balls, where the body on the inboard side turns with ω as it does: a
    /// rotation vector, inertial axes.
    #[inline(always)]
    pub(super) fn turned(&self, spin: Vector3<T>) -> Vector3<T> {
        self.turn - cross(spin, self.spin)
    }
}

impl<T: Scalar> Add for Felt<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            place: self.place + other.place,
            velocity: self.velocity + other.velocity,
            turn: self.turn + other.turn,
            spin: self.spin + other.spin,
        }
    }
}

impl<T: Scalar> Additive for Felt<T> {
    fn null() -> Self {
        Self { place: zero(), velocity: zero(), turn: zero(), spin: zero() }
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar> Takes<Spatial<T>, PullLoads<Absent, T>> for $Body<T> {
            fn take(
                &self,
                _: &mut PullLoads<Absent, T>,
                outer: Felt<T>,
                (_, _, &arm, _, _, ((frame, _), ..), (sums, ()), _): Of<'_, Spatial<T>, PullLoads<Absent, T>, Self>,
            ) -> Felt<T> {
                let (Felt { place, velocity, turn, spin: of_spin }, spin) = (outer, frame.turn.spin);
                let of_arm = frame.turn.attitude.transposed(place - cross(spin, velocity));
                sums.iter_mut().zip(of_arm.iter()).for_each(|(sum, more)| *sum += *more);
                let turn = cross_onto(arm, place, cross_onto(cross(spin, arm), velocity, turn));
                Felt { turn, spin: cross_onto(arm, velocity, of_spin), ..outer }
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

impl<T: Scalar> Takes<Spatial<T>, PullLoads<Absent, T>> for Ball {
    fn take(
        &self,
        _: &mut PullLoads<Absent, T>,
        outer: Felt<T>,
        (attitude, .., (of_position, of_rate)): Of<'_, Spatial<T>, PullLoads<Absent, T>, Self>,
    ) -> Felt<T> {
        *of_position = attitude.transposed_onto(outer.turn, Vector3::from(*of_position)).into();
        *of_rate = attitude.transposed_onto(outer.spin, Vector3::from(*of_rate)).into();
        Felt { turn: zero(), spin: zero(), ..outer }
    }
}

impl<T: Scalar> Takes<Spatial<T>, PullLoads<Absent, T>> for Weld<T> {
    fn take(
        &self,
        _: &mut PullLoads<Absent, T>,
        outer: Felt<T>,
        (attitude, .., (.., kept, _), (_, sums), _): Of<'_, Spatial<T>, PullLoads<Absent, T>, Self>,
    ) -> Felt<T> {
        sums.turn = attitude.transposed_onto(outer.turned(kept.spin), sums.turn);
        outer
    }
}

impl<T: Scalar, L: ReversibleLaw<T>> Takes<Spatial<T>, PullLoads<Absent, T>> for Revolute<T, L> {
    fn take(
        &self,
        _: &mut PullLoads<Absent, T>,
        outer: Felt<T>,
        (axes, .., (_, rate, _), (.., kept, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullLoads<Absent, T>,
            Self,
        >,
    ) -> Felt<T> {
        let turned = outer.turned(kept.spin);
        *of_position += dot(axes.x, turned);
        *of_rate += dot(axes.x, outer.spin);
        of_axis(axes, turned, add_scaled(zero(), -*rate, outer.spin), &mut sums.turn);
        outer
    }
}
