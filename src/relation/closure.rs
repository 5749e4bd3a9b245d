//! Columns of a relation: the forces λ of closures, as extra right-hand sides of the same elimination.
//!
//! A held tip, a loop or a network is cut, and its cut forces λ act as unknown loads: F = S p + e + W λ. The motion that the
//! closure demands gives as many rows, −Wᵀ p + Λ λ + y₀ = 0, whose Λ is symmetric and positive definite where the closures are
//! independent: the compliance of what lies outboard to these forces. W, Λ and y₀ ride inward with the relation; a chain without
//! closures has type [`Open`], and none of them.

use super::geometry::dot;
use super::redundancy::dependent_row;
use super::{AccelerationOf, Empty, Full, Geometry, Point};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// How many closure forces a sweep carries, decided by type.
pub trait Closures: Copy + 'static {
    /// One `X` for each closure force.
    type Each<X: Copy>: Copy;
    /// One `T` for each pair of closure forces.
    type Pairs<T: Copy>: Copy;
    /// Number of closure forces.
    const COUNT: usize;

    /// `make` for each closure force.
    fn each<X: Copy>(make: impl FnMut(usize) -> X) -> Self::Each<X>;
    /// Each item, mapped.
    fn map<X: Copy, Y: Copy>(items: &Self::Each<X>, make: impl FnMut(X) -> Y) -> Self::Each<Y>;
    /// Two items at a time, mapped.
    fn zip<X: Copy, Y: Copy, Z: Copy>(
        items: &Self::Each<X>,
        others: &Self::Each<Y>,
        make: impl FnMut(X, Y) -> Z,
    ) -> Self::Each<Z>;
    /// Pairs, zero.
    fn no_pairs<T: Scalar>() -> Self::Pairs<T>;
    /// `pairs − a bᵀ` for parallel a and b, the lower triangle.
    fn minus_outer<T: Scalar>(pairs: &Self::Pairs<T>, a: &Self::Each<T>, b: &Self::Each<T>) -> Self::Pairs<T>;
    /// `sum + a · b`.
    fn plus_dot<T: Scalar>(sum: T, a: &Self::Each<T>, b: &Self::Each<T>) -> T;
}

/// Closure forces that can be found from their own equations.
pub trait Solvable: Closures {
    /// A closure that depends on others, if there is one, and how many are independent: where pivots of Λ vanish, measured by what
    /// the last bodies would yield to each force if they were free, or are at most the `least` share of that.
    fn dependent<T: Scalar>(compliance: &Self::Pairs<T>, measure: &Self::Each<T>, least: f64)
    -> Option<(usize, usize)>;
    /// The solution of Λ x = b, of Λ its lower triangle is read. Where a pivot of Λ vanishes it is not finite, unless forces are shared
    /// out: then it is the one of least norm.
    fn solve<T: Scalar>(compliance: &Self::Pairs<T>, b: &Self::Each<T>) -> Self::Each<T>;
}

/// The largest of numbers of closures, without their signs.
pub fn largest<T: Scalar, C: Closures>(numbers: &C::Each<T>) -> T::Real {
    let mut most = T::Real::zero();
    C::map(numbers, |x| most = x.real().abs().max(most));
    most
}

/// No closures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Open;

impl Closures for Open {
    type Each<X: Copy> = ();
    type Pairs<T: Copy> = ();
    const COUNT: usize = 0;

    #[inline(always)]
    fn each<X: Copy>(_: impl FnMut(usize) -> X) {}
    #[inline(always)]
    fn map<X: Copy, Y: Copy>((): &(), _: impl FnMut(X) -> Y) {}
    #[inline(always)]
    fn zip<X: Copy, Y: Copy, Z: Copy>((): &(), (): &(), _: impl FnMut(X, Y) -> Z) {}
    #[inline(always)]
    fn no_pairs<T: Scalar>() {}
    #[inline(always)]
    fn minus_outer<T: Scalar>((): &(), (): &(), (): &()) {}
    #[inline(always)]
    fn plus_dot<T: Scalar>(sum: T, (): &(), (): &()) -> T {
        sum
    }
}

impl Solvable for Open {
    fn dependent<T: Scalar>((): &(), (): &(), _: f64) -> Option<(usize, usize)> {
        None
    }
    #[inline(always)]
    fn solve<T: Scalar>((): &(), (): &()) {}
}

