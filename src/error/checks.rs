//! Checks of parameters, of lanes each.

use super::Fault;
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// Fails where a value is NaN or infinite.
pub fn finite<T: Scalar>(parameter: &'static str, values: &[T]) -> Result<(), Fault> {
    if values.iter().all(|x| x.is_finite()) { Ok(()) } else { Err(Fault::NotFinite { parameter }) }
}

/// Fails where a value is NaN, infinite or negative.
pub fn not_negative<T: Scalar>(parameter: &'static str, value: T) -> Result<(), Fault> {
    finite(parameter, &[value])?;
    let below = value.if_negative(value, T::zero()).real();
    if below < T::Real::zero() {
        return Err(Fault::Negative { parameter, value: below.as_f64() });
    }
    Ok(())
}

/// Fails where a value is NaN, infinite, zero or negative.
pub fn positive<T: Scalar>(parameter: &'static str, value: T) -> Result<(), Fault> {
    finite(parameter, &[value])?;
    if (-value).if_negative(T::zero(), T::one()).real() > T::Real::zero() {
        let below = value.if_negative(value, T::zero()).real();
        return Err(Fault::NotPositive { parameter, value: below.as_f64() });
    }
    Ok(())
}

/// The largest magnitude of several values.
pub fn largest<T: Scalar>(values: impl IntoIterator<Item = T>) -> T {
    values.into_iter().map(T::abs).fold(T::zero(), |most, x| (most - x).if_negative(x, most))
}
