//! How far joints are from a change of their modes.

use super::{Mode, Told};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// Roundings of what holds a joint, as a share of what can hold it.
const ROUNDINGS: f64 = 1024.0;

/// How far a joint is from a change of its mode: positive before.
pub(crate) fn margin<T: Scalar>(mode: Mode, rate: T, told: &Told<T>) -> f64 {
    let guard = told.guard.real().as_f64();
    match mode {
        Mode::Sticks | Mode::Struck | Mode::Halts => 1.0 - guard.abs(),
        Mode::Swings | Mode::Lands | Mode::Rebounds => distance(told),
        Mode::RestsBelow | Mode::RestsAbove => Mode::reluctance::<T::Real>().as_f64() - guard,
        Mode::SlipsForward | Mode::SlipsBack if idles(rate, told) => f64::INFINITY,
        Mode::SlipsForward | Mode::SlipsBack if nears(mode, told) => forward(mode, rate).min(distance(told)),
        Mode::SlipsForward | Mode::SlipsBack => forward(mode, rate),
    }
}

/// So much may a joint that does not move be held by more than can hold it, for rounding: where several are at their limits at once each is so.
pub(crate) fn rounded<R: Real>() -> f64 {
    ROUNDINGS * R::EPSILON.as_f64()
}

/// Whether a joint that slips stands still, and is not about to move: what all others hold, whichever way it slips.
pub(crate) fn idles<T: Scalar>(rate: T, told: &Told<T>) -> bool {
    stands(rate) && told.rate.real().abs() <= Mode::reluctance()
}

/// Whether a rate is none.
pub(crate) fn stands<T: Scalar>(rate: T) -> bool {
    rate.real().abs() <= Mode::touch()
}

/// The rate of a joint that slips, or its acceleration, the way it slips.
pub(crate) fn forward<T: Scalar>(mode: Mode, rate: T) -> f64 {
    (mode.sign::<T>() * rate).real().as_f64()
}

/// Whether a joint that slips meets a stop before it comes to rest.
pub(crate) fn meets<T: Scalar>(mode: Mode, rate: T, told: &Told<T>) -> bool {
    nears(mode, told) && distance(told) < forward(mode, rate)
}

/// Whether a joint slips towards the nearest of its stops.
fn nears<T: Scalar>(mode: Mode, told: &Told<T>) -> bool {
    told.stops && (mode.sign::<T>() * told.guard).real() > T::Real::zero()
}

/// How far a joint is from the nearest of its stops, as a share, and a little beyond, so that what stands at its stop is before it.
fn distance<T: Scalar>(told: &Told<T>) -> f64 {
    1.0 - told.guard.real().as_f64().abs() + 0.5 * Mode::touch::<T::Real>().as_f64()
}

/// How near the nearest of its stops a joint is that moves between some: one where it stands at it.
pub(crate) fn nearness<T: Scalar>(mode: Mode, told: &Told<T>) -> Option<f64> {
    (told.stops && !mode.is_locked()).then(|| told.guard.real().as_f64().abs())
}

/// The side of the stop that a joint touches: −1 the lower, 1 the upper one.
pub(crate) fn touched<T: Scalar>(mode: Mode, told: &Told<T>) -> Option<f64> {
    let touching = 1.0 - Mode::touch::<T::Real>().as_f64();
    nearness(mode, told).filter(|near| *near >= touching).map(|_| told.guard.real().as_f64().signum())
}

/// The mode of a joint that touches a stop and does not move: it rests, if it does not leave.
pub(crate) fn rests<T: Scalar>(mode: Mode, rate: T, told: &Told<T>) -> Option<Mode> {
    let side = touched(mode, told).filter(|_| rate.real().is_zero())?;
    // Half of what a joint leaves its stop at: one that has just left does not come to rest again by rounding.
    let stays = side * told.rate.real().as_f64() > -0.5 * Mode::reluctance::<T::Real>().as_f64();
    // Friction against a slip into its stop would push it away.
    let into = side * mode.sign::<T>().real().as_f64() > 0.0;
    (stays || into).then_some(Mode::resting(side))
}
