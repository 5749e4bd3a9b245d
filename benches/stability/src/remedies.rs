//! What the paper's section 7 and its sources propose against the loss of digits in products of transfer matrices.
//!
//! Each takes the matrices of a chain, root to tip, that begins at the origin without a torque and ends free, and gives θ at the inboard end
//! of each: the state at the root is (0, 0, θ, 0, q_x, q_y, 1), and m, q_x, q_y are zero at the tip.

use catena::{Real, Scalar, TransferMatrix};
use core::array::from_fn;

/// A matrix of seven rows.
type Matrix<T> = [[T; 7]; 7];
/// Unknowns at the root: θ, q_x, q_y.
const UNKNOWN: [usize; 3] = [2, 4, 5];
/// What is zero at the tip: m, q_x, q_y.
const ZERO: [usize; 3] = [3, 4, 5];

fn plain<T: Scalar>(matrix: &TransferMatrix<T, 7>) -> Matrix<T> {
    from_fn(|i| from_fn(|j| matrix[(i, j)]))
}

fn times<T: Scalar>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    from_fn(|i| from_fn(|j| (0..7).fold(T::zero(), |sum, k| sum + a[i][k] * b[k][j])))
}

fn size<T: Scalar>(x: T) -> f64 {
    x.real().as_f64().abs()
}

/// Three equations by elimination with row pivoting, for as many right-hand sides as there are columns.
fn solve<T: Scalar, const C: usize>(mut a: [[T; 3]; 3], mut b: [[T; C]; 3]) -> [[T; C]; 3] {
    for k in 0..3 {
        let pivot = (k..3).max_by(|i, j| size(a[*i][k]).total_cmp(&size(a[*j][k]))).unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..3 {
            let share = a[i][k] / a[k][k];
            let (row, right) = (a[k], b[k]);
            (0..3).for_each(|j| a[i][j] -= share * row[j]);
            (0..C).for_each(|j| b[i][j] -= share * right[j]);
        }
    }
    for k in (0..3).rev() {
        b[k] = from_fn(|j| {
            let known = (k + 1..3).fold(T::zero(), |sum, i| sum + a[k][i] * b[i][j]);
            (b[k][j] - known) / a[k][k]
        });
    }
    b
}

/// Unknowns at the root from the overall matrix.
fn root<T: Scalar>(whole: &Matrix<T>) -> [T; 7] {
    let a = ZERO.map(|i| UNKNOWN.map(|j| whole[i][j]));
    let b = ZERO.map(|i| [-whole[i][6]]);
    let found = solve(a, b);
    state(from_fn(|k| found[k][0]))
}

fn state<T: Scalar>([theta, x, y]: [T; 3]) -> [T; 7] {
    let zero = T::zero();
    [zero, zero, theta, zero, x, y, T::one()]
}

/// Angles from the state at the root, matrix by matrix.
fn outward<T: Scalar>(matrices: &[TransferMatrix<T, 7>], mut z: [T; 7]) -> Vec<T> {
    let mut angles = vec![];
    for matrix in matrices {
        angles.push(z[2]);
        z = from_fn(|i| (0..7).fold(T::zero(), |sum, k| sum + matrix[(i, k)] * z[k]));
    }
    angles
}

/// The product, states measured in units that make entries of all blocks alike: powers of two, so that units round nothing.
pub fn scaled<T: Scalar>(matrices: &[TransferMatrix<T, 7>]) -> Vec<T> {
    let all: Vec<Matrix<T>> = matrices.iter().map(plain).collect();
    // Forces and torques by positions: their largest entry against that of the way back.
    let largest = |rows: core::ops::Range<usize>, columns: core::ops::Range<usize>| {
        let of = |u: &Matrix<T>| {
            rows.clone()
                .flat_map(|i| columns.clone().map(move |j| (i, j)))
                .map(|(i, j)| size(u[i][j]))
                .fold(0.0, f64::max)
        };
        all.iter().map(of).fold(1e-300, f64::max)
    };
    let unit = (0.5 * (largest(3..6, 0..3) / largest(0..3, 3..6)).log2()).round().exp2();
    let number = |x: f64| T::constant(T::Real::of(x));
    let units: [f64; 7] = [1.0, 1.0, 1.0, unit, unit, unit, 1.0];
    let mut whole: Option<(Matrix<T>, f64)> = None; // with what it is divided by
    for u in &all {
        let u: Matrix<T> = from_fn(|i| from_fn(|j| u[i][j] * number(units[j] / units[i])));
        let (next, shrunk) = match whole {
            None => (u, 1.0),
            Some((w, shrunk)) => (times(&u, &w), shrunk),
        };
        let greatest = next.iter().flatten().fold(0.0_f64, |g, x| g.max(size(*x)));
        let by = if greatest > 1e12 { (-greatest.log2().round()).exp2() } else { 1.0 };
        whole = Some((next.map(|row| row.map(|x| x * number(by))), shrunk * by));
    }
    let Some((whole, _)) = whole else { return vec![] };
    // The division cancels in the equations at the tip, all of which are homogeneous in the matrix.
    let mut z = root(&whole);
    (z[4], z[5]) = (z[4] * number(unit), z[5] * number(unit));
    outward(matrices, z)
}

