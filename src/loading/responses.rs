//! Forces that hang on the accelerations that they cause, from what sweeps respond to each.

use crate::scalar::Scalar;

/// So much larger than those expected are forces whose responses are found: what differences lose is a rounding of what moves without, for
/// each share that is taken of a response, so that larger ones lose nothing, and smaller ones all that stiff springs hold back.
pub(crate) const LARGER: f64 = 4096.0;

/// A number for each of `D` directions of `N` forces.
pub(crate) type Each<T, const D: usize, const N: usize> = [[T; D]; N];

/// The solution x of Σₖ xₖ aₖ = b, by columns aₖ, by Gauss without exchanges. An unknown whose pivot is not larger than the `least` is zero: its
/// equation follows from others, or it moves nothing.
pub(crate) fn balanced<T: Scalar, const D: usize, const N: usize>(
    mut columns: Each<Each<T, D, N>, D, N>,
    least: impl Fn(usize) -> T::Real,
    mut b: Each<T, D, N>,
) -> Each<T, D, N> {
    let (columns, x) = (columns.as_flattened_mut(), b.as_flattened_mut());
    for k in 0..x.len() {
        let pivot = &mut columns[k].as_flattened_mut()[k];
        if pivot.real().abs() <= least(k) {
            *pivot = T::zero();
            continue;
        }
        let inverse = pivot.recip();
        *pivot = inverse;
        for row in k + 1..x.len() {
            let share = columns[k].as_flattened()[row] * inverse;
            for column in &mut columns[k + 1..] {
                let column = column.as_flattened_mut();
                let above = column[k];
                column[row] -= share * above;
            }
            let above = x[k];
            x[row] -= share * above;
        }
    }
    for k in (0..x.len()).rev() {
        let known = (k + 1..x.len()).fold(x[k], |sum, later| sum - columns[later].as_flattened()[k] * x[later]);
        x[k] = known * columns[k].as_flattened()[k];
    }
    b
}
