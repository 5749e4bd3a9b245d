//! Where a function that changes its sign is zero.

/// The share at which a function is zero that has these values of unlike signs at 0 and 1: regula falsi with the Illinois modification.
/// The last value asked for is that of the share given, but for a hundred values that have not met rounding.
pub(crate) fn crossing<E>(values: [f64; 2], mut value_at: impl FnMut(f64) -> Result<f64, E>) -> Result<f64, E> {
    let ([mut low, mut high], [mut below, mut above]) = ([0.0, 1.0], values);
    let mut kept = 0;
    for _ in 0..100 {
        let theta = high - above * (high - low) / (above - below);
        let theta = if theta > low && theta < high { theta } else { 0.5 * (low + high) };
        let value = value_at(theta)?;
        if value * above > 0.0 {
            (high, above) = (theta, value);
            below *= if kept == 1 { 0.5 } else { 1.0 };
            kept = 1;
        } else {
            (low, below) = (theta, value);
            above *= if kept == -1 { 0.5 } else { 1.0 };
            kept = -1;
        }
        if value == 0.0 || high - low < 4.0 * f64::EPSILON {
            return Ok(theta);
        }
    }
    Ok(0.5 * (low + high))
}
