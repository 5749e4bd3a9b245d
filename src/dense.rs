//! Dense linear algebra in the small: what statics and modes need besides sweeps. It stands outside the kernels, so it may
//! decide on values; matrices are real, while vectors may be dual numbers.

mod tangent;

use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;
pub(crate) use tangent::Tangent;
#[cfg(feature = "std")]
pub(crate) use tangent::dependent;

/// A matrix, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Matrix<R> {
    columns: usize,
    entries: Vec<R>,
}

impl<R: Real> Matrix<R> {
    /// All entries zero.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self { columns, entries: vec![R::zero(); rows * columns] }
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Rows of the matrix.
    pub fn rows(&self) -> impl Iterator<Item = &[R]> {
        self.entries.chunks_exact(self.columns.max(1))
    }

    /// Rows of the matrix, to be set.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut [R]> {
        self.entries.chunks_exact_mut(self.columns.max(1))
    }

    /// The entry in row `i` and column `j`.
    pub fn get(&self, i: usize, j: usize) -> R {
        self.entries[i * self.columns + j]
    }

    /// Sets the entry in row `i` and column `j`.
    pub fn put(&mut self, i: usize, j: usize, entry: R) {
        self.entries[i * self.columns + j] = entry;
    }

    /// Sets column `j`.
    pub fn set_column(&mut self, j: usize, column: &[R]) {
        for (row, x) in self.rows_mut().zip(column) {
            row[j] = *x;
        }
    }

    /// Aᵀ A.
    pub fn gram(&self) -> Self {
        let n = self.columns;
        let mut gram = Self::zeros(n, n);
        for row in self.rows() {
            for (sums, x) in gram.rows_mut().zip(row) {
                axpy(sums, *x, row);
            }
        }
        gram
    }

    /// Aᵀ.
    pub fn transposed(&self) -> Self {
        let mut transposed = Self::zeros(self.columns, self.rows().count());
        for (j, row) in self.rows().enumerate() {
            transposed.set_column(j, row);
        }
        transposed
    }

    /// A B.
    pub fn times(&self, other: &Self) -> Self {
        let mut product = Self::zeros(self.entries.len() / self.columns.max(1), other.columns);
        for (sums, row) in product.rows_mut().zip(self.rows()) {
            for (x, other) in row.iter().zip(other.rows()) {
                axpy(sums, *x, other);
            }
        }
        product
    }

    /// A x.
    pub fn apply<T: Scalar<Real = R>>(&self, x: &[T]) -> Vec<T> {
        let dot = |row: &[R]| row.iter().zip(x).fold(T::zero(), |sum, (a, x)| sum.add_scaled(*a, *x));
        self.rows().map(dot).collect()
    }

    /// f A.
    pub fn scaled(mut self, factor: R) -> Self {
        self.entries.iter_mut().for_each(|x| *x *= factor);
        self
    }

    /// A + f B.
    pub fn plus(&self, factor: R, other: &Self) -> Self {
        let mut sum = self.clone();
        axpy(&mut sum.entries, factor, &other.entries);
        sum
    }

    /// The largest sum of magnitudes in a row.
    pub fn norm(&self) -> R {
        self.rows().fold(R::zero(), |most, row| most.max(row.iter().fold(R::zero(), |sum, x| sum + x.abs())))
    }

    /// Whether the symmetric part of a square matrix is positive definite: whether its Cholesky pivots are positive.
    pub fn is_definite(&self) -> bool {
        let n = self.columns;
        let mut lower = Self::zeros(n, n);
        let half = R::of(0.5);
        for i in 0..n {
            for j in 0..=i {
                let entry = (self.entries[i * n + j] + self.entries[j * n + i]) * half;
                let (above, row) = lower.entries.split_at(i * n);
                let other = if j < i { &above[j * n..j * n + j] } else { &row[..j] };
                let sum = other.iter().zip(row).fold(entry, |sum, (a, b)| sum - *a * *b);
                if j < i {
                    lower.entries[i * n + j] = sum / lower.entries[j * n + j];
                } else if sum > R::zero() {
                    lower.entries[i * n + i] = sum.sqrt();
                } else {
                    return false; // NaN is not definite either
                }
            }
        }
        true
    }
}

/// `sums + factor · row`.
fn axpy<R: Real>(sums: &mut [R], factor: R, row: &[R]) {
    for (sum, x) in sums.iter_mut().zip(row) {
        *sum += factor * *x;
    }
}

/// The factors L U of a square matrix, rows exchanged for the largest pivots.
pub(crate) struct Factors<R> {
    matrix: Matrix<R>,
    order: Vec<usize>,
}

impl<R: Real> Factors<R> {
    /// The factors of a matrix; none where a pivot is zero or not finite.
    pub fn of(mut matrix: Matrix<R>) -> Option<Self> {
        let n = matrix.columns;
        let mut order: Vec<usize> = (0..n).collect();
        for k in 0..n {
            let size = |i: usize| matrix.entries[i * n + k].abs();
            let best = (k + 1..n).fold(k, |best, i| if size(i) > size(best) { i } else { best });
            if best != k {
                let (above, below) = matrix.entries.split_at_mut(best * n);
                above[k * n..(k + 1) * n].swap_with_slice(&mut below[..n]);
                order.swap(k, best);
            }
            let (above, below) = matrix.entries.split_at_mut((k + 1) * n);
            let pivot = &above[k * n..];
            let inverse = pivot[k].recip();
            if !inverse.is_finite() {
                return None;
            }
            for row in below.chunks_exact_mut(n) {
                let factor = row[k] * inverse;
                row[k] = factor;
                axpy(&mut row[k + 1..], -factor, &pivot[k + 1..]);
            }
        }
        Some(Self { matrix, order })
    }

    /// The solution of A x = b.
    pub fn solve<T: Scalar<Real = R>>(&self, b: &[T]) -> Vec<T> {
        let n = self.matrix.columns;
        let mut x: Vec<T> = self.order.iter().map(|i| b[*i]).collect();
        for (i, row) in self.matrix.rows().enumerate() {
            x[i] = row[..i].iter().zip(&x).fold(x[i], |sum, (a, x)| sum.add_scaled(-*a, *x));
        }
        for i in (0..n).rev() {
            let row = &self.matrix.entries[i * n..(i + 1) * n];
            let sum = row[i + 1..].iter().zip(&x[i + 1..]).fold(x[i], |sum, (a, x)| sum.add_scaled(-*a, *x));
            x[i] = sum.scale(row[i].recip());
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[f64]]) -> Matrix<f64> {
        Matrix { columns: rows[0].len(), entries: rows.concat() }
    }

    #[test]
    fn factors_solve_with_exchanged_rows() {
        let a = matrix(&[&[0.0, 2.0, 1.0], &[1.0, -1.0, 0.5], &[3.0, 0.0, -2.0]]);
        let x = Factors::of(a.clone()).unwrap().solve(&a.apply(&[1.0, -2.0, 3.0]));
        let error = x.iter().zip([1.0, -2.0, 3.0]).fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
        assert!(error < 1e-14, "{error:e}");
        assert!(Factors::of(matrix(&[&[1.0, 2.0], &[0.5, 1.0]])).is_none());
    }

    #[test]
    fn definiteness_is_that_of_the_symmetric_part() {
        assert!(matrix(&[&[2.0, 3.0], &[-3.0, 1.0]]).is_definite());
        assert!(!matrix(&[&[1.0, 2.0], &[2.0, 1.0]]).is_definite());
        assert!(!matrix(&[&[f64::NAN]]).is_definite());
    }
}
