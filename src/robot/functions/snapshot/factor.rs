//! The mass matrix factored along the tree, M = Lᵀ D L: no number of L is there where joints are not related.
//!
//! From the tips on (R. Featherstone, *Efficient factorization of the joint-space inertia matrix for branched kinematic trees*, International
//! Journal of Robotics Research 24, 2005). Right-hand sides stand side by side, so that each number of L is met by a row of them.

use super::MassMatrix;
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

    /// `by` · M⁻¹ times columns: L⁻ᵀ from the tips on, 1 / D, and L⁻¹ from the root on.
    pub fn solve<const W: usize>(&self, by: T, rows: &mut [[T; W]; N]) {
        for k in (0..N).rev() {
            let (own, free) = (rows[k], self.inverse[k] * by);
            let mut i = self.parents[k];
            while let Some(row) = rows.get_mut(i) {
                less(row, self.lower[k][i], &own);
                i = self.parents[i];
            }
            rows[k] = own.map(|x| x * free);
        }
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
}

/// Each coordinate of a base carries the next.
const CHAIN: [usize; 6] = [usize::MAX, 0, 1, 2, 3, 4];

/// The mass matrix of a robot whose base floats, its joints eliminated: M of the joints, M⁻¹ Cᵀ with the coupling C, and the inertia that the base
/// has where joints give way.
pub struct Floating<'a, T, const N: usize> {
    joints: Factor<'a, T, N>,
    giving: [[T; 6]; N],
    base: Factor<'static, T, 6>,
}

impl<'a, T: Scalar, const N: usize> Floating<'a, T, N> {
    /// Of a mass matrix.
    pub fn of(MassMatrix { mut base, coupling, joints }: MassMatrix<T, N>, parents: &'a [usize; N]) -> Self {
        let (joints, mut giving) = (Factor::of(joints, parents), coupling);
        joints.solve(T::one(), &mut giving);
        for (coupling, giving) in coupling.iter().zip(&giving) {
            base.iter_mut().zip(coupling).for_each(|(row, entry)| less(row, *entry, giving));
        }
        Self { joints, giving, base: Factor::of(base, &CHAIN) }
    }

    /// `by` · M⁻¹ times columns.
    pub fn solve<const W: usize>(&self, by: T, base: &mut [[T; W]; 6], joints: &mut [[T; W]; N]) {
        for (giving, row) in self.giving.iter().zip(&*joints) {
            base.iter_mut().zip(giving).for_each(|(sum, entry)| less(sum, *entry, row));
        }
        self.base.solve(by, base);
        self.joints.solve(by, joints);
        for (giving, row) in self.giving.iter().zip(joints) {
            base.iter().zip(giving).for_each(|(found, entry)| less(row, *entry, found));
        }
    }
}
