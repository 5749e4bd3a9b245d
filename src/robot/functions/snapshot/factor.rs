//! The mass matrix factored along the tree, M = Lᵀ D L: no number of L is there where joints are not related.
//!
//! From the tips on (R. Featherstone, *Efficient factorization of the joint-space inertia matrix for branched kinematic trees*, International
//! Journal of Robotics Research 24, 2005). Right-hand sides stand side by side, so that each number of L is met by a row of them.

use super::{Blocks, MassMatrix};
use crate::scalar::{Real, Scalar};
use core::hint::black_box;
use core::ops::Range;

/// L below the diagonal, 1 / D, and which joint carries which.
pub struct Factor<'a, T, const N: usize> {
    lower: &'a [[T; N]; N],
    inverse: [T; N],
    parents: &'a [usize; N],
    /// How many joints are outboard of each: those that follow it.
    outboard: [usize; N],
}

/// A row less factors times others.
#[cfg_attr(optimised, inline(always))]
fn less<T: Scalar, const W: usize, const M: usize>(row: &mut [T; W], factors: [T; M], others: [&[T; W]; M]) {
    for (k, x) in row.iter_mut().enumerate() {
        *x = factors.iter().zip(others).fold(*x, |x, (factor, other)| (-*factor).mul_add(other[k], x));
    }
}

