//! The costate sweep in axes of bodies.
//!
//! What [`adjoint`](crate::mechanics::spatial::adjoint) carries are vectors of one instant, so its equations hold in any axes: between
//! [`BodyAxes`](super::BodyAxes) and [`Flange`](super::Flange) all that is carried and kept is in axes of the body that is met. In these P knows
//! no attitude but what lies beyond flanges: the costate of turns that is carried there is Δ = Θ − W × F − A × G, which bodies and arms
//! leave as it is, and which is nothing where there is no flange.

mod driven;
mod guarded;
pub mod joints;
pub mod links;
pub mod mounts;

use super::number::{Number, Triple, dot_onto, more, scaled, triple, values};
use crate::mechanics::spatial::adjoint::{Pulled, Turning};
use crate::relation::spatial::algebra::cross_onto;
use crate::scalar::Scalar;
use nalgebra::Vector3;

impl<T: Scalar> Pulled<T> {
    /// Where Δ is carried: the costate of turns of all that has been met against the motion W, A, ω, α, w of a station.
    #[inline(always)]
    fn in_own(&self, velocity: Vector3<T>, a: Vector3<T>, turning: &Turning<T>) -> Vector3<T> {
        let Turning { spin, acceleration, stirring } = *turning;
        let turn = cross_onto(spin, self.spin, self.of_place(velocity, a));
        cross_onto(acceleration, self.angular, cross_onto(stirring, self.torque, turn))
    }

    /// Δ + W × F + A × G: Θ.
    #[inline(always)]
    fn of_place(&self, velocity: Vector3<T>, a: Vector3<T>) -> Vector3<T> {
        cross_onto(velocity, self.force, cross_onto(a, self.momentum, self.turn))
    }
}

/// Adds ∂/∂ω of p · (ω × (ω × d)) for a vector d of which zeros are known: d (ω·p) + p (ω·d) − 2 ω (d·p).
#[cfg_attr(optimised, inline(always))]
fn swept_known<T: Scalar>(spin: Vector3<T>, d: Triple<T>, p: Triple<T>, sum: Vector3<T>) -> Vector3<T> {
    let (spin, none) = (triple(spin.into()), Number::zero());
    let across = dot_onto(d, p, none);
    let turned = more(scaled(d, dot_onto(spin, p, none)), dot_onto(spin, d, none), p);
    let turned = more(turned, across.plus(across).negated(), spin);
    let [x, y, z] = values(super::number::sum(turned, triple(sum.into())));
    Vector3::new(x, y, z)
}
