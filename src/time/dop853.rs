//! The method of Dormand and Prince of order 8 with error estimates of orders 5 and 3.

use super::dop853_table::{DENSE, ERROR3, ERROR5, NODES, RATE};
use super::tableau::{ErrorWeights, Explicit, Tableau, rows_of};
use super::{Control, Rule};

/// DOP853 (E. Hairer, S. P. Nørsett, G. Wanner 1993): order 8, twelve sweeps a step, error control, dense output of order 7 for
/// three further sweeps where it is asked for. The default for smooth motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dop853;

impl Dop853 {
    /// Steps of a fixed size (s).
    pub fn step<R>(size: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Fixed(size) }
    }
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}

const TABLE: Tableau<16> = Tableau::new(NODES, RATE);
const FIFTH: ErrorWeights<16> = ErrorWeights::new(ERROR5, &RATE);
const THIRD: ErrorWeights<16> = ErrorWeights::new(ERROR3, &RATE);

impl Explicit for Dop853 {
    const ORDER: usize = 8;
    const STAGES: usize = 12;
    rows_of!(TABLE, 16);

    #[inline(always)]
    fn errors() -> &'static [(&'static [f64], &'static [f64])] {
        const { &[(&FIFTH.rate, &FIFTH.position), (&THIRD.rate, &THIRD.position)] }
    }
    fn combine_errors(squares: &[f64]) -> f64 {
        // err₅² / (err₅² + err₃²/100) · err₅², the square of the estimate of order 7 in the authors' code.
        let (fifth, third) = (squares[0], squares[1]);
        let sum = fifth + 0.01 * third;
        if sum > 0.0 { fifth * (fifth / sum) } else { 0.0 }
    }
    fn dense(t: f64, weights: &mut [f64]) {
        // Δ, h f₀ − Δ and 2 Δ − h (f₀ + f₁), then four more terms, in powers of t and 1 − t by turns.
        let s = 1.0 - t;
        let powers = [t, t * s, t * t * s, t * t * s * s];
        let step = powers[0] - powers[1] + 2.0 * powers[2];
        for (j, weight) in weights.iter_mut().enumerate() {
            let start = if j == 0 { powers[1] - powers[2] } else { 0.0 };
            let end = if j == Self::STAGES { -powers[2] } else { 0.0 };
            let more = DENSE[0][j] + t * (DENSE[1][j] + s * (DENSE[2][j] + t * DENSE[3][j]));
            *weight = step * RATE[Self::STAGES][j] + start + end + powers[3] * more;
        }
    }
}
