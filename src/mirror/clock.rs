//! The mirror of a coordinate that is a given function of time: a clock.

use super::{Position, Retraction, Term};
use crate::lift::Lift;
use crate::scalar::{Real, Scalar};
#[cfg(feature = "serde")]
use num_traits::One;

/// The time (s) of the motion that it is part of.
///
/// Rules drift positions by rates that last for a time, and that time is all that a clock reads of them: so it shows the time of each stage
/// without a rate of its own. It is neither counted, visited nor replaced.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent, bound(deserialize = "R: serde::Deserialize<'de> + One")))]
pub struct Clock<R> {
    time: R,
    /// How fast its time goes by: not at all where a scene is looked at as it stands, at rest.
    #[cfg_attr(feature = "serde", serde(skip, default = "One::one"))]
    pace: R,
}

impl<R: Real> Clock<R> {
    /// A clock that shows a time.
    pub(crate) fn at(time: R) -> Self {
        Self { time, pace: R::one() }
    }
    /// The time that it shows.
    #[inline(always)]
    pub(crate) fn time(&self) -> R {
        self.time
    }
    /// A function of time with its derivatives, by the time of the motion.
    #[inline(always)]
    pub(crate) fn told<T: Scalar<Real = R>>(&self, [x, first, second]: [T; 3]) -> [T; 3] {
        [x, first.scale(self.pace), second.scale(self.pace * self.pace)]
    }
}

impl<T: Scalar<Real = R>, R: Real> Retraction<T> for Clock<R> {
    type Rate = ();
}

impl<T: Scalar<Real = R>, R: Real> Position<T> for Clock<R> {
    const CLOCKED: bool = true;

    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, ()): Term<'_, T, ()>) {
        *self = Self { time: from.time + time, ..*from };
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, rate: Term<'_, T, ()>, _: Term<'_, T, ()>) {
        Position::<T>::drift_0(self, from, rate);
    }
    #[inline(always)]
    fn drift_2(&mut self, from: &Self, rate: Term<'_, T, ()>, _: Term<'_, T, ()>, _: Term<'_, T, ()>) {
        Position::<T>::drift_0(self, from, rate);
    }
    #[inline(always)]
    fn displace(&mut self, (): &()) {}
    #[inline(always)]
    fn apart(&self, _: &Self, (): &mut ()) {}
    #[inline(always)]
    fn measure(&self, (): &(), _: &mut impl FnMut(T, T)) {}
    #[inline(always)]
    fn square_shares(&self, (): &(), (): &mut ()) {}
    #[inline(always)]
    fn visit(&self, _: &mut impl FnMut(T)) {}
    #[inline(always)]
    fn replace(&mut self, _: &mut impl FnMut(T) -> T) {}
    #[inline(always)]
    fn all(&self, _: &Self, _: &mut impl FnMut(T, T) -> bool) -> bool {
        true
    }
    #[inline(always)]
    fn set_clocks(&mut self, time: R) {
        self.time = time;
    }
    fn stop_clocks(&mut self) {
        self.pace = R::zero();
    }
}

impl<T: Scalar, U: Scalar<Real = T::Real>, R: Real> Lift<T, U> for Clock<R> {
    type Over = Self;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
        *self
    }
}
