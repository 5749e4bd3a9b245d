//! Numbers that strangers hand in, and how many cases are tried.

use proptest::prelude::*;

/// As many cases as the environment says, or a few.
pub fn cases() -> ProptestConfig {
    let cases = std::env::var("CATENA_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(40);
    ProptestConfig { cases, max_shrink_iters: 512, failure_persistence: None, ..ProptestConfig::default() }
}

/// Numbers that are none, or hardly any.
const STRANGE: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE,
    5e-324,
    f64::MAX,
    -f64::MAX,
    f64::EPSILON,
    1e-160,
    1e160,
    1e17,
    -1e-9,
    1e9,
];

/// A parameter: most often of everyday size.
pub fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        20 => -3.0..3.0_f64,
        4 => (-6.0..6.0_f64).prop_map(|power| 10_f64.powf(power)),
        1 => any::<f64>(),
        1 => prop::sample::select(STRANGE.to_vec()),
    ]
}

/// A mass, a length, a step: most often positive.
pub fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![
        30 => 0.1..3.0_f64,
        4 => (-6.0..6.0_f64).prop_map(|power| 10_f64.powf(power)),
        1 => number(),
    ]
}

/// Lists of numbers, as long as any scene here wants.
pub fn numbers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(number(), 48)
}

/// Lists of masses and lengths.
pub fn sizes() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(positive(), 16)
}

/// Everyday numbers, of which nothing is to be refused.
pub fn plain() -> impl Strategy<Value = (Vec<f64>, Vec<f64>)> {
    (prop::collection::vec(-1.0..1.0_f64, 32), prop::collection::vec(0.3..2.0_f64, 16))
}

/// Size of steps and tolerance of a run.
pub fn rule() -> impl Strategy<Value = (f64, f64)> {
    let everyday = (-4.0..-1.0_f64).prop_map(|power| 10_f64.powf(power));
    let tolerance = (-15.0..-1.0_f64).prop_map(|power| 10_f64.powf(power));
    (prop_oneof![12 => everyday, 1 => number()], prop_oneof![12 => tolerance, 1 => number()])
}
