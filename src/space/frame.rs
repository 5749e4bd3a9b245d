//! Motion of a station.

use crate::relation::{Acceleration, Additive, Angular, VectorSpace};
use core::fmt::Debug;

/// Motion of a station: a point of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<V, A, O> {
    /// Place of the point (m).
    pub place: V,
    /// Velocity of the point (m/s).
    pub velocity: V,
    /// Orientation and angular velocity of the body.
    pub turn: O,
    /// Acceleration of the point (m/s²) and angular acceleration of the body (rad/s²).
    pub acceleration: Acceleration<V, A>,
}

/// Orientation and angular velocity of a body, as they are carried outward.
pub trait Orientation<A>: Copy + Debug + 'static {
    /// Not turned, at rest.
    fn unturned() -> Self;
    /// Angular velocity ω (rad/s), inertial axes.
    fn spin(&self) -> A;
    /// Whether each number is finite.
    fn all_finite(&self) -> bool;
}

impl<V: Additive, A: Additive, O: Orientation<A>> Frame<V, A, O> {
    /// A frame at rest at a place, unturned.
    #[inline(always)]
    pub fn resting(place: V) -> Self {
        Self { place, velocity: V::null(), turn: O::unturned(), acceleration: Acceleration::zero() }
    }

    /// This motion with the accelerations left out.
    #[inline(always)]
    pub(crate) fn without_acceleration(&self) -> Self {
        Self { acceleration: Acceleration::zero(), ..*self }
    }
}

impl<V: VectorSpace, A: Angular<V>, O: Orientation<A>> Frame<V, A, O> {
    /// The frame at another point of the same body, at the vector `d` (inertial axes) from this one.
    #[cfg_attr(optimised, inline(always))]
    pub fn shifted(&self, d: V) -> Self {
        let spin = self.turn.spin();
        Self {
            place: self.place + d,
            velocity: spin.swing_onto(d, self.velocity),
            turn: self.turn,
            acceleration: self.acceleration.shifted(d, spin.centripetal(d)),
        }
    }

    /// The acceleration as seen by one that falls freely: a − g.
    #[inline(always)]
    pub fn falling(&self, gravity: V) -> Acceleration<V, A> {
        Acceleration { linear: self.acceleration.linear - gravity, ..self.acceleration }
    }

    /// Whether each number is finite.
    pub fn is_finite(&self) -> bool {
        let Acceleration { linear, angular } = self.acceleration;
        [self.place, self.velocity, linear].into_iter().all(VectorSpace::all_finite)
            && angular.all_finite()
            && self.turn.all_finite()
    }
}
