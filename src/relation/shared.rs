//! Closure forces that are shared out where a loop is held more often than it can move.

use super::closure::{Closures, Cut, Cuts, Solvable};
use super::looped::{LoopGain, Looped, Own};
use super::redundancy::{following_share, rounded};
use crate::scalar::{Elementary, Real, Scalar};
use num_traits::Zero;

/// `L` closure forces of which some may follow from the others. Their Λ is singular then, and of all λ that do the same the one of
/// least norm is taken: λ = Λ⁺ (Wᵀ p − y).
///
/// Λ = G Gᵀ with as many columns as its rank (Cholesky with diagonal pivots), so Λ⁺ = Xᵀ X with X = (Gᵀ G)⁻¹ Gᵀ, and the loop is
/// eliminated as if its forces were s = X (Wᵀ p − y), λ = Xᵀ s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Shared<const L: usize>;

impl<const L: usize> Closures for Shared<L> {
    type Each<X: Copy> = [X; L];
    type Pairs<T: Copy> = [[T; L]; L];
    const COUNT: usize = L;

    #[inline(always)]
    fn each<X: Copy>(make: impl FnMut(usize) -> X) -> [X; L] {
        Cut::<L>::each(make)
    }
    #[inline(always)]
    fn map<X: Copy, Y: Copy>(items: &[X; L], make: impl FnMut(X) -> Y) -> [Y; L] {
        Cut::<L>::map(items, make)
    }
    #[inline(always)]
    fn zip<X: Copy, Y: Copy, Z: Copy>(items: &[X; L], others: &[Y; L], make: impl FnMut(X, Y) -> Z) -> [Z; L] {
        Cut::<L>::zip(items, others, make)
    }
    #[inline(always)]
    fn no_pairs<T: Scalar>() -> [[T; L]; L] {
        Cut::<L>::no_pairs()
    }
    #[inline(always)]
    fn minus_outer<T: Scalar>(pairs: &[[T; L]; L], a: &[T; L], b: &[T; L]) -> [[T; L]; L] {
        Cut::<L>::minus_outer(pairs, a, b)
    }
    #[inline(always)]
    fn plus_dot<T: Scalar>(sum: T, a: &[T; L], b: &[T; L]) -> T {
        Cut::<L>::plus_dot(sum, a, b)
    }
}

impl<const L: usize> Solvable for Shared<L> {
    /// None is in the way.
    fn dependent<T: Scalar>(_: &[[T; L]; L], _: &[T; L], _: f64) -> Option<(usize, usize)> {
        None
    }
    /// Of forces that hold a tip, which are never of this type: each pivot is measured by its own diagonal.
    fn solve<T: Scalar>(compliance: &[[T; L]; L], b: &[T; L]) -> [T; L] {
        let root = root_of_inverse(compliance, &([T::Real::zero(); L], T::Real::zero()));
        spread(&root, &gather(&root, b))
    }
}

/// X b.
fn gather<T: Scalar, const L: usize>(root: &[[T; L]; L], b: &[T; L]) -> [T; L] {
    root.map(|row| Cut::<L>::plus_dot(T::zero(), &row, b))
}

/// Xᵀ s.
fn spread<T: Scalar, const L: usize>(root: &[[T; L]; L], s: &[T; L]) -> [T; L] {
    core::array::from_fn(|i| (0..L).fold(T::zero(), |sum, k| root[k][i].mul_add(s[k], sum)))
}

/// By what pivots are measured, for each force, and by what share of its size the loop is open.
type Measure<T, const L: usize> = ([<T as Scalar>::Real; L], <T as Scalar>::Real);

/// By what the pivot of each force is measured: what has no measure by its own diagonal.
fn measures<T: Scalar, const L: usize>(compliance: &[[T; L]; L], (yields, _): &Measure<T, L>) -> [T::Real; L] {
    core::array::from_fn(|i| if yields[i] > T::Real::zero() { yields[i] } else { compliance[i][i].real() })
}

/// X of Λ, the lower triangle of which is read. Rows beyond its rank are zero.
///
/// What is a pivot, and what the rounding of one, is decided by its share of a `measure` (a diagonal of Λ may itself be rounding: of a
/// force across the plane in which a linkage moves), and by the largest share: stiff springs of implicit rules shrink them all. Where the loop
/// is open what is left of a dependent one is more than rounding.
fn root_of_inverse<T: Scalar, const L: usize>(compliance: &[[T; L]; L], measure: &Measure<T, L>) -> [[T; L]; L] {
    let whole = |i: usize, j: usize| if j <= i { compliance[i][j] } else { compliance[j][i] };
    let mut rest: [[T; L]; L] = core::array::from_fn(|i| core::array::from_fn(|j| whole(i, j)));
    // Columns of G.
    let mut factors = [[T::zero(); L]; L];
    let mut rank = 0;
    let mut waiting = [true; L];
    let by = measures(compliance, measure);
    let largest = (0..L).fold(T::Real::EPSILON.sqrt(), |most, i| (whole(i, i).real() / by[i]).max(most));
    let least = T::Real::of(following_share(T::Real::EPSILON.as_f64(), measure.1.as_f64())) * largest;
    while rank < L {
        // What the elimination of the others has left of each.
        let share = |i: usize| rest[i][i].real() / by[i];
        let best =
            (0..L).filter(|i| waiting[*i] && share(*i) > least).reduce(|a, b| if share(b) > share(a) { b } else { a });
        let Some(row) = best else { break };
        let inverse = rest[row][row].sqrt().recip();
        // Of those eliminated nothing is left but rounding, which a small pivot would make much of.
        let column: [T; L] = core::array::from_fn(|i| if waiting[i] { rest[i][row] * inverse } else { T::zero() });
        waiting[row] = false;
        for i in 0..L {
            for j in 0..L {
                rest[i][j] = (-column[i]).mul_add(column[j], rest[i][j]);
            }
        }
        factors[rank] = column;
        rank += 1;
    }
    // Gᵀ G, with a one where G has no column.
    let inner: [[T; L]; L] = core::array::from_fn(|k| {
        core::array::from_fn(|l| match (k < rank, k == l) {
            (false, true) => T::one(),
            _ => Cut::<L>::plus_dot(T::zero(), &factors[k], &factors[l]),
        })
    });
    let mut root = [[T::zero(); L]; L];
    for i in 0..L {
        let solved = Cut::<L>::solve(&inner, &core::array::from_fn(|k| factors[k][i]));
        for k in 0..L {
            root[k][i] = solved[k];
        }
    }
    root
}

