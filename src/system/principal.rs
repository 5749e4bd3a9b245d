//! Directions in which stiffness and inertia of a scene are independent: K v = λ D v.

use crate::dense::Matrix;
use crate::scalar::{Real, Scalar};
use alloc::vec::Vec;
use nalgebra::{DMatrix, SymmetricEigen};

/// Principal directions, and the stiffness along each.
pub(super) struct Principal<R> {
    /// In rows, of inertia one.
    directions: Matrix<R>,
    /// λ (rad²/s²), in no order.
    stiffness: Vec<R>,
}

impl<R: Real> Principal<R> {
    /// Principal directions of a symmetric stiffness; none where the inertia is not definite, or something is no number.
    pub(super) fn of(stiffness: &Matrix<R>, inertia: &Matrix<R>) -> Option<Self> {
        let n = stiffness.columns();
        if n == 0 {
            return None;
        }
        let wide = |matrix: &Matrix<R>| DMatrix::from_fn(n, n, |i, j| matrix.get(i, j).as_f64());
        let stiffness = wide(stiffness);
        if !stiffness.iter().all(|x| x.is_finite()) {
            return None;
        }
        let lower = wide(inertia).cholesky()?.l();
        let half = lower.solve_lower_triangular(&stiffness)?;
        let both = lower.solve_lower_triangular(&half.transpose())?;
        let eigen = SymmetricEigen::try_new((&both + both.transpose()) * 0.5, f64::EPSILON, 1000 * n)?;
        let columns = lower.tr_solve_lower_triangular(&eigen.eigenvectors)?;
        let mut directions = Matrix::zeros(n, n);
        for (k, column) in columns.column_iter().enumerate() {
            column.iter().enumerate().for_each(|(i, x)| directions.put(k, i, R::of(*x)));
        }
        Some(Self { directions, stiffness: eigen.eigenvalues.iter().map(|x| R::of(*x)).collect() })
    }

    /// The step max(|K|, μ D)⁻¹ f, direction by direction: downhill also where stiffness drives on.
    pub(super) fn step<T: Scalar<Real = R>>(&self, force: &[T], damping: R) -> Vec<T> {
        let mut along = self.directions.apply(force);
        for (x, stiffness) in along.iter_mut().zip(&self.stiffness) {
            *x = x.scale(stiffness.abs().max(damping).recip());
        }
        self.directions.transposed().apply(&along)
    }

    /// The least stiffness, and its direction.
    pub(super) fn lowest(&self) -> (R, &[R]) {
        let mut lowest: (R, &[R]) = (R::zero(), &[]);
        for (k, (stiffness, direction)) in self.stiffness.iter().zip(self.directions.rows()).enumerate() {
            if k == 0 || *stiffness < lowest.0 {
                lowest = (*stiffness, direction);
            }
        }
        lowest
    }
}
