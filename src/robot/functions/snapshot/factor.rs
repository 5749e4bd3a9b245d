//! The mass matrix factored along the tree, M = Lᵀ D L: no number of L is there where joints are not related.
//!
//! From the tips on (R. Featherstone, *Efficient factorization of the joint-space inertia matrix for branched kinematic trees*, International
//! Journal of Robotics Research 24, 2005). Right-hand sides stand side by side, so that each number of L is met by a row of them.

use crate::scalar::Scalar;

/// L below the diagonal, 1 / D, and which joint carries which.
pub struct Factor<'a, T, const N: usize> {
    lower: [[T; N]; N],
    inverse: [T; N],
    parents: &'a [usize; N],
}

/// a − factor · b.
#[inline(always)]
fn less<T: Scalar, const W: usize>(a: &mut [T; W], factor: T, b: &[T; W]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a = (-factor).mul_add(*b, *a));
}

impl<'a, T: Scalar, const N: usize> Factor<'a, T, N> {
    /// Of the lower half of a matrix.
    pub fn of(mut lower: [[T; N]; N], parents: &'a [usize; N]) -> Self {
        let mut inverse = [T::zero(); N];
        for k in (0..N).rev() {
            let (mut own, free) = (lower[k], lower[k][k].recip());
            let mut i = parents[k];
            while let Some(entry) = own.get(i).copied() {
                let share = entry * free;
                let mut j = i;
                while let Some(entry) = own.get(j) {
                    lower[i][j] = (-share).mul_add(*entry, lower[i][j]);
                    j = parents[j];
                }
                own[i] = share;
                i = parents[i];
            }
            (lower[k], inverse[k]) = (own, free);
        }
        Self { lower, inverse, parents }
    }

    /// L⁻ᵀ, from the tips on, and 1 / D.
    #[inline(always)]
    fn inward<const W: usize>(&self, rows: &mut [[T; W]; N]) {
        for k in (0..N).rev() {
            let own = rows[k];
            let mut i = self.parents[k];
            while let Some(row) = rows.get_mut(i) {
                less(row, self.lower[k][i], &own);
                i = self.parents[i];
            }
            rows[k] = own.map(|x| x * self.inverse[k]);
        }
    }

    /// L⁻¹, from the root on.
    #[inline(always)]
    fn outward<const W: usize>(&self, rows: &mut [[T; W]; N]) {
        for k in 0..N {
            let mut own = rows[k];
            let mut i = self.parents[k];
            while let Some(row) = rows.get(i) {
                less(&mut own, self.lower[k][i], row);
                i = self.parents[i];
            }
            rows[k] = own;
        }
    }

    /// M⁻¹ times columns.
    pub fn solve<const W: usize>(&self, rows: &mut [[T; W]; N]) {
        self.inward(rows);
        self.outward(rows);
    }
}
