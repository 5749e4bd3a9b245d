//! What several tests share: numbers without a pattern, and orders of convergence.

/// Numbers in −1 .. 1 without any pattern (a 64 bit linear congruential generator, upper bits).
pub struct Noise(u64);

impl Noise {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    #[allow(clippy::should_implement_trait)] // it never ends
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * 0.5 * (1.0 + self.next())
    }

    pub fn pair(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}

#[track_caller]
pub fn near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "found {found:.16e}, expected {expected:.16e}, error {error:.1e} > {tolerance:.1e}");
}

/// The largest difference of numbers of two lists.
#[track_caller]
pub fn farthest(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    found.iter().zip(expected).fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()))
}

/// The derivative of a function at zero, by central differences of order four.
pub fn derivative(h: f64, at: impl Fn(f64) -> f64) -> f64 {
    (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h)
}

/// Slope of a straight line through the logarithms of errors over those of step sizes, by least squares.
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(step, error)| (step.ln(), error.ln())).collect();
    let n = logs.len() as f64;
    let mean = logs.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / n, sum.1 + p.1 / n));
    let above: f64 = logs.iter().map(|p| (p.0 - mean.0) * (p.1 - mean.1)).sum();
    let below: f64 = logs.iter().map(|p| (p.0 - mean.0).powi(2)).sum();
    above / below
}

/// Errors at three or more step sizes, all of them at least ten times the `floor` of rounding errors, fall with this
/// order of the step within 0.2: what is left of the next order at such steps.
#[track_caller]
pub fn has_order(name: &str, order: f64, floor: f64, points: &[(f64, f64)]) {
    for (step, error) in points {
        println!("{name}: step {step:.6e} error {error:.3e}");
        assert!(
            *error > 10.0 * floor,
            "{name}: the error {error:.1e} at step {step} is lost in rounding ({floor:.0e})"
        );
    }
    let found = slope(points);
    println!("{name}: order {found:.3}");
    assert!(points.len() >= 3 && (found - order).abs() <= 0.2, "{name}: order {found:.3} instead of {order}");
}
