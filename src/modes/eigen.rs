//! Eigenvalues of a real matrix with their right and left vectors: by QR, each led on by inverse iteration.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{Complex, DMatrix, DVector, Dyn, LU, Schur};
use num_traits::Zero;
use std::vec::Vec;

/// An eigenvalue λ with A x = λ x and uᵀ A = λ uᵀ, uᵀ x = 1; of several with one eigenvalue, uᵀ x is zero for those of others.
#[derive(Clone, Debug)]
pub(super) struct Pair {
    pub value: Complex<f64>,
    pub right: DVector<Complex<f64>>,
    /// No numbers where there are fewer vectors than eigenvalues.
    pub left: DVector<Complex<f64>>,
}

/// Eigenvalues that differ by less, as a share of the matrix, are one.
const ALIKE: f64 = 1e-9;
/// Vectors that leave more than this, as a share of the matrix, are none.
const LEFT_OVER: f64 = 1e-9;
/// Left and right vectors nearer to square than this belong to several eigenvalues with one vector.
const SQUARE: f64 = 1e-6;
/// Matrices tried.
const TRIALS: usize = 4;
/// Steps of QR for each row.
const ROUNDS: usize = 200;
/// By how many roundings of the matrix eigenvalues are shifted for inverse iteration: of several with one vector pivots go with the square.
const SHIFTS: [f64; 5] = [1.0, -3.0, 1e3, -1e6, 1e9];
/// Steps of inverse iteration.
const STEPS: usize = 3;

/// Eigenvalues whose imaginary parts are not negative, or nothing where QR does not end.
pub(super) fn pairs(matrix: &DMatrix<f64>) -> Option<Vec<Pair>> {
    let mut balanced = matrix.clone();
    balance_parlett_reinsch(&mut balanced);
    let mut values: Vec<Complex<f64>> = eigenvalues(balanced)?.into_iter().filter(|x| x.im >= 0.0).collect();
    values.sort_by(|a, b| (a.im, a.re).partial_cmp(&(b.im, b.re)).unwrap_or(core::cmp::Ordering::Equal));
    let size = matrix.norm().max(f64::MIN_POSITIVE);
    let [whole, turned] = [matrix.clone(), matrix.transpose()].map(|matrix| matrix.map(Complex::from));
    let mut pairs: Vec<Pair> = Vec::with_capacity(values.len());
    let mut first = 0;
    for (k, value) in values.iter().enumerate() {
        if pairs.get(first).is_none_or(|pair| (value - pair.value).norm() > ALIKE * size) {
            first = k;
        }
        let near = pairs.get(first..).unwrap_or_default();
        let [right, left] = [
            (&whole, near.iter().map(|pair| &pair.right).collect()),
            (&turned, near.iter().map(|pair| &pair.left).collect()),
        ]
        .map(|(matrix, others): (_, Vec<_>)| vector(matrix, *value, size, &others, k));
        pairs.push(Pair { value: *value, right, left });
        if k + 1 == values.len() || (values[k + 1] - pairs[first].value).norm() > ALIKE * size {
            paired(&whole, &mut pairs[first..], LEFT_OVER * size);
        }
    }
    Some(pairs)
}

/// Eigenvalues by QR, which does not end from some matrices that have many zeros among them: from the same in other coordinates then.
fn eigenvalues(mut matrix: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let n = matrix.nrows();
    for trial in 0..TRIALS {
        if let Some(schur) = Schur::try_new(matrix.clone(), f64::EPSILON, ROUNDS * n) {
            return Some(schur.complex_eigenvalues().iter().copied().collect());
        }
        // Mirrored, from both sides.
        let normal = generic(n, trial).normalize();
        let across = normal.transpose() * &matrix;
        matrix.ger(-2.0, &normal, &across.transpose(), 1.0);
        let across = &matrix * &normal;
        matrix.ger(-2.0, &across, &normal, 1.0);
    }
    None
}

/// A vector that is square to none by chance.
fn generic(n: usize, number: usize) -> DVector<f64> {
    DVector::from_fn(n, |i, _| 1.0 + 0.37 * ((i * (number + 2)) % 7) as f64)
}

/// A vector for an eigenvalue, square to others of it as far as there are more.
fn vector(
    matrix: &DMatrix<Complex<f64>>,
    value: Complex<f64>,
    size: f64,
    others: &[&DVector<Complex<f64>>],
    seed: usize,
) -> DVector<Complex<f64>> {
    let n = matrix.nrows();
    let shifted = |shift: f64| {
        let shift = value + Complex::from(size * f64::EPSILON * shift);
        (matrix - DMatrix::from_diagonal_element(n, n, shift)).lu()
    };
    // A little off, so that there is a solution; further where pivots are zero for all that.
    let solver = SHIFTS.into_iter().map(shifted).find(|solver| solver.is_invertible());
    let Some(solver) = solver else { return DVector::repeat(n, Complex::from(f64::NAN)) };
    let square = iterated(&solver, others, n, seed);
    if others.is_empty() || left_over(matrix, value, &square) < LEFT_OVER * size {
        square
    } else {
        iterated(&solver, &[], n, seed)
    }
}

/// What is left of a vector of length one that an eigenvalue does not explain.
fn left_over(matrix: &DMatrix<Complex<f64>>, value: Complex<f64>, vector: &DVector<Complex<f64>>) -> f64 {
    (matrix * vector - vector * value).norm()
}

/// A vector by inverse iteration, square to others.
fn iterated(
    solver: &LU<Complex<f64>, Dyn, Dyn>,
    others: &[&DVector<Complex<f64>>],
    n: usize,
    seed: usize,
) -> DVector<Complex<f64>> {
    let squared = |mut vector: DVector<Complex<f64>>| {
        for other in others {
            let share = other.dotc(&vector) / Complex::from(other.norm_squared());
            vector.axpy(-share, other, Complex::from(1.0));
        }
        vector
    };
    let mut vector = squared(generic(n, seed).map(Complex::from));
    for _ in 0..STEPS {
        if let Some(next) = solver.solve(&vector) {
            let size = next.camax();
            if size.is_finite() && !size.is_zero() {
                vector = squared(next.unscale(size));
            }
        }
    }
    let size = vector.norm();
    vector.unscale(size)
}

/// Makes left vectors of one eigenvalue such that uᵀ x = 1, and zero for others, and the eigenvalues those of their vectors, where these are found.
fn paired(matrix: &DMatrix<Complex<f64>>, pairs: &mut [Pair], most: f64) {
    let (count, n) = (pairs.len(), matrix.nrows());
    let products = DMatrix::from_fn(count, count, |i, j| pairs[i].left.dot(&pairs[j].right));
    let sound = products.iter().all(|x| x.re.is_finite() && x.im.is_finite());
    let inverse = (sound && products.clone().svd(false, false).singular_values.min() > SQUARE)
        .then(|| products.try_inverse())
        .flatten();
    let Some(inverse) = inverse else {
        pairs.iter_mut().for_each(|pair| pair.left.fill(Complex::from(f64::NAN)));
        return;
    };
    let old: Vec<_> = pairs.iter().map(|pair| pair.left.clone()).collect();
    for (i, pair) in pairs.iter_mut().enumerate() {
        pair.left = DVector::from_fn(n, |row, _| (0..count).map(|k| inverse[(i, k)] * old[k][row]).sum());
        let value = pair.left.dot(&(matrix * &pair.right));
        if left_over(matrix, value, &pair.right) < most {
            pair.value = value;
        }
    }
}
