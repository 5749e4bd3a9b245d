//! A few linear equations, of which some may say nothing.

use crate::scalar::{Real, Scalar};

/// What of its measure a pivot must keep, or it says nothing that others do not.
const LEAST: f64 = 1e-10;

/// The solution x of Σₖ xₖ aₖ = b, by columns aₖ, by Gauss without exchanges, for couplings are positive definite. An unknown whose equation
/// follows from others, or moves nothing beside its measure, is zero.
pub(super) fn solved<T: Scalar, const K: usize>(
    mut columns: [[T; K]; K],
    measures: [T::Real; K],
    mut b: [T; K],
) -> [T; K] {
    let mut inverses = [T::zero(); K];
    for k in 0..K {
        let pivot = columns[k][k];
        if pivot.real().abs() <= measures[k] * T::Real::of(LEAST) {
            continue;
        }
        inverses[k] = pivot.recip();
        for row in k + 1..K {
            let share = columns[k][row] * inverses[k];
            for column in &mut columns[k + 1..] {
                let above = column[k];
                column[row] -= share * above;
            }
            let above = b[k];
            b[row] -= share * above;
        }
    }
    let mut x = [T::zero(); K];
    for k in (0..K).rev() {
        let known = (k + 1..K).fold(b[k], |sum, later| sum - columns[later][k] * x[later]);
        x[k] = known * inverses[k];
    }
    x
}
