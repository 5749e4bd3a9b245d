//! How far joints are from a change of their modes.

use crate::mirror::{GuardedRate, Mode};
use crate::scalar::{Real, Scalar};

/// How far a joint is from a change of its mode: positive before.
pub(super) fn margin<T: Scalar>(mode: Mode, rate: T, guard: T) -> f64 {
    let guard = guard.real().as_f64();
    match mode {
        Mode::Sticks | Mode::Struck | Mode::Halts => 1.0 - guard.abs(),
        // A little beyond, so that what stands at its stop is before it.
        Mode::Swings | Mode::Lands | Mode::Rebounds => 1.0 - guard.abs() + 0.5 * Mode::touch::<T::Real>().as_f64(),
        Mode::RestsBelow | Mode::RestsAbove => Mode::reluctance::<T::Real>().as_f64() - guard,
        Mode::SlipsForward | Mode::SlipsBack => (mode.sign::<T>() * rate).real().as_f64(),
    }
}

/// The side of the stop that a joint touches: −1 the lower, 1 the upper one.
pub(super) fn touched<T: Scalar>(mode: Mode, guard: T) -> Option<f64> {
    let (guard, touch) = (guard.real().as_f64(), Mode::touch::<T::Real>().as_f64());
    (mode == Mode::Swings && guard.abs() >= 1.0 - touch).then(|| guard.signum())
}

/// The mode of a joint that touches a stop and does not move: it rests, if it does not leave.
pub(super) fn rests<T: Scalar>(mode: Mode, rate: T, told: &GuardedRate<T>) -> Option<Mode> {
    let side = touched(mode, told.guard).filter(|_| rate.is_zero())?;
    // Half of what a joint leaves its stop at: one that has just left does not come to rest again by rounding.
    let stays = side * told.rate.real().as_f64() > -0.5 * Mode::reluctance::<T::Real>().as_f64();
    stays.then_some(if side < 0.0 { Mode::RestsBelow } else { Mode::RestsAbove })
}