/// Items from their numbers. Where functions are not inlined `from_fn` is five for each closure, and `map` of an array more: scenes compile for
/// longer.
#[inline(always)]
#[cfg(optimised)]
fn made<X: Copy, const L: usize>(make: impl FnMut(usize) -> X) -> [X; L] {
    core::array::from_fn(make)
}

/// Items from their numbers, one at least.
#[cfg(not(optimised))]
fn made<X: Copy, const L: usize>(mut make: impl FnMut(usize) -> X) -> [X; L] {
    const { assert!(L > 0, "no closure forces are `Open`") }
    let (mut items, mut j) = ([make(0); L], 1);
    while j < L {
        items[j] = make(j);
        j += 1;
    }
    items
}

/// `L` closure forces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cut<const L: usize>;

impl<const L: usize> Closures for Cut<L> {
    type Each<X: Copy> = [X; L];
    type Pairs<T: Copy> = [[T; L]; L];
    const COUNT: usize = L;

    #[inline(always)]
    fn each<X: Copy>(make: impl FnMut(usize) -> X) -> [X; L] {
        made(make)
    }
    #[inline(always)]
    fn map<X: Copy, Y: Copy>(items: &[X; L], mut make: impl FnMut(X) -> Y) -> [Y; L] {
        made(|j| make(items[j]))
    }
    #[inline(always)]
    fn zip<X: Copy, Y: Copy, Z: Copy>(items: &[X; L], others: &[Y; L], mut make: impl FnMut(X, Y) -> Z) -> [Z; L] {
        made(|j| make(items[j], others[j]))
    }
    #[inline(always)]
    fn no_pairs<T: Scalar>() -> [[T; L]; L] {
        [[T::zero(); L]; L]
    }
    #[cfg_attr(optimised, inline(always))]
    fn minus_outer<T: Scalar>(pairs: &[[T; L]; L], a: &[T; L], b: &[T; L]) -> [[T; L]; L] {
        core::array::from_fn(|i| {
            core::array::from_fn(|j| if j <= i { (-a[i]).mul_add(b[j], pairs[i][j]) } else { pairs[i][j] })
        })
    }
    #[inline(always)]
    fn plus_dot<T: Scalar>(sum: T, a: &[T; L], b: &[T; L]) -> T {
        (0..L).fold(sum, |sum, j| a[j].mul_add(b[j], sum))
    }
}

impl<const L: usize> Solvable for Cut<L> {
    fn dependent<T: Scalar>(compliance: &[[T; L]; L], measure: &[T; L], least: f64) -> Option<(usize, usize)> {
        let real = |x: T| x.real().as_f64();
        dependent_row(compliance.map(|row| row.map(real)), measure.map(real), least, T::Real::EPSILON.as_f64())
    }
    #[cfg_attr(optimised, inline(always))]
    fn solve<T: Scalar>(compliance: &[[T; L]; L], b: &[T; L]) -> [T; L] {
        let (lower, inverse) = factor(compliance);
        let mut x = *b;
        for i in 0..L {
            for j in 0..i {
                x[i] = (-lower[i][j]).mul_add(x[j], x[i]);
            }
        }
        for i in 0..L {
            x[i] *= inverse[i];
        }
        for i in (0..L).rev() {
            for j in i + 1..L {
                x[i] = (-lower[j][i]).mul_add(x[j], x[i]);
            }
        }
        x
    }
}

/// L D Lᵀ of a symmetric positive definite matrix given by its lower triangle: L below the diagonal, where it is one (what stands on
/// and above the diagonal is the matrix), and 1/D.
#[cfg_attr(optimised, inline(always))]
pub fn factor<T: Scalar, const L: usize>(matrix: &[[T; L]; L]) -> ([[T; L]; L], [T; L]) {
    let mut lower = *matrix;
    let mut inverse = [T::zero(); L];
    for j in 0..L {
        let mut scaled = [T::zero(); L]; // L_jk D_k
        let mut pivot = lower[j][j];
        for k in 0..j {
            scaled[k] = lower[j][k] / inverse[k];
            pivot = (-lower[j][k]).mul_add(scaled[k], pivot);
        }
        inverse[j] = pivot.recip();
        for row in &mut lower[j + 1..] {
            let entry = (0..j).fold(row[j], |entry, k| (-row[k]).mul_add(scaled[k], entry));
            row[j] = entry * inverse[j];
        }
    }
    (lower, inverse)
}

