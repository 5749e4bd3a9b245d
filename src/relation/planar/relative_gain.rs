//! What the elimination of a joint in the plane leaves behind whose coordinate is relative to the inboard body.

use super::pivots::Gain;
use crate::relation::{Closures, Open};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// What eliminating a coordinate s leaves behind that is relative to the inboard body, a stiff rotation or a displacement:
/// s̈ = free + w · a + w_α α + row · λ.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector2<T>: serde::Serialize, T: serde::Serialize, C::Each<T>: serde::Serialize",
        deserialize = "Vector2<T>: serde::Deserialize<'de>, T: serde::Deserialize<'de>, C::Each<T>: serde::Deserialize<'de>"
    ))
)]
pub struct RelativeGain<T: Copy, C: Closures = Open> {
    /// w (rad/m; of a displacement, without a unit).
    pub per_acceleration: Vector2<T>,
    /// w_α, for the angular acceleration of the inboard body (of a displacement, m).
    pub per_angular: T,
    /// s̈ at a station that does not accelerate (rad/s², m/s²).
    pub free: T,
    /// s̈ for each closure force.
    pub per_closure: C::Each<T>,
}

impl<T: Scalar, C: Closures> RelativeGain<T, C> {
    /// No gain yet; w_α is that of an absolute angle, which [`absolute`](Self::absolute) does not store again.
    pub fn blank() -> Self {
        let Gain { per_acceleration, free, per_closure } = Gain::<T, C>::blank();
        Self { per_acceleration, per_angular: -T::one(), free, per_closure }
    }

    /// Takes over the gain of an absolute angle, as one of the angle relative to the inboard body. For a gain that was blank and
    /// has taken nothing but such gains since: its constant is not stored again.
    #[inline(always)]
    pub fn absolute(&mut self, gain: Gain<T, C>) {
        let Gain { per_acceleration, free, per_closure } = gain;
        (self.per_acceleration, self.free, self.per_closure) = (per_acceleration, free, per_closure);
    }

    /// Whether the pivot of the gain resists: what velocities, loads and springs contribute may overflow where it does.
    pub fn is_finite(&self) -> bool {
        let w = self.per_acceleration;
        w.x.is_finite() && w.y.is_finite() && self.per_angular.is_finite()
    }

    /// The gain without what velocities, loads and springs contribute.
    #[inline(always)]
    pub fn homogeneous(&self) -> Self {
        Self { free: T::zero(), ..*self }
    }

    /// The angular acceleration (rad/s²) of the outboard body, for a gain taken over from an absolute angle.
    #[inline(always)]
    pub fn angular(&self, a: Vector2<T>, multipliers: &C::Each<T>) -> T {
        let Self { per_acceleration, free, per_closure, .. } = *self;
        Gain::<T, C> { per_acceleration, free, per_closure }.angular(a, multipliers)
    }

    /// s̈ (rad/s², m/s²) where the inboard body's end accelerates by `a` and turns with `angular`.
    #[cfg_attr(optimised, inline(always))]
    pub fn relative(&self, a: Vector2<T>, angular: T, multipliers: &C::Each<T>) -> T {
        let w = self.per_acceleration;
        let bound = self.per_angular.mul_add(angular, self.free);
        let open = w.x.mul_add(a.x, w.y.mul_add(a.y, bound));
        C::plus_dot(open, &self.per_closure, multipliers)
    }

    /// The gain of y, from that of a relation with x and y exchanged.
    #[inline(always)]
    pub fn swapped(self) -> Self {
        Self { per_acceleration: self.per_acceleration.yx(), ..self }
    }
}