impl<'a, T: Scalar, const N: usize> Factor<'a, T, N> {
    /// Of the lower half of a matrix, in its place.
    pub fn of(lower: &'a mut [[T; N]; N], parents: &'a [usize; N]) -> Self {
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

    /// The limbs of some joints: those that the joints on the base carry, these among them, which follow each other.
    fn limbs(&self, joints: Range<usize>) -> Range<usize> {
        let mut whole = 0..0;
        while let Some(others) = self.outboard.get(whole.end).filter(|_| whole.end < joints.end) {
            if whole.end <= joints.start {
                whole.start = whole.end;
            }
            whole.end += others + 1;
        }
        whole
    }

    /// `by` · M⁻¹ times columns.
    pub fn solve<const W: usize>(&self, by: T, rows: &mut [[T; W]; N]) {
        self.solve_some(by, 0..N, rows);
    }

    /// `by` · M⁻¹ times a matrix over joints, of which no number is of two limbs, as none of M⁻¹ is.
    pub fn solve_joints(&self, by: T, rows: &mut [[T; N]; N]) {
        for first in (0..N).step_by(BLOCK) {
            let (limbs, mut block) = (self.limbs(first..N.min(first + BLOCK)), [[T::zero(); BLOCK]; N]);
            load(first, &rows[limbs.clone()], &mut block[limbs.clone()]);
            self.solve_some(by, limbs.clone(), &mut block);
            store(first, &block[limbs.clone()], &mut rows[limbs]);
        }
    }

    /// M⁻¹ into zeros.
    pub fn inverse(&self, into: &mut [[T; N]; N]) {
        for first in (0..N).step_by(BLOCK) {
            let (limbs, mut block) = self.units(first);
            self.solve_some(T::one(), limbs.clone(), &mut block[..limbs.end]);
            for k in limbs {
                put(first, k, block[k], into);
            }
        }
    }

    /// Columns of the identity from one on, and of the limbs that they belong to the joints up to the last of these: since M⁻¹ is symmetric, what
    /// they have in rows of further ones is found in those of others.
    #[cfg_attr(optimised, inline(always))]
    fn units(&self, first: usize) -> (Range<usize>, [[T; BLOCK]; N]) {
        let (last, mut block) = (N.min(first + BLOCK), [[T::zero(); BLOCK]; N]);
        block[first..last].iter_mut().enumerate().for_each(|(k, row)| row[k] = T::one());
        (self.limbs(first..last).start..last, block)
    }

    /// Some rows that depend on none of the others, nor on further rows than are given: L⁻ᵀ from the tips on, 1 / D, and L⁻¹ from the root on. What
    /// was found last is met last, so that nothing waits for it, and other rows several at a time.
    #[cfg_attr(optimised, inline(always))]
    fn solve_some<const W: usize>(&self, by: T, some: Range<usize>, rows: &mut [[T; W]]) {
        for i in some.clone().rev() {
            let Some(([.., own], outboard)) = rows.split_at_mut_checked(i + 1) else { continue };
            let (fours, rest) = outboard[..self.outboard[i].min(outboard.len())].as_chunks::<4>();
            let (first, mut sum) = (i + 1 + 4 * fours.len(), *own);
            for (k, row) in rest.iter().enumerate().rev() {
                less(&mut sum, [self.lower[first + k][i]], [row]);
            }
            for (k, [a, b, c, d]) in fours.iter().enumerate().rev() {
                less(&mut sum, [4, 3, 2, 1].map(|c| self.lower[i + 4 * k + c][i]), [d, c, b, a]);
            }
            *own = sum;
        }
        for k in some {
            let (inverse, lower, parent) = (self.inverse[k] * by, &self.lower[k], self.parents[k]);
            let mut own = rows[k].map(|x| x * inverse);
            if let Some(inboard) = rows.get(parent) {
                let mut i = self.parents[parent];
                while let Some(row) = rows.get(i) {
                    less(&mut own, [lower[i]], [row]);
                    i = self.parents[i];
                }
                less(&mut own, [lower[parent]], [inboard]);
            }
            rows[k] = own;
        }
    }
}

/// Columns that are solved for together: as many as stay in registers.
const BLOCK: usize = 8;

/// Columns from one on, of rows: zeros beyond the last.
#[cfg_attr(optimised, inline(always))]
fn load<T: Copy, const W: usize>(first: usize, rows: &[[T; W]], block: &mut [[T; BLOCK]]) {
    for (row, part) in rows.iter().zip(block) {
        match row.as_chunks::<BLOCK>() {
            (blocks, _) if first / BLOCK < blocks.len() => *part = blocks[first / BLOCK],
            (_, rest) => part.iter_mut().zip(rest).for_each(|(x, entry)| *x = *entry),
        }
    }
}

/// What [`load`] took, back.
#[cfg_attr(optimised, inline(always))]
fn store<T: Copy, const W: usize>(first: usize, block: &[[T; BLOCK]], rows: &mut [[T; W]]) {
    for (row, part) in rows.iter_mut().zip(block) {
        match row.as_chunks_mut::<BLOCK>() {
            (blocks, _) if first / BLOCK < blocks.len() => blocks[first / BLOCK] = *part,
            (_, rest) => rest.iter_mut().zip(part).for_each(|(entry, x)| *entry = *x),
        }
    }
}

/// Puts columns from one on of row `k` of a symmetric matrix, and what they are of rows further on.
#[cfg_attr(optimised, inline(always))]
fn put<T: Copy, const N: usize>(first: usize, k: usize, part: [T; BLOCK], into: &mut [[T; N]; N]) {
    store(first, &[part], &mut into[k..=k]);
    if k < first {
        into[first..].iter_mut().zip(part).for_each(|(row, x)| row[k] = x);
    }
}

/// Up to so many roundings of it, what is left of an inertia of the base is none.
const ROUNDINGS: f64 = 64.0;
/// A pivot that keeps no more than this power of rounding says nothing.
const SHARE: f64 = 0.7;
/// Each coordinate of a base carries the next.
const CHAIN: [usize; 6] = [usize::MAX, 0, 1, 2, 3, 4];

/// The inverse of a symmetric matrix of six rows, by its lower half; none where hardly more than rounding is left of a pivot.
pub fn inverted<T: Scalar>(mut matrix: [[T; 6]; 6]) -> Option<[[T; 6]; 6]> {
    let (whole, mut inverse): ([T; 6], _) = (core::array::from_fn(|k| matrix[k][k]), [[T::zero(); 6]; 6]);
    let factor = Factor::of(&mut matrix, &CHAIN);
    let least = T::Real::EPSILON.powf(T::Real::of(SHARE));
    let kept = |(inverse, whole): (&T, T)| (*inverse * whole).recip().real() > least;
    let sound = factor.inverse.iter().zip(whole).all(kept);
    (0..6).for_each(|k| inverse[k][k] = T::one());
    factor.solve(T::one(), &mut inverse);
    sound.then_some(inverse)
}

/// The mass matrix of a robot whose base floats, its joints eliminated: M of the joints, M⁻¹ Cᵀ with the coupling C, and the inertia that the base
/// has where joints give way.
pub struct Floating<'a, T, const N: usize> {
    joints: Factor<'a, T, N>,
    giving: [[T; 6]; N],
    base: Factor<'a, T, 6>,
}

