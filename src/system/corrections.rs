//! When corrections that close loops come to an end.

use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use num_traits::{One, Zero};

/// Corrections of a motion with loops at most.
pub(crate) const MOST_CORRECTIONS: usize = 12;
/// How long (in roundings of coordinates) a correction may be that needs no other: those that follow are shorter by far.
const ROUNDINGS: f64 = 4.0;

/// Corrections of a motion with loops, one after the other, until they are rounding.
pub(crate) struct Corrections<T: Scalar> {
    /// Of coordinates.
    size: T::Real,
    /// Of the last correction.
    length: T::Real,
}

impl<T: Scalar> Corrections<T> {
    /// Corrections of coordinates that are not seen yet.
    #[inline(always)]
    pub(crate) fn begin() -> Self {
        Self { size: T::Real::one(), length: T::Real::INFINITY }
    }

    /// Sees a coordinate.
    #[inline(always)]
    pub(crate) fn see(&mut self, x: T) {
        self.size = x.real().abs().max(self.size);
    }

    /// Whether a correction was the last one: where the next would be shorter by far, or where rounding moves it to and fro.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn end(&mut self, correction: &impl Rate<T>, enough: bool) -> bool {
        let mut length = T::Real::zero();
        correction.visit(&mut |x| {
            let x = if x.is_finite() { x.real().abs() } else { T::Real::INFINITY };
            length = x.max(length);
        });
        let before = core::mem::replace(&mut self.length, length);
        let short = self.size * T::Real::EPSILON * T::Real::of(ROUNDINGS);
        enough && (length <= short || length >= before)
    }

    /// Whether the last correction was too long to lead anywhere.
    #[inline(always)]
    pub(crate) fn overshoot(&self) -> bool {
        self.length > self.size
    }

    /// After a step that is far too long no short correction closes a loop: that is no motion, and such steps are refused.
    pub(crate) fn lead_nowhere(&self) -> bool {
        self.length > self.size * T::Real::EPSILON.powf(T::Real::of(0.25))
    }
}
