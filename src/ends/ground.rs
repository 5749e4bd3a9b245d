//! What the ground prescribes to ends: places and attitudes, which may move as functions of time.

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

/// A motion of the ground that is given as a function of time: `M` is `GroundMotion<T>` for a place, and for an attitude `[T; 3]` in the plane
/// (angle (rad), rate (rad/s), angular acceleration (rad/s²)), `AttitudeMotion<T>` in space.
pub trait Ground<T: Scalar, M> {
    /// Whether the ground is known to rest.
    const RESTS: bool = false;

    /// The motion at a time (s).
    fn at(&self, time: T::Real) -> M;
}

impl<T: Scalar, const N: usize> Ground<T, GroundMotion<T, N>> for [T; N] {
    const RESTS: bool = true;

    fn at(&self, _: T::Real) -> GroundMotion<T, N> {
        let zero = [T::zero(); N];
        GroundMotion { place: *self, velocity: zero, acceleration: zero }
    }
}

/// A place given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Moving<F>(pub F);

impl<T: Scalar, const N: usize, F: Fn(T::Real) -> GroundMotion<T, N>> Ground<T, GroundMotion<T, N>> for Moving<F> {
    fn at(&self, time: T::Real) -> GroundMotion<T, N> {
        (self.0)(time)
    }
}

/// An attitude given as a function of time.
#[derive(Clone, Copy, Debug)]
pub struct Turning<F>(pub F);

impl<T: Scalar, M, F: Fn(T::Real) -> M> Ground<T, M> for Turning<F> {
    fn at(&self, time: T::Real) -> M {
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
