//! What a step with friction and stops is beside one without: impulses in its joints, and the rates that stops ask for.

use nalgebra::{DMatrix, DVector};

/// Impulses (N·m·s, N·s) in joints that make up what rates after a step of a size (s) have beside those without, by the rates after steps `under` unit
/// torques.
pub fn impulses<const N: usize>(under: impl Fn([f64; N]) -> [f64; N], after: &[f64], step: f64) -> [f64; N] {
    let free = under([0.0; N]);
    let columns: [_; N] = core::array::from_fn(|k| under(core::array::from_fn(|j| f64::from(j == k))));
    let matrix = DMatrix::from_fn(N, N, |row, column| (columns[column][row] - free[row]) / step);
    let missed = DVector::from_fn(N, |row, _| after[row] - free[row]);
    let found = matrix.lu().solve(&missed).expect("joints that move");
    core::array::from_fn(|k| found[k])
}

/// The least rate after a step of a size (s) that a lower stop allows, and the most that an upper one does, for a rate before it and distances
/// to both: to end at the stop, or what it gives back of a rate by which the joint would pass it; and whether it does that.
pub fn allowed(rate: f64, gaps: [f64; 2], restitution: f64, step: f64) -> [(f64, bool); 2] {
    [0, 1].map(|end| {
        let strikes = if end == 0 { rate < 0.0 } else { rate > 0.0 };
        let passes = if end == 0 { step * rate < gaps[0] } else { step * rate > gaps[1] };
        let back = strikes && passes && restitution > 0.0;
        (if back { -restitution * rate } else { gaps[end] / step }, back)
    })
}
