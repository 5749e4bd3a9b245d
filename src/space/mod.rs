//! What elements of one space have in common, and the motion of a station.

mod budget;
mod readings;

pub use budget::Budget;
pub use readings::{Balance, MovingBody, MovingJoint};

use crate::loading::Seen;
use crate::mirror::Rate;
use crate::relation::{Acceleration, Additive, Angular, Geometry, VectorSpace, WrenchOf};
use crate::scalar::Scalar;
use core::fmt::Debug;

/// What elements of one space have in common. Implemented by `planar::Planar<T>` and `spatial::Spatial<T>`.
pub trait Space: Geometry {
    /// What a body's posture needs to know of its shape.
    type Size: Copy + Debug;
    /// First part of a posture.
    type X: Copy + Debug;
    /// Second part of a posture.
    type Y: Copy + Debug;
    /// Third part of a posture.
    type P: Copy + Debug;
    /// Fourth part of a posture.
    type Q: Copy + Debug;
    /// Orientation and angular velocity, as they are carried outward.
    type Turn: Orientation<Self::Angular>;
    /// A station: its motion, and its force and torque.
    type Station: Balance<Self> + Copy + Debug;
    /// Orientation of a body in angles (rad): one in the plane, three in space.
    type Angles: Copy + Debug;
    /// A body and its motion at an instant.
    type BodyMotion: Seen<Space = Self, Load = WrenchOf<Self>> + MovingBody<Self> + Debug;
    /// A joint and its motion at an instant.
    type JointMotion: Seen<Space = Self> + MovingJoint<Self> + Debug;
    /// Internal force and torque, as numbers that add up.
    type Numbers: Rate<Self::Scalar> + Copy;
    /// The relation of a free tip.
    type Nothing: Copy + Default;

    /// Nothing has been resolved yet: initial values of the stores of postures.
    fn blank() -> (Self::X, Self::Y, Self::P, Self::Q);
    /// The size of what has none.
    fn no_size() -> Self::Size;
    /// Numbers of a place.
    const PLACES: usize;
    /// Whether bodies turn about more than one axis.
    const TURNS_ABOUT_LINES: bool = false;

    /// Internal force and torque as numbers.
    fn numbers(internal: WrenchOf<Self>) -> Self::Numbers;
    /// Internal force and torque from their numbers.
    fn internal(numbers: Self::Numbers) -> WrenchOf<Self>;
}

/// A space that exists over the scalar `U` too.
pub trait SpaceOver<U: Scalar>: Space {
    /// This space over `U`.
    type Over: Space<Scalar = U>;
    /// Replaces the numbers of a vector.
    fn lift_vector(
        vector: Self::Vector,
        number: &mut impl FnMut(Self::Scalar) -> U,
    ) -> <Self::Over as Geometry>::Vector;
}

/// Names the time, step and tolerance of a space's scalar.
pub type RealOf<S> = <<S as Geometry>::Scalar as Scalar>::Real;

/// Motion of a station of a space.
pub type FrameOf<S> = Frame<<S as Geometry>::Vector, <S as Geometry>::Angular, <S as Space>::Turn>;

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
    /// Turned like this, at rest.
    fn at_rest(&self) -> Self;
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

    /// A frame at rest with this place and these axes.
    pub(crate) fn at_rest(&self) -> Self {
        Self { turn: self.turn.at_rest(), ..Self::resting(self.place) }
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
