//! Places of the ground, which may move.

use crate::error::{Error, Fault};
use crate::scalar::Scalar;
use crate::space::{Frame, FrameOf, Space};

/// Motion of a point of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundMotion<T, const N: usize> {
    /// Place (m).
    pub place: [T; N],
    /// Velocity (m/s).
    pub velocity: [T; N],
    /// Acceleration (m/s²).
    pub acceleration: [T; N],
}

/// A place that may move as a given function of time.
pub trait Ground<T: Scalar, const N: usize> {
    /// The motion of the place at a time (s).
    fn at(&self, time: T::Real) -> GroundMotion<T, N>;
}

impl<T: Scalar, const N: usize> Ground<T, N> for [T; N] {
    fn at(&self, _: T::Real) -> GroundMotion<T, N> {
        let zero = [T::zero(); N];
        GroundMotion { place: *self, velocity: zero, acceleration: zero }
    }
}

/// A place given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Moving<F>(pub F);

impl<T: Scalar, const N: usize, F: Fn(T::Real) -> GroundMotion<T, N>> Ground<T, N> for Moving<F> {
    fn at(&self, time: T::Real) -> GroundMotion<T, N> {
        (self.0)(time)
    }
}

impl<T: Scalar, const N: usize> GroundMotion<T, N> {
    /// The frame of the ground at the place, unturned.
    pub(crate) fn frame<S: Space<Vector: From<[T; N]>>>(self) -> FrameOf<S> {
        let mut frame = Frame::resting(self.place.into());
        frame.velocity = self.velocity.into();
        frame.acceleration.linear = self.acceleration.into();
        frame
    }

    /// Rejects a motion that is not finite.
    pub(crate) fn check(self) -> Result<(), Error> {
        let Self { place, velocity, acceleration } = self;
        let finite = [place, velocity, acceleration].iter().flatten().all(|x| x.is_finite());
        let fault = Error::new(Fault::NotFinite { parameter: "motion of the ground" });
        if finite { Ok(()) } else { Err(fault) }
    }
}
