//! What all benchmarks share.

/// The middle one of values; not a number if there are none.
pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Says what long work is about, on one line that is written over.
pub fn progress(what: &str) {
    eprint!("\r\x1b[K{what}");
}
