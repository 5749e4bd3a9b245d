//! Turns in the plane, as vectors along z.

use super::{Frame, Planar, Turn};
use crate::scalar::Scalar;
use crate::turning::Turning;
use nalgebra::Vector2;

impl<T: Scalar> Turning for Planar<T> {
    type Orientation = T;
    type Spin = T;

    fn facing(turn: Turn<T>) -> Frame<T> {
        Frame { turn, ..Frame::resting(Vector2::new(T::zero(), T::zero())) }
    }
    fn still(turn: Turn<T>) -> Turn<T> {
        Turn { rate: T::zero(), ..turn }
    }
    fn spin(turn: &Turn<T>) -> [T; 3] {
        Self::in_inertial_axes(turn.rate)
    }
    fn in_inertial_axes(spin: T) -> [T; 3] {
        [T::zero(), T::zero(), spin]
    }
    fn in_axes_of(_: &Turn<T>, spin: T) -> [T; 3] {
        Self::in_inertial_axes(spin)
    }
    fn towards(here: &Turn<T>, there: &T) -> [T; 3] {
        Self::in_inertial_axes(*there - here.angle)
    }
    fn carrying(wanted: T, one: &Turn<T>, other: &Turn<T>) -> T {
        wanted - (other.angle - one.angle)
    }
    fn orientation_is_finite(orientation: &T) -> bool {
        orientation.is_finite()
    }
}
