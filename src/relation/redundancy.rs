//! Closures that say the same twice.

use num_traits::Float;

/// How small a pivot of the scaled Λ may be where closures are independent: rounding leaves 1e-16 of a dependent one, and a
/// mechanism must come within 1e-5 rad of a singular place to have 1e-10.
const SMALLEST: f64 = 1e-10;

/// A row of a positive semidefinite matrix that depends on others, and the rank: by Cholesky's factorisation with diagonal pivots.
/// The matrix is given by its lower triangle, scaled so that pivots lie between 0 and about 1; `rounding` is that of its numbers.
pub(super) fn dependent_row<const L: usize>(matrix: [[f64; L]; L], rounding: f64) -> Option<(usize, usize)> {
    if !matrix.iter().flatten().all(|entry| entry.is_finite()) {
        return None; // something else is wrong
    }
    let smallest = SMALLEST.max(100.0 * rounding);
    let mut rest = matrix;
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().take(i) {
            rest[j][i] = *entry;
        }
    }
    let mut waiting: [bool; L] = [true; L];
    for rank in 0..L {
        let pivots = (0..L).filter(|i| waiting[*i]).map(|i| (rest[i][i], i));
        let (pivot, row) = pivots.fold((f64::NEG_INFINITY, 0), |best, next| if next.0 > best.0 { next } else { best });
        if pivot <= smallest {
            return Some(((0..L).rev().find(|i| waiting[*i]).unwrap_or(row), rank));
        }
        waiting[row] = false;
        for i in (0..L).filter(|i| waiting[*i]) {
            let share = rest[i][row] / pivot;
            for j in 0..L {
                let correction = share * rest[row][j];
                rest[i][j] -= correction;
            }
        }
    }
    None
}

/// 1/√x, for a measure that is never zero.
pub(super) fn inverse_root(x: f64) -> f64 {
    Float::sqrt(x).recip()
}
