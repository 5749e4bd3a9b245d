//! Runge-Kutta methods in Nyström form.
//!
//! The state is (q, v) with q̇ = v exactly, so the rates of the stages can be eliminated: with weights A for the
//! accelerations kⱼ, stage i stands at
//!
//! ```text
//! v_i = v + h Σ A_ij k_j        q_i = q + c_i h v + h² Σ (A·A)_ij k_j
//! ```
//!
//! which is the method applied to the first-order system, stage by stage, with half the storage.

use core::fmt::Debug;

/// Nodes and weights of `R` rows: the stages, the step itself, and further stages that only the dense output needs.
#[derive(Debug)]
pub struct Tableau<const R: usize> {
    /// c, the time of each row as a share of the step.
    pub nodes: [f64; R],
    /// A, the weights of accelerations in rates.
    pub rate: [[f64; R]; R],
    /// A·A, the weights of accelerations in positions.
    pub position: [[f64; R]; R],
}

impl<const R: usize> Tableau<R> {
    /// The Nyström form of a method.
    pub const fn new(nodes: [f64; R], rate: [[f64; R]; R]) -> Self {
        let mut position = [[0.0; R]; R];
        let mut i = 0;
        while i < R {
            position[i] = times(&rate[i], &rate);
            i += 1;
        }
        Self { nodes, rate, position }
    }
}

/// A row of weights times the lower triangular matrix A (loops, because `for` is not yet const).
const fn times<const R: usize>(row: &[f64; R], rate: &[[f64; R]; R]) -> [f64; R] {
    let mut product = [0.0; R];
    let mut j = 0;
    while j < R {
        let mut l = 0;
        while l <= j {
            product[l] += row[j] * rate[j][l];
            l += 1;
        }
        j += 1;
    }
    product
}

/// Weights of an error estimate.
#[derive(Debug)]
pub struct ErrorWeights<const R: usize> {
    /// e, of the error in rates.
    pub rate: [f64; R],
    /// e·A, of the error in positions.
    pub position: [f64; R],
}

impl<const R: usize> ErrorWeights<R> {
    /// The estimate with weights e.
    pub const fn new(rate: [f64; R], of: &[[f64; R]; R]) -> Self {
        let position = times(&rate, of);
        Self { rate, position }
    }
}

/// An explicit Runge-Kutta method whose step ends where the next one starts (the last acceleration is reused).
#[diagnostic::on_unimplemented(
    message = "`{Self}` makes no stepper",
    label = "not a method",
    note = "a stepper is told the size of every step and takes a method alone, `Rk4`: `Rk4::step(0.001)` and `Dop853::tolerance(1e-9)` are rules of runs, for `simulate` and `simulation`"
)]
pub trait Explicit: Copy + Debug {
    /// Order of convergence.
    const ORDER: usize;
    /// Accelerations evaluated in a step: rows 1 to `STAGES`, of which the last is the step itself.
    const STAGES: usize;
    /// All rows, those of the dense output included.
    const ROWS: usize;
    /// `ROWS` values.
    type Rows<X>: AsRef<[X]> + AsMut<[X]>;

    /// `ROWS` copies of a value.
    fn rows<X: Clone>(value: &X) -> Self::Rows<X>;
    /// c of a row.
    fn node(row: usize) -> f64;
    /// Weights of accelerations in the rates of a row.
    fn rate(row: usize) -> &'static [f64];
    /// Weights of accelerations in the positions of a row.
    fn position(row: usize) -> &'static [f64];
    /// Error estimates: (rate, position) weights each; none for a method without error control.
    fn errors() -> &'static [(&'static [f64], &'static [f64])];
    /// The error from the mean squares of the estimates.
    fn combine_errors(squares: &[f64]) -> f64;
    /// Weights of accelerations in the rates at a share `theta` of the step.
    fn dense(theta: f64, weights: &mut [f64]);
}

/// Gives a method the rows of its tableau. They are constants, not statics, so that compilers of other crates know weights of rows they know.
macro_rules! rows_of {
    ($table:ident, $rows:literal) => {
        const ROWS: usize = $rows;
        type Rows<X> = [X; $rows];

        fn rows<X: Clone>(value: &X) -> [X; $rows] {
            core::array::from_fn(|_| value.clone())
        }
        #[inline(always)]
        fn node(row: usize) -> f64 {
            const NODES: &[f64; $rows] = &$table.nodes;
            NODES[row]
        }
        #[inline(always)]
        fn rate(row: usize) -> &'static [f64] {
            const WEIGHTS: &[[f64; $rows]; $rows] = &$table.rate;
            &WEIGHTS[row]
        }
        #[inline(always)]
        fn position(row: usize) -> &'static [f64] {
            const WEIGHTS: &[[f64; $rows]; $rows] = &$table.position;
            &WEIGHTS[row]
        }
    };
}
pub(super) use rows_of;
