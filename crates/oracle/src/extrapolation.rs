//! Gragg-Bulirsch-Stoer extrapolation: the modified midpoint rule with 2, 4, .., 16 substeps, whose error is a series
//! in even powers of the substep, extrapolated to substep zero (order 16), with a step length that follows the
//! tolerance.

/// Numbers of substeps of one step.
const SUBSTEPS: [usize; 8] = [2, 4, 6, 8, 10, 12, 14, 16];

/// Solves `y' = slope(t, y)` from `from` to `to` (either direction) and returns `y(to)`. The tolerance is meant for the
/// end of some ten steps: one step is accepted when its last two extrapolants agree, component by component, within a
/// tenth of `tolerance * (1 + |y|)`. Below 4e-14 nothing gets more exact: rounding errors are in the way.
///
/// Panics when the step length underflows.
pub fn extrapolate(
    mut slope: impl FnMut(f64, &[f64]) -> Vec<f64>,
    from: f64,
    to: f64,
    start: &[f64],
    tolerance: f64,
) -> Vec<f64> {
    let step_tolerance = (0.1 * tolerance).max(4e-15);
    let mut y = start.to_vec();
    let mut lost = vec![0.0; y.len()]; // low parts of y: compensated summation over the steps
    let mut t = from;
    let mut step = 0.1_f64.min((to - from).abs()) * (to - from).signum();
    while t != to {
        let last = (to - t).abs() <= step.abs();
        if last {
            step = to - t;
        }
        assert!(last || t + step != t, "step length underflow at t = {t}");
        let slope_0 = slope(t, &y);
        let (increment, difference) = extrapolated_increment(&mut slope, t, step, &y, &slope_0);
        let error =
            difference.iter().zip(&y).map(|(d, y)| d.abs() / (1.0 + y.abs())).fold(0.0, f64::max) / step_tolerance;
        // The estimate belongs to the last but one extrapolant, whose error falls with the power 15 of the step.
        let factor = (0.9 * error.max(1e-30).powf(-1.0 / 15.0)).clamp(0.2, 2.0);
        if error <= 1.0 {
            for i in 0..y.len() {
                let addend = increment[i] + lost[i];
                let sum = y[i] + addend;
                lost[i] = addend - (sum - y[i]);
                y[i] = sum;
            }
            t = if last { to } else { t + step };
            step *= factor;
        } else {
            assert!(error.is_finite(), "the solution left the finite numbers at t = {t}");
            step *= factor.min(0.7);
        }
    }
    y
}

/// The extrapolated increment over `step` and its difference to the extrapolant before it. All is done with increments
/// instead of values, since the extrapolation enlarges the rounding errors of what it is applied to.
fn extrapolated_increment(
    slope: &mut impl FnMut(f64, &[f64]) -> Vec<f64>,
    t: f64,
    step: f64,
    y: &[f64],
    slope_0: &[f64],
) -> (Vec<f64>, Vec<f64>) {
    let mut row: Vec<Vec<f64>> = Vec::new(); // of the tableau, the one before
    for (j, &n) in SUBSTEPS.iter().enumerate() {
        let mut entries = vec![midpoint_increment(slope, t, step, n, y, slope_0)];
        for i in 1..=j {
            let ratio = (n as f64 / SUBSTEPS[j - i] as f64).powi(2);
            let (fine, coarse) = (&entries[i - 1], &row[i - 1]);
            entries.push(fine.iter().zip(coarse).map(|(f, c)| f + (f - c) / (ratio - 1.0)).collect());
        }
        row = entries;
    }
    let (best, second) = (&row[SUBSTEPS.len() - 1], &row[SUBSTEPS.len() - 2]);
    (best.clone(), best.iter().zip(second).map(|(b, s)| b - s).collect())
}

/// Increment of the modified midpoint rule with `n` (even) substeps.
fn midpoint_increment(
    slope: &mut impl FnMut(f64, &[f64]) -> Vec<f64>,
    t: f64,
    step: f64,
    n: usize,
    y: &[f64],
    slope_0: &[f64],
) -> Vec<f64> {
    let h = step / n as f64;
    let mut before = vec![0.0; y.len()];
    let mut now: Vec<f64> = slope_0.iter().map(|s| h * s).collect();
    for i in 1..n {
        let at: Vec<f64> = y.iter().zip(&now).map(|(y, z)| y + z).collect();
        let s = slope(t + i as f64 * h, &at);
        let next = before.iter().zip(&s).map(|(b, s)| b + 2.0 * h * s).collect();
        before = std::mem::replace(&mut now, next);
    }
    now
}