/// The product in another sequence: neighbours first, then pairs of pairs.
pub fn reordered<T: Scalar>(matrices: &[TransferMatrix<T, 7>]) -> Vec<T> {
    let mut level: Vec<Matrix<T>> = matrices.iter().map(plain).collect();
    while level.len() > 1 {
        let pair = |pair: &[Matrix<T>]| match pair {
            [inner, outer] => times(outer, inner),
            [one] => *one,
            _ => [[T::zero(); 7]; 7],
        };
        level = level.chunks(2).map(pair).collect();
    }
    level.first().map_or(vec![], |whole| outward(matrices, root(whole)))
}

/// The modified transfer matrix: at each station three entries of the state become the unknowns, so that what is carried does not grow.
/// Entries are those with the largest pivots.
pub fn modified<T: Scalar>(matrices: &[TransferMatrix<T, 7>]) -> Vec<T> {
    let (zero, one) = (T::zero(), T::one());
    // z = N u + c with unknowns u; at the root these are θ, q_x, q_y.
    let mut columns: [[T; 4]; 7] = [[zero; 4]; 7];
    UNKNOWN.iter().enumerate().for_each(|(k, i)| columns[*i][k] = one);
    columns[6][3] = one;
    let mut steps = vec![]; // old unknowns by new ones, and θ by the old ones
    for matrix in matrices {
        let theta = columns[2];
        let mut next: [[T; 4]; 7] =
            from_fn(|i| from_fn(|j| (0..7).fold(zero, |sum, k| sum + matrix[(i, k)] * columns[k][j])));
        // u = E v + f by exchanging column after column against the entry of z that is largest there.
        let mut exchange: [[T; 4]; 3] = from_fn(|i| from_fn(|j| if i == j { one } else { zero }));
        let mut taken = [false; 7];
        for k in 0..3 {
            // Rows are measured by what they hold in all columns, for their units differ.
            let share = |i: usize| {
                let row = next[i].iter().take(3).map(|x| size(*x)).fold(1e-300, f64::max);
                if taken[i] { -1.0 } else { size(next[i][k]) / row }
            };
            let best = (0..6).max_by(|i, j| share(*i).total_cmp(&share(*j))).unwrap_or(0);
            taken[best] = true;
            let pivot = next[best];
            let change = |row: &mut [T; 4]| {
                let factor = row[k] / pivot[k];
                for j in 0..4 {
                    row[j] = if j == k { factor } else { row[j] - factor * pivot[j] };
                }
            };
            next.iter_mut().for_each(change);
            exchange.iter_mut().for_each(change);
            next[best] = from_fn(|j| if j == k { one } else { zero });
        }
        next[6] = [zero, zero, zero, one];
        steps.push((exchange, theta));
        columns = next;
    }
    let found = solve(ZERO.map(|i| from_fn(|j| columns[i][j])), ZERO.map(|i| [-columns[i][3]]));
    let mut unknown: [T; 3] = from_fn(|k| found[k][0]);
    let mut angles = vec![];
    for (exchange, theta) in steps.iter().rev() {
        let by = |row: &[T; 4], u: &[T; 3]| row[3] + (0..3).fold(zero, |sum, k| sum + row[k] * u[k]);
        unknown = from_fn(|i| by(&exchange[i], &unknown));
        angles.push(by(theta, &unknown));
    }
    angles.reverse();
    angles
}

/// The Delta matrix: minors of order three of the rows that are zero at the tip are carried instead of the rows, and the unknowns at the
/// root are quotients of them. States follow matrix by matrix, as the method has them.
pub fn delta<T: Scalar>(matrices: &[TransferMatrix<T, 7>]) -> Vec<T> {
    let triples: Vec<[usize; 3]> =
        (0..7).flat_map(|i| (i + 1..7).flat_map(move |j| (j + 1..7).map(move |k| [i, j, k]))).collect();
    let zero = T::zero();
    let mut minors: Vec<T> = triples.iter().map(|triple| if *triple == ZERO { T::one() } else { zero }).collect();
    let mut next = minors.clone();
    for matrix in matrices.iter().rev() {
        let u = plain(matrix);
        for (entry, columns) in next.iter_mut().zip(&triples) {
            *entry = triples.iter().zip(&minors).fold(zero, |sum, (rows, minor)| {
                let a = |i: usize, j: usize| u[rows[i]][columns[j]];
                let determinant = a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1))
                    - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0))
                    + a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
                sum + *minor * determinant
            });
        }
        core::mem::swap(&mut minors, &mut next);
        let largest = minors.iter().fold(0.0_f64, |largest, x| largest.max(size(*x)));
        if largest > 0.0 && largest.is_finite() {
            let by = T::constant(T::Real::of((-largest.log2().round()).exp2()));
            minors.iter_mut().for_each(|x| *x *= by);
        }
    }
    let of = |columns: [usize; 3]| {
        triples.iter().zip(&minors).find(|(triple, _)| **triple == columns).map_or(zero, |(_, minor)| *minor)
    };
    let all = of(UNKNOWN);
    // Cramer's rule: the column of the constants in place of each unknown, with the sign of putting it in order.
    let z = state([-(of([4, 5, 6]) / all), of([2, 5, 6]) / all, -(of([2, 4, 6]) / all)]);
    outward(matrices, z)
}
