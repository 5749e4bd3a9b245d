//! What elements of one space have in common.

mod budget;
mod frame;
mod readings;

pub use budget::Budget;
pub use frame::{Frame, Orientation};
pub use readings::{Balance, MovingBody, MovingJoint};

use crate::loading::Seen;
use crate::mirror::Rate;
use crate::relation::{Geometry, WrenchOf};
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
