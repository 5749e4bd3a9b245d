//! Places of the ground, which may move.

use crate::error::{Error, Fault};
use crate::scalar::Scalar;
use crate::spatial::Frame;
use nalgebra::Vector3;

/// Motion of a point of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMotion<T> {
    /// Place (m).
    pub place: [T; 3],
    /// Velocity (m/s).
    pub velocity: [T; 3],
    /// Acceleration (m/s²).
    pub acceleration: [T; 3],
}

/// A place that may move as a given function of time.
pub trait Ground<T: Scalar> {
    /// Its motion at a time (s).
    fn at(&self, time: T::Real) -> GroundMotion<T>;
}

impl<T: Scalar> Ground<T> for [T; 3] {
    fn at(&self, _: T::Real) -> GroundMotion<T> {
        let zero = [T::zero(); 3];
        GroundMotion { place: *self, velocity: zero, acceleration: zero }
    }
}

/// A place given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Moving<F>(pub F);

impl<T: Scalar, F: Fn(T::Real) -> GroundMotion<T>> Ground<T> for Moving<F> {
    fn at(&self, time: T::Real) -> GroundMotion<T> {
        (self.0)(time)
    }
}

impl<T: Scalar> GroundMotion<T> {
    /// The frame of the ground at the place, unturned.
    pub(super) fn frame(self) -> Frame<T> {
        let Self { place, velocity, acceleration } = self;
        let mut frame = Frame::resting(Vector3::from(place));
        frame.velocity = Vector3::from(velocity);
        frame.acceleration.linear = Vector3::from(acceleration);
        frame
    }

    /// Rejects a motion that is not finite.
    pub(super) fn check(self) -> Result<(), Error> {
        let Self { place, velocity, acceleration } = self;
        let finite = [place, velocity, acceleration].iter().flatten().all(|x| x.is_finite());
        let fault = Error::new(Fault::NotFinite { parameter: "motion of the ground" });
        if finite { Ok(()) } else { Err(fault) }
    }
}
