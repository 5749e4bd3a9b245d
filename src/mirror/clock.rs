//! The mirror of a coordinate that is a given function of time: a clock.

use super::{Position, Retraction, Term};
use crate::lift::Lift;
use crate::scalar::{Real, Scalar};

/// The time (s) of the motion that it is part of.
///
/// Rules drift positions by rates that last for a time, and that time is all that a clock reads of them: so it shows the time of each stage
/// without a rate of its own. It is neither counted, visited nor replaced.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Clock<R>(pub(crate) R);

impl<T: Scalar<Real = R>, R: Real> Retraction<T> for Clock<R> {
    type Rate = ();
}

impl<T: Scalar<Real = R>, R: Real> Position<T> for Clock<R> {
    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, ()): Term<'_, T, ()>) {
        self.0 = from.0 + time;
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
    fn visit(&self, _: &mut impl FnMut(T)) {}
    #[inline(always)]
    fn replace(&mut self, _: &mut impl FnMut(T) -> T) {}
    #[inline(always)]
    fn all(&self, _: &Self, _: &mut impl FnMut(T, T) -> bool) -> bool {
        true
    }
    #[inline(always)]
    fn set_clocks(&mut self, time: R) {
        self.0 = time;
    }
}

impl<T: Scalar, U: Scalar<Real = T::Real>, R: Real> Lift<T, U> for Clock<R> {
    type Over = Self;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
        *self
    }
}
