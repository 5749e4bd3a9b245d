//! Where a function that changes its sign is zero.

use crate::error::{Error, Fault};
use crate::scalar::Scalar;

/// So many values halve a range down to rounding.
const MOST: usize = 200;
/// The share of a first step after an event from which on another is looked for: the function has left the zero where it began.
pub(super) const DEPARTED: f64 = 1e-3;

/// The share of a step from which on a function is looked at that is zero where the step begins: by then it has left zero by more than
/// rounding, and by more than steps err, also where it leaves slowly, as from rest.
pub(super) const LEFT: f64 = 0.0625;

/// Refuses functions of lanes: each crosses zero at a time of its own.
///
/// # Errors
/// [`Fault::Unsupported`].
pub(crate) fn of_one_number<T: Scalar>() -> Result<(), Error> {
    let what = "events and kinks of lanes, each of which has its own";
    if T::LANES { Err(Error::new(Fault::Unsupported { what })) } else { Ok(()) }
}

/// Whether a function arrives at zero, or on its other side, that has these values. Products would be rounded to zero, or be no numbers.
pub(crate) fn crosses([before, after]: [f64; 2]) -> bool {
    (before < 0.0 && after >= 0.0) || (before > 0.0 && after <= 0.0)
}

/// The share of a step from which on a function is looked at, and its value there, for a run that begins with a value, and whose first step ends
/// with another: it begins at zero if it [`crosses`] zero within a share that is rounding, as where an event has ended another run, on
/// whichever side of zero. Only a value that is nothing beside that at the end is looked at more closely.
pub(crate) fn departure<E>(
    [before, after]: [f64; 2],
    rounding: f64,
    value_at: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<(f64, f64), E> {
    if before == 0.0 {
        return Ok((LEFT, value_at(LEFT)?));
    }
    if before.abs() > rounding * after.abs() {
        return Ok((0.0, before));
    }
    let departed = value_at(DEPARTED)?;
    let at_zero = crosses([before, departed])
        && DEPARTED * crossing([before, departed], &mut |part| value_at(DEPARTED * part))? <= rounding;
    Ok(if at_zero { (DEPARTED, departed) } else { (0.0, before) })
}

/// The share at which a function is zero that [`crosses`] zero from 0 to 1 by these values: regula falsi with the Illinois modification, and
/// halves where three values have not halved the range. The last value asked for is that of the share given.
pub(crate) fn crossing<E>(values: [f64; 2], value_at: &mut dyn FnMut(f64) -> Result<f64, E>) -> Result<f64, E> {
    crossing_within(4.0 * f64::EPSILON, values, value_at)
}

/// The share at which a function is zero that [`crosses`] zero from 0 to 1 by these values, where so much of the range is left.
pub(super) fn crossing_within<E>(
    rest: f64,
    values: [f64; 2],
    value_at: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<f64, E> {
    let ([mut low, mut high], [mut below, mut above]) = ([0.0, 1.0], values);
    if above == 0.0 {
        return value_at(high).map(|_| high);
    }
    let (mut kept, mut width) = (0, 1.0);
    for count in 0..MOST {
        let theta = high - above * (high - low) / (above - below);
        // One end may say next to nothing of where zero is, as of a joint that has just left its stop.
        let slow = count % 3 == 2 && high - low > 0.5 * width;
        let theta = if theta > low && theta < high && !slow { theta } else { 0.5 * (low + high) };
        if count % 3 == 2 {
            width = high - low;
        }
        let value = value_at(theta)?;
        if !crosses([value, values[1]]) {
            (high, above) = (theta, value);
            below *= if kept == 1 { 0.5 } else { 1.0 };
            kept = 1;
        } else {
            (low, below) = (theta, value);
            above *= if kept == -1 { 0.5 } else { 1.0 };
            kept = -1;
        }
        if value == 0.0 || high - low < rest {
            return Ok(theta);
        }
    }
    Ok(0.5 * (low + high))
}

/// Halvings of a range that begins where a function is zero.
const HALVINGS: i32 = 40;

/// A range, of shares and values there, within which a function falls to zero: a range at whose end it is below, or the part of that, by halves, in which
/// it rises first. None where it rises nowhere.
pub(super) fn bracketed<E>(
    [mut low, mut high]: [(f64, f64); 2],
    value_at: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<Option<[(f64, f64); 2]>, E> {
    let mut share = high.0;
    for _ in 0..HALVINGS {
        if low.1 > 0.0 {
            break;
        }
        share *= 0.5;
        let value = value_at(share)?;
        *(if value > 0.0 { &mut low } else { &mut high }) = (share, value);
    }
    Ok((low.1 > 0.0).then_some([low, high]))
}

/// So many secants lead from a good guess to a zero.
const SECANTS: usize = 8;
/// Beside rounding a secant over less than this says nothing of the slope.
const SHORT: f64 = 1e-7;
/// A secant no longer than this that is not half of the one before is rounding.
const ROUNDING: f64 = 1e-12;

/// The share up to another one at which a function is zero, from a guess that is nearly right and the slope there; none where secants do not lead to
/// one at once. The last value asked for is that of the share given.
pub(super) fn polished<E>(
    (guess, mut slope): (f64, f64),
    most: f64,
    value_at: &mut dyn FnMut(f64) -> Result<f64, E>,
) -> Result<Option<f64>, E> {
    let (mut theta, mut before) = (guess, f64::INFINITY);
    let mut value = value_at(theta)?;
    for _ in 0..SECANTS {
        let step = -value / slope;
        // At zero, next to it, or where rounding moves it to and fro.
        let rounding = step.abs() < ROUNDING && step.abs() > 0.5 * before;
        if value == 0.0 || step.abs() < 4.0 * f64::EPSILON || rounding {
            return Ok(Some(theta));
        }
        if !(theta + step > 0.0 && theta + step <= most) {
            return Ok(None);
        }
        let next = value_at(theta + step)?;
        if step.abs() > SHORT {
            slope = (next - value) / step;
        }
        (theta, value, before) = (theta + step, next, step.abs());
    }
    Ok(None)
}