impl<const L: usize> Own for Shared<L> {
    const SHARES: bool = true;
    type Measure<T: Scalar> = Measure<T, L>;
    fn measure<T: Scalar>(yields: impl FnOnce() -> [T; L]) -> Measure<T, L> {
        (yields().map(T::real), T::Real::zero())
    }
    fn open<T: Scalar>((yields, _): Measure<T, L>, share: T::Real) -> Measure<T, L> {
        (yields, share)
    }

    #[inline(always)]
    fn plus_pairs<T: Scalar>(a: &[[T; L]; L], b: &[[T; L]; L]) -> [[T; L]; L] {
        Cut::<L>::plus_pairs(a, b)
    }

    fn eliminate<V: Copy, T: Scalar, C: Closures>(
        cuts: Cuts<V, T, Looped<C, Self>>,
        measure: Measure<T, L>,
        add: impl Fn(V, T, V) -> V,
        mut absorb: impl FnMut(V, T, T),
    ) -> (Cuts<V, T, C>, LoopGain<V, T, C, Self>) {
        let (mut columns, own) = cuts.columns;
        let (mut pairs, riding, compliance) = cuts.compliance;
        let (mut gap, own_gap) = cuts.gap;
        let root = root_of_inverse(&compliance, &measure);
        let own_gap = gather(&root, &own_gap);
        // X Wᵀ, and X times the coupling to what rides on.
        let combined = root.map(|row| {
            let first = add(own[0], row[0] - T::one(), own[0]);
            (1..L).fold(first, |sum, i| add(sum, row[i], own[i]))
        });
        let coupled = root.map(|row| {
            (0..L).fold(C::each(|_| T::zero()), |sum, i| C::zip(&sum, &riding[i], |sum, x| row[i].mul_add(x, sum)))
        });
        for k in 0..L {
            absorb(combined[k], T::one(), own_gap[k]);
            columns = C::zip(&columns, &coupled[k], |column, x| add(column, -x, combined[k]));
            gap = C::zip(&gap, &coupled[k], |gap, x| (-x).mul_add(own_gap[k], gap));
            pairs = C::minus_outer(&pairs, &coupled[k], &coupled[k]);
        }
        let gain = LoopGain {
            columns: combined,
            inverse: [T::one(); L],
            riding: coupled,
            factors: root,
            gap: own_gap,
            compliance,
            measure,
        };
        (Cuts { columns, compliance: pairs, gap }, gain)
    }

    fn reduced<V: Copy, T: Scalar, C: Closures>(gain: &LoopGain<V, T, C, Self>, gap: &[T; L]) -> [T; L] {
        gather(&gain.factors, gap)
    }

    fn forces<V: Copy, T: Scalar, C: Closures>(
        gain: &LoopGain<V, T, C, Self>,
        work: impl Fn(V) -> T,
        riding: &C::Each<T>,
        gap: &[T; L],
    ) -> [T; L] {
        let sums = core::array::from_fn(|k| -C::plus_dot(gap[k] - work(gain.columns[k]), &gain.riding[k], riding));
        spread(&gain.factors, &sums)
    }

    /// Closure forces λ that may change while Λ λ does not: where the diagonal of 1 − Λ Λ⁺ is not zero.
    fn undetermined<V: Copy, T: Scalar, C: Closures>(gain: &LoopGain<V, T, C, Self>) -> [bool; L] {
        let by = measures(&gain.compliance, &gain.measure);
        // 1 / the smallest pivot, times its measure.
        let most = gain.factors.iter().fold(T::Real::zero(), |most, row| {
            row.iter().zip(by).fold(most, |most, (x, by)| (x.real() * x.real() * by).max(most))
        });
        let rounded = T::Real::of(rounded(T::Real::EPSILON.as_f64(), most.as_f64().recip()));
        let rounded = rounded.max(T::Real::EPSILON.sqrt());
        core::array::from_fn(|i| {
            let unit = core::array::from_fn(|j| if i == j { T::one() } else { T::zero() });
            let image: [T; L] =
                core::array::from_fn(|j| if j <= i { gain.compliance[i][j] } else { gain.compliance[j][i] });
            // Row i of Λ Λ⁺.
            let kept = Cut::<L>::plus_dot(T::zero(), &image, &spread(&gain.factors, &gather(&gain.factors, &unit)));
            (kept.real() - T::Real::of(1.0)).abs() > rounded
        })
    }
}
