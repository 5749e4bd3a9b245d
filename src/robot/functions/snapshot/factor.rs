//! The mass matrix factored along the tree, M = Lᵀ D L: no number of L is there where joints are not related.
//!
//! From the tips on (R. Featherstone, *Efficient factorization of the joint-space inertia matrix for branched kinematic trees*, International
//! Journal of Robotics Research 24, 2005). Right-hand sides stand side by side, so that each number of L is met by a row of them.

use super::MassMatrix;
use crate::scalar::{Real, Scalar};

/// L below the diagonal, 1 / D, and which joint carries which.
pub struct Factor<'a, T, const N: usize> {
    lower: [[T; N]; N],
    inverse: [T; N],
    parents: &'a [usize; N],
    /// How many joints are outboard of each: those that follow it.
    outboard: [usize; N],
}

/// Right-hand sides side by side: numbers, or lists of numbers.
pub trait Row<T>: Copy {
    /// Less factors times others.
    fn less<const M: usize>(&mut self, factors: [T; M], others: [&Self; M]);
    /// Times a factor.
    fn scaled(self, factor: T) -> Self;
}

impl<T: Scalar, const W: usize> Row<T> for [T; W] {
    #[cfg_attr(optimised, inline(always))]
    fn less<const M: usize>(&mut self, factors: [T; M], others: [&Self; M]) {
        for (k, x) in self.iter_mut().enumerate() {
            *x = factors.iter().zip(others).fold(*x, |x, (factor, other)| (-*factor).mul_add(other[k], x));
        }
    }
    #[inline(always)]
    fn scaled(self, factor: T) -> Self {
        self.map(|x| x * factor)
    }
}

impl<T: Scalar, const W: usize, const K: usize> Row<T> for [[T; W]; K] {
    #[inline(always)]
    fn less<const M: usize>(&mut self, factors: [T; M], others: [&Self; M]) {
        self.iter_mut().enumerate().for_each(|(k, list)| list.less(factors, others.map(|other| &other[k])));
    }
    #[inline(always)]
    fn scaled(self, factor: T) -> Self {
        self.map(|list| list.scaled(factor))
    }
}

impl<'a, T: Scalar, const N: usize> Factor<'a, T, N> {
    /// Of the lower half of a matrix.
    pub fn of(mut lower: [[T; N]; N], parents: &'a [usize; N]) -> Self {
        let (mut inverse, mut outboard) = ([T::zero(); N], [0; N]);
        for k in (0..N).rev() {
            let reach = outboard[k] + 1;
            if let Some(sum) = outboard.get_mut(parents[k]) {
                *sum += reach;
            }
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
        Self { lower, inverse, parents, outboard }
    }

    /// `by` · M⁻¹ times columns: L⁻ᵀ from the tips on, 1 / D, and L⁻¹ from the root on. Rows are met several at a time.
    pub fn solve<L: Row<T>>(&self, by: T, rows: &mut [L; N]) {
        for i in (0..N).rev() {
            let Some(([.., own], outboard)) = rows.split_at_mut_checked(i + 1) else { continue };
            let (fours, rest) = outboard.get(..self.outboard[i]).unwrap_or_default().as_chunks::<4>();
            for (k, four) in fours.iter().enumerate() {
                own.less(core::array::from_fn(|c| self.lower[i + 1 + 4 * k + c][i]), four.each_ref());
            }
            let first = i + 1 + 4 * fours.len();
            rest.iter().enumerate().for_each(|(k, row)| own.less([self.lower[first + k][i]], [row]));
        }
        for k in 0..N {
            let (mut own, lower) = (rows[k].scaled(self.inverse[k] * by), &self.lower[k]);
            let mut i = self.parents[k];
            while let Some(row) = rows.get(i) {
                let next = self.parents[i];
                let Some(other) = rows.get(next) else {
                    own.less([lower[i]], [row]);
                    break;
                };
                own.less([lower[i], lower[next]], [row, other]);
                i = self.parents[next];
            }
            rows[k] = own;
        }
    }
}

/// Up to so many roundings of it, what is left of an inertia of the base is none.
const ROUNDINGS: f64 = 64.0;
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
    pub fn of(MassMatrix { base: mass, coupling, joints }: MassMatrix<T, N>, parents: &'a [usize; N]) -> Self {
        let mut base = mass;
        let (joints, mut giving) = (Factor::of(joints, parents), coupling);
        joints.solve(T::one(), &mut giving);
        for (coupling, giving) in coupling.iter().zip(&giving) {
            base.iter_mut().zip(coupling).for_each(|(row, entry)| row.less([*entry], [giving]));
        }
        let whole: [T; 6] = core::array::from_fn(|k| mass[k][k]);
        let mut base = Factor::of(base, &CHAIN);
        // What rounding leaves of an inertia is none: a base without a link moves as a joint on it does.
        for (inverse, whole) in base.inverse.iter_mut().zip(whole) {
            let left = (*inverse * whole).recip() - T::constant(T::Real::EPSILON * T::Real::of(ROUNDINGS));
            *inverse = left.if_negative(T::zero().recip(), *inverse);
        }
        Self { joints, giving, base }
    }

    /// `by` · M⁻¹ times columns.
    pub fn solve<L: Row<T>>(&self, by: T, base: &mut [L; 6], joints: &mut [L; N]) {
        // Rows four at a time, which are read once then.
        let ((givings, giving), (rows, row)) = (self.giving.as_chunks::<4>(), joints.as_chunks::<4>());
        for (k, sum) in base.iter_mut().enumerate() {
            givings.iter().zip(rows).for_each(|(of, rows)| sum.less(of.map(|of| of[k]), rows.each_ref()));
            giving.iter().zip(row).for_each(|(of, row)| sum.less([of[k]], [row]));
        }
        self.base.solve(by, base);
        self.joints.solve(by, joints);
        self.giving.iter().zip(joints).for_each(|(giving, row)| row.less(*giving, base.each_ref()));
    }
}
