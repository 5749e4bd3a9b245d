//! The method of Dormand and Prince of order 5 with an embedded method of order 4.

use super::tableau::{ErrorWeights, Explicit, Tableau, rows_of};
use super::{Control, Rule};

/// DOPRI5 (J. R. Dormand, P. J. Prince 1980): order 5, six sweeps a step, error control, dense output of order 4 (L. F. Shampine
/// 1986).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dopri5;

impl Dopri5 {
    /// Steps of a fixed size (s).
    pub fn step<R>(size: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Fixed(size) }
    }
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}

const TABLE: Tableau<7> = Tableau::new(
    [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
    [
        [0.0; 7],
        [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0, 0.0],
        [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0, 0.0],
        [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0, 0.0],
        [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0],
    ],
);

const ERROR: ErrorWeights<7> = ErrorWeights::new(
    [-71.0 / 57600.0, 0.0, 71.0 / 16695.0, -71.0 / 1920.0, 17253.0 / 339200.0, -22.0 / 525.0, 1.0 / 40.0],
    &TABLE.rate,
);

/// Coefficients of θ, θ², θ³, θ⁴ in the weights of the dense output.
static DENSE: [[f64; 4]; 7] = [
    [1.0, -8048581381.0 / 2820520608.0, 8663915743.0 / 2820520608.0, -12715105075.0 / 11282082432.0],
    [0.0; 4],
    [0.0, 131558114200.0 / 32700410799.0, -68118460800.0 / 10900136933.0, 87487479700.0 / 32700410799.0],
    [0.0, -1754552775.0 / 470086768.0, 14199869525.0 / 1410260304.0, -10690763975.0 / 1880347072.0],
    [0.0, 127303824393.0 / 49829197408.0, -318862633887.0 / 49829197408.0, 701980252875.0 / 199316789632.0],
    [0.0, -282668133.0 / 205662961.0, 2019193451.0 / 616988883.0, -1453857185.0 / 822651844.0],
    [0.0, 40617522.0 / 29380423.0, -110615467.0 / 29380423.0, 69997945.0 / 29380423.0],
];

impl Explicit for Dopri5 {
    const ORDER: usize = 5;
    const STAGES: usize = 6;
    rows_of!(TABLE, 7);

    #[inline(always)]
    fn errors() -> &'static [(&'static [f64], &'static [f64])] {
        const { &[(&ERROR.rate, &ERROR.position)] }
    }
    fn combine_errors(squares: &[f64]) -> f64 {
        squares.iter().sum()
    }
    fn dense(t: f64, weights: &mut [f64]) {
        for (weight, [a, b, c, d]) in weights.iter_mut().zip(&DENSE) {
            *weight = t * (a + t * (b + t * (c + t * d)));
        }
    }
}
