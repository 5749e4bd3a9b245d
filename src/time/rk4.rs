//! The classical Runge-Kutta method of order 4.

use super::tableau::{Explicit, Tableau, rows_of};
use super::{Control, Rule};

/// The classical Runge-Kutta method: order 4, four sweeps a step, fixed steps.
///
/// Its dense output has order 3, so sampled values converge
/// with order 4 like the steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rk4;

impl Rk4 {
    /// Steps of a fixed size (s).
    pub fn step<R>(size: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Fixed(size) }
    }
}

const TABLE: Tableau<5> = Tableau::new(
    [0.0, 0.5, 0.5, 1.0, 1.0],
    [
        [0.0; 5],
        [0.5, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.5, 0.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 0.0],
    ],
);

impl Explicit for Rk4 {
    const ORDER: usize = 4;
    const STAGES: usize = 4;
    rows_of!(TABLE, 5);

    fn errors() -> &'static [(&'static [f64], &'static [f64])] {
        &[]
    }
    fn combine_errors(_: &[f64]) -> f64 {
        0.0
    }
    fn dense(t: f64, weights: &mut [f64]) {
        let middle = t * t - 2.0 / 3.0 * t * t * t;
        weights[0] = t - 1.5 * t * t + 2.0 / 3.0 * t * t * t;
        weights[1] = middle;
        weights[2] = middle;
        weights[3] = -0.5 * t * t + 2.0 / 3.0 * t * t * t;
    }
}
