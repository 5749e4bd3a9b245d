//! What elements of one space have in common.

mod budget;
mod frame;

pub use budget::Budget;
pub use frame::{Frame, Orientation};

use crate::error::Fault;
use crate::loading::Seen;
use crate::mirror::Rate;
use crate::relation::{Geometry, WrenchOf};
use crate::release::Release;
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
    type Station: Copy + Debug;
    /// Orientation of a body in angles (rad): one in the plane, three in space.
    type Angles: Copy + Debug;
    /// A body and its motion at an instant.
    type BodyMotion: Seen<Space = Self, Load = WrenchOf<Self>> + Debug;
    /// A joint and its motion at an instant.
    type JointMotion: Seen<Space = Self> + Debug;
    /// Internal force and torque, as numbers that add up.
    type Numbers: Rate<Self::Scalar> + Copy;
    /// The relation of a free tip.
    type Nothing: Copy + Default;

    /// Nothing has been resolved yet: initial values of the stores of postures.
    fn blank() -> (Self::X, Self::Y, Self::P, Self::Q);
    /// The size of what has none.
    fn no_size() -> Self::Size;

    /// The mass of a body (kg).
    fn mass(body: &Self::BodyMotion) -> Self::Scalar;
    /// What may be wrong with the inertia of a body.
    fn doubt(body: &Self::BodyMotion) -> Option<Fault>;
    /// Whether bodies turn about more than one axis.
    const TURNS_ABOUT_LINES: bool = false;
    /// Whether a body has no inertia about the line from its inboard to its outboard end, but for rounding. In the plane there is none.
    fn spins_about_its_line(body: &Self::BodyMotion) -> bool {
        let _ = body;
        false
    }

    /// The orientation of a body in angles.
    fn angles(body: &Self::BodyMotion) -> Self::Angles;
    /// The angle (rad) of a body that is too large for accurate sines, if it is.
    fn angle_out_of_range(body: &Self::BodyMotion) -> Option<f64>;
    /// The angle (rad) that a joint has turned by and that is too large for accurate sines, if it is.
    fn turn_out_of_range(joint: &Self::JointMotion, release: &Release<Self>) -> Option<f64>;
    /// Internal force and torque as numbers.
    fn numbers(internal: WrenchOf<Self>) -> Self::Numbers;
    /// Internal force and torque from their numbers.
    fn internal(numbers: Self::Numbers) -> WrenchOf<Self>;
    /// The inboard station of a body, with the body's inertia force in its balance.
    fn body_station(body: &Self::BodyMotion, gravity: Self::Vector) -> Self::Station;
    /// The inboard station of a joint.
    fn joint_station(joint: &Self::JointMotion) -> Self::Station;
    /// The inboard station of what closes a loop, which passes this force and torque on.
    fn closing_station(joint: &Self::JointMotion, internal: WrenchOf<Self>) -> Self::Station;
    /// The station at the end of a chain.
    fn end_station(frame: &FrameOf<Self>, internal: WrenchOf<Self>) -> Self::Station;
    /// Takes a load from the balance of forces at a body's inboard station.
    fn relieve(station: &mut Self::Station, load: WrenchOf<Self>);
    /// A force and a torque in axes of their body. In the plane no body asks for that.
    #[inline(always)]
    fn own_axes(body: &Self::BodyMotion, load: WrenchOf<Self>) -> WrenchOf<Self> {
        let _ = body;
        load
    }
    /// Closes the balance of a station, given the internal force at its outboard neighbour; gives its own.
    fn balance(station: &mut Self::Station, outer: WrenchOf<Self>) -> WrenchOf<Self>;
    /// Kinetic energy of reflected inertia in a joint, and energy stored there (J).
    fn stored(joint: &Self::JointMotion) -> [Self::Scalar; 2];
    /// Mechanical energy, linear momentum and angular momentum about the origin of a body.
    fn budget(body: &Self::BodyMotion, gravity: Self::Vector) -> Budget<Self>;
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