impl<'a, T: Scalar, const N: usize> Floating<'a, T, N> {
    /// Of a mass matrix, in its place.
    pub fn of(matrix: &'a mut MassMatrix<T, N>, parents: &'a [usize; N]) -> Self {
        let MassMatrix { base, coupling, joints } = matrix;
        let whole: [T; 6] = core::array::from_fn(|k| base[k][k]);
        let (joints, mut giving) = (Factor::of(joints, parents), *coupling);
        joints.solve(T::one(), &mut giving);
        for (coupling, giving) in coupling.iter().zip(&giving) {
            base.iter_mut().zip(coupling).for_each(|(row, entry)| less(row, [*entry], [giving]));
        }
        let mut base = Factor::of(base, &CHAIN);
        // What rounding leaves of an inertia is none: a base without a link moves as a joint on it does.
        for (inverse, whole) in base.inverse.iter_mut().zip(whole) {
            let left = (*inverse * whole).recip() - T::constant(T::Real::EPSILON * T::Real::of(ROUNDINGS));
            *inverse = left.if_negative(T::zero().recip(), *inverse);
        }
        Self { joints, giving, base }
    }

    /// `by` · M⁻¹ times columns.
    #[cfg_attr(optimised, inline(always))]
    pub fn solve<const W: usize>(&self, by: T, base: &mut [[T; W]; 6], joints: &mut [[T; W]; N]) {
        self.gather(0..N, base, joints);
        self.base.solve(by, base);
        self.joints.solve(by, joints);
        self.spread(base, joints);
    }

    /// `by` · M⁻¹ times columns of the joints, where no number of `joints` is of two limbs.
    pub fn solve_joints(&self, by: T, base: &mut [[T; N]; 6], joints: &mut [[T; N]; N]) {
        for first in (0..N).step_by(BLOCK) {
            let limbs = self.joints.limbs(first..N.min(first + BLOCK));
            let (mut of_base, mut block) = ([[T::zero(); BLOCK]; 6], [[T::zero(); BLOCK]; N]);
            load(first, base, &mut of_base);
            load(first, &joints[limbs.clone()], &mut block[limbs.clone()]);
            self.gather(limbs.clone(), &mut of_base, &block);
            self.base.solve(by, &mut of_base);
            self.joints.solve_some(by, limbs, &mut block);
            store(first, &of_base, base);
            for ((own, giving), row) in block.iter_mut().zip(&self.giving).zip(joints.iter_mut()) {
                less(own, *giving, of_base.each_ref());
                store(first, core::slice::from_ref(own), core::slice::from_mut(row));
            }
        }
    }

    /// M⁻¹, in place of whatever was there.
    pub fn inverse(&self, into: &mut Blocks<T, N>) {
        for first in (0..N).step_by(BLOCK) {
            let ((limbs, mut block), mut of_base) = (self.joints.units(first), [[T::zero(); BLOCK]; 6]);
            let last = limbs.end;
            self.gather(first..last, &mut of_base, &block);
            self.base.solve(T::one(), &mut of_base);
            self.joints.solve_some(T::one(), limbs, &mut block[..last]);
            store(first, &of_base, &mut into.base_by_joints);
            for (k, (mut own, giving)) in block[..last].iter().copied().zip(&self.giving).enumerate() {
                less(&mut own, *giving, of_base.each_ref());
                put(first, k, own, &mut into.joints);
            }
        }
        into.base = [[T::zero(); 6]; 6];
        (0..6).for_each(|k| into.base[k][k] = T::one());
        self.base.solve(T::one(), &mut into.base);
        for (k, row) in into.joints_by_base.iter_mut().enumerate() {
            *row = into.base_by_joints.each_ref().map(|of_base| of_base[k]); // symmetric
        }
    }

    /// What some joints leave to the base, where they give way: three sums stay in registers while rows are met.
    #[cfg_attr(optimised, inline(always))]
    fn gather<const W: usize>(&self, some: Range<usize>, base: &mut [[T; W]; 6], joints: &[[T; W]; N]) {
        let (giving, rows) = (&self.giving[some.clone()], &joints[some]);
        for (first, three) in base.as_chunks_mut::<3>().0.iter_mut().enumerate() {
            let mut sums = *three;
            for (of, row) in giving.iter().zip(rows) {
                sums.iter_mut().enumerate().for_each(|(k, sum)| less(sum, [of[3 * first + k]], [row]));
            }
            *three = sums;
        }
    }

    /// What the motion of the base does to that of the joints.
    #[cfg_attr(optimised, inline(always))]
    fn spread<const W: usize>(&self, base: &[[T; W]; 6], joints: &mut [[T; W]; N]) {
        for (giving, row) in self.giving.iter().zip(joints) {
            let mut own = black_box(*row); // else lanes are of several rows, which are put in order for that
            less(&mut own, *giving, base.each_ref());
            *row = own;
        }
    }
}