/// Closure forces as a relation carries them: columns of W, of type `V`, the lower triangle of Λ, and y₀.
#[derive(Clone, Copy)]
pub struct Cuts<V: Copy, T: Copy, C: Closures> {
    /// W.
    pub columns: C::Each<V>,
    /// Λ.
    pub compliance: C::Pairs<T>,
    /// y₀.
    pub gap: C::Each<T>,
}

impl<V: Copy, T: Scalar, C: Closures> Cuts<V, T, C> {
    /// Columns at a tip, where nothing yields: Λ = 0.
    #[inline(always)]
    pub fn at_tip(columns: C::Each<V>, gap: C::Each<T>) -> Self {
        Self { columns, compliance: C::no_pairs(), gap }
    }

    /// Columns moved to another station: each turned, and the motion between the stations added to its gap by `gap`.
    #[cfg_attr(optimised, inline(always))]
    pub fn turned<X: Copy>(&self, column: impl FnMut(V) -> X, gap: impl FnMut(T, V) -> T) -> Cuts<X, T, C> {
        Cuts {
            columns: C::map(&self.columns, column),
            compliance: self.compliance,
            gap: C::zip(&self.gap, &self.columns, gap),
        }
    }

    /// Columns in other axes of the same station.
    #[inline(always)]
    pub fn mapped<X: Copy>(&self, column: impl FnMut(V) -> X) -> Cuts<X, T, C> {
        Cuts { columns: C::map(&self.columns, column), compliance: self.compliance, gap: self.gap }
    }

    /// The elimination of a coordinate with pivot `−1 / minus_inverse` whose acceleration would be `free` without closure forces.
    /// `share` reads a column's generalised force on the coordinate, `reduce` the column that stays, given −share / pivot.
    /// The second result is what the outward walk needs: acceleration = … + row · λ.
    #[cfg_attr(optimised, inline(always))]
    pub fn eliminated<X: Copy>(
        &self,
        minus_inverse: T,
        free: T,
        share: impl FnMut(V) -> T,
        reduce: impl FnMut(V, T) -> X,
    ) -> (Cuts<X, T, C>, C::Each<T>) {
        let shares = C::map(&self.columns, share);
        let row = C::map(&shares, |share| share * minus_inverse);
        let cuts = Cuts {
            columns: C::zip(&self.columns, &row, reduce),
            compliance: C::minus_outer(&self.compliance, &shares, &row),
            gap: C::zip(&self.gap, &shares, |sum, share| (-share).mul_add(free, sum)),
        };
        (cuts, row)
    }
}

impl<V: Copy, T: Copy> Cuts<V, T, Open> {
    /// No closure forces.
    #[inline(always)]
    pub fn none() -> Self {
        Self { columns: (), compliance: (), gap: () }
    }
}

/// The relation at the root of a chain, from which the closure forces follow.
#[diagnostic::on_unimplemented(
    message = "a root cannot hold `{Self}`",
    label = "what this chain begins with needs something between it and the root",
    note = "a robot begins with `BodyAxes`, unless it stands on a `Base`"
)]
pub trait Close<G: Geometry, C: Closures> {
    /// λ, for the acceleration of the root.
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar>;
    /// Λ.
    fn compliance(&self) -> C::Pairs<G::Scalar>;
}

impl<G: Geometry> Close<G, Open> for Empty {
    #[inline(always)]
    fn multipliers(&self, _: &AccelerationOf<G>) {}
    #[inline(always)]
    fn compliance(&self) {}
}

impl<G: Geometry, M: Copy, C: Solvable> Close<G, C> for Point<G, M, C> {
    #[cfg_attr(optimised, inline(always))]
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar> {
        let cuts = &self.cuts;
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| dot(w, root.linear) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<G::Scalar> {
        self.cuts.compliance
    }
}

impl<G: Geometry, C: Solvable> Close<G, C> for Full<G, C> {
    #[cfg_attr(optimised, inline(always))]
    fn multipliers(&self, root: &AccelerationOf<G>) -> C::Each<G::Scalar> {
        let cuts = &self.cuts;
        let demand = C::zip(&cuts.columns, &cuts.gap, |w, gap| w.work(root) - gap);
        C::solve(&cuts.compliance, &demand)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<G::Scalar> {
        self.cuts.compliance
    }
}
