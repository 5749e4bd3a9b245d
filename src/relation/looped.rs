//! Closure forces of a loop: they ride inward only as far as the station where the arms of the loop meet, and are eliminated there.
//!
//! Two arms between stations A and B are cut at B, and the cut forces λ act on both. Where the arms meet at A, what both say of λ
//! adds up to −W_λᵀ p + Λ λ + Λ_xλᵀ x + y = 0 (x are closure forces that ride on), and λ is eliminated one by one: F = S p + e + W λ
//! becomes a relation like any other, with S + W Λ⁻¹ Wᵀ. So a loop costs nothing outside of itself, and of many loops in a chain
//! each is eliminated where it ends.

use super::Absent;
use super::closure::{Closures, Cut, Cuts, Solvable};
use crate::scalar::Scalar;

/// Closure forces of a scene, `C`, and inside a loop those of the loop, `O`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Looped<C, O>(core::marker::PhantomData<(C, O)>);

impl<C: Closures, O: Closures> Closures for Looped<C, O> {
    type Each<X: Copy> = (C::Each<X>, O::Each<X>);
    /// Pairs of C, those between O and C, pairs of O.
    type Pairs<T: Copy> = (C::Pairs<T>, O::Each<C::Each<T>>, O::Pairs<T>);
    const COUNT: usize = C::COUNT + O::COUNT;

    #[inline(always)]
    fn each<X: Copy>(mut make: impl FnMut(usize) -> X) -> Self::Each<X> {
        let outer = C::each(&mut make);
        (outer, O::each(|j| make(C::COUNT + j)))
    }
    #[inline(always)]
    fn map<X: Copy, Y: Copy>(items: &Self::Each<X>, mut make: impl FnMut(X) -> Y) -> Self::Each<Y> {
        let outer = C::map(&items.0, &mut make);
        (outer, O::map(&items.1, make))
    }
    #[cfg_attr(optimised, inline(always))]
    fn zip<X: Copy, Y: Copy, Z: Copy>(
        items: &Self::Each<X>,
        others: &Self::Each<Y>,
        mut make: impl FnMut(X, Y) -> Z,
    ) -> Self::Each<Z> {
        let outer = C::zip(&items.0, &others.0, &mut make);
        (outer, O::zip(&items.1, &others.1, make))
    }
    #[inline(always)]
    fn no_pairs<T: Scalar>() -> Self::Pairs<T> {
        (C::no_pairs(), O::each(|_| C::each(|_| T::zero())), O::no_pairs())
    }
    #[inline(always)]
    fn minus_outer<T: Scalar>(pairs: &Self::Pairs<T>, a: &Self::Each<T>, b: &Self::Each<T>) -> Self::Pairs<T> {
        let mixed = |row: C::Each<T>, own: T| C::zip(&row, &b.0, |x, b| (-own).mul_add(b, x));
        (C::minus_outer(&pairs.0, &a.0, &b.0), O::zip(&pairs.1, &a.1, mixed), O::minus_outer(&pairs.2, &a.1, &b.1))
    }
    #[inline(always)]
    fn plus_dot<T: Scalar>(sum: T, a: &Self::Each<T>, b: &Self::Each<T>) -> T {
        O::plus_dot(C::plus_dot(sum, &a.0, &b.0), &a.1, &b.1)
    }
}

/// What the elimination of the closure forces `O` of a loop leaves behind, where `C` ride on. Columns are of type `V`.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "O::Each<V>: serde::Serialize, O::Each<T>: serde::Serialize, O::Each<C::Each<T>>: serde::Serialize, O::Pairs<T>: serde::Serialize, O::Measure<T>: serde::Serialize",
        deserialize = "O::Each<V>: serde::Deserialize<'de>, O::Each<T>: serde::Deserialize<'de>, O::Each<C::Each<T>>: serde::Deserialize<'de>, O::Pairs<T>: serde::Deserialize<'de>, O::Measure<T>: serde::Deserialize<'de>"
    ))
)]
pub struct LoopGain<V: Copy, T: Scalar, C: Closures, O: Own> {
    /// w_k: each column as its elimination met it.
    pub(super) columns: O::Each<V>,
    /// 1 / Λ_kk, likewise.
    pub(super) inverse: O::Each<T>,
    /// Λ_kx / Λ_kk for the forces x that ride on.
    pub(super) riding: O::Each<C::Each<T>>,
    /// Λ_ik / Λ_kk below the diagonal.
    pub(super) factors: O::Pairs<T>,
    /// y_k.
    pub(super) gap: O::Each<T>,
    /// Λ before the elimination.
    pub(super) compliance: O::Pairs<T>,
    /// By which pivots of Λ are measured: that of the loop's own bodies, for all sweeps.
    pub(super) measure: O::Measure<T>,
}

/// Closure forces of a loop, which its own station can eliminate.
pub trait Own: Solvable {
    /// Whether forces are shared out, because some closures may follow from others.
    const SHARES: bool = false;
    /// What the last bodies of both arms would yield to each force if they were free: the measure of pivots of Λ, where an elimination
    /// has to tell them from rounding; nothing where all of them count.
    type Measure<T: Scalar>: Copy;
    /// The measure, from these yields; zero where no body has mass.
    fn measure<T: Scalar>(yields: impl FnOnce() -> Self::Each<T>) -> Self::Measure<T>;
    /// The measure where the loop is open by this share of its size.
    fn open<T: Scalar>(measure: Self::Measure<T>, _: T::Real) -> Self::Measure<T> {
        measure
    }

    /// The sum of pairs.
    fn plus_pairs<T: Scalar>(a: &Self::Pairs<T>, b: &Self::Pairs<T>) -> Self::Pairs<T>;

    /// Eliminates the forces of the loop: `absorb(w, 1/Λ, y/Λ)` adds w wᵀ/Λ to S and takes w y/Λ from e; `add(v, s, w)` is v + s w.
    #[allow(clippy::type_complexity)] // what is left, and how it is found again
    fn eliminate<V: Copy, T: Scalar, C: Closures>(
        cuts: Cuts<V, T, Looped<C, Self>>,
        measure: Self::Measure<T>,
        add: impl Fn(V, T, V) -> V,
        absorb: impl FnMut(V, T, T),
    ) -> (Cuts<V, T, C>, LoopGain<V, T, C, Self>);

    /// y as the elimination would meet it.
    fn reduced<V: Copy, T: Scalar, C: Closures>(gain: &LoopGain<V, T, C, Self>, gap: &Self::Each<T>) -> Self::Each<T>;

    /// λ for an acceleration p of the station, `work(w)` = w · p, forces that ride on, and y as the elimination meets it.
    fn forces<V: Copy, T: Scalar, C: Closures>(
        gain: &LoopGain<V, T, C, Self>,
        work: impl Fn(V) -> T,
        riding: &C::Each<T>,
        gap: &Self::Each<T>,
    ) -> Self::Each<T>;

    /// Which of the forces the motion does not decide.
    fn undetermined<V: Copy, T: Scalar, C: Closures>(_: &LoopGain<V, T, C, Self>) -> Self::Each<bool> {
        Self::each(|_| false)
    }
}

impl<const L: usize> Own for Cut<L> {
    type Measure<T: Scalar> = Absent;
    #[inline(always)]
    fn measure<T: Scalar>(_: impl FnOnce() -> [T; L]) -> Absent {
        Absent
    }

    #[inline(always)]
    fn plus_pairs<T: Scalar>(a: &[[T; L]; L], b: &[[T; L]; L]) -> [[T; L]; L] {
        core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] + b[i][j]))
    }

    #[cfg_attr(optimised, inline(always))]
    fn eliminate<V: Copy, T: Scalar, C: Closures>(
        cuts: Cuts<V, T, Looped<C, Self>>,
        measure: Absent,
        add: impl Fn(V, T, V) -> V,
        mut absorb: impl FnMut(V, T, T),
    ) -> (Cuts<V, T, C>, LoopGain<V, T, C, Self>) {
        let (mut columns, mut own) = cuts.columns;
        let (mut pairs, mut riding, mut lower) = cuts.compliance;
        let (mut gap, mut own_gap) = cuts.gap;
        let mut inverse = [T::zero(); L];
        for k in 0..L {
            let one_by = lower[k][k].recip();
            inverse[k] = one_by;
            let (w, share) = (own[k], own_gap[k] * one_by);
            absorb(w, one_by, share);
            let coupled = riding[k];
            let scaled = C::map(&coupled, |x| x * one_by);
            columns = C::zip(&columns, &scaled, |column, x| add(column, -x, w));
            gap = C::zip(&gap, &coupled, |gap, x| (-x).mul_add(share, gap));
            pairs = C::minus_outer(&pairs, &coupled, &scaled);
            riding[k] = scaled;
            let pivot_column: [T; L] = core::array::from_fn(|i| lower[i][k]);
            for i in k + 1..L {
                let factor = pivot_column[i] * one_by;
                own[i] = add(own[i], -factor, w);
                own_gap[i] = (-factor).mul_add(own_gap[k], own_gap[i]);
                riding[i] = C::zip(&riding[i], &coupled, |x, coupled| (-factor).mul_add(coupled, x));
                for j in k + 1..=i {
                    lower[i][j] = (-factor).mul_add(pivot_column[j], lower[i][j]);
                }
                lower[i][k] = factor;
            }
        }
        let compliance = cuts.compliance.2;
        let gain = LoopGain { columns: own, inverse, riding, factors: lower, gap: own_gap, compliance, measure };
        (Cuts { columns, compliance: pairs, gap }, gain)
    }

    #[cfg_attr(optimised, inline(always))]
    fn reduced<V: Copy, T: Scalar, C: Closures>(gain: &LoopGain<V, T, C, Self>, gap: &[T; L]) -> [T; L] {
        let mut gap = *gap;
        for k in 0..L {
            for i in k + 1..L {
                gap[i] = (-gain.factors[i][k]).mul_add(gap[k], gap[i]);
            }
        }
        gap
    }

    #[cfg_attr(optimised, inline(always))]
    fn forces<V: Copy, T: Scalar, C: Closures>(
        gain: &LoopGain<V, T, C, Self>,
        work: impl Fn(V) -> T,
        riding: &C::Each<T>,
        gap: &[T; L],
    ) -> [T; L] {
        let mut forces = [T::zero(); L];
        for k in (0..L).rev() {
            let free = (work(gain.columns[k]) - gap[k]) * gain.inverse[k];
            let held = -C::plus_dot(-free, &gain.riding[k], riding);
            forces[k] = (k + 1..L).fold(held, |sum, i| (-gain.factors[i][k]).mul_add(forces[i], sum));
        }
        forces
    }
}

impl<V: Copy, T: Scalar, C: Closures, O: Own> LoopGain<V, T, C, O> {
    /// No gain yet.
    pub fn blank(column: V, measure: O::Measure<T>) -> Self {
        let zero = T::zero();
        Self {
            columns: O::each(|_| column),
            inverse: O::each(|_| zero),
            riding: O::each(|_| C::each(|_| zero)),
            factors: O::no_pairs(),
            gap: O::each(|_| zero),
            compliance: O::no_pairs(),
            measure,
        }
    }

    /// The gain, measured by this.
    pub fn measured(self, measure: O::Measure<T>) -> Self {
        Self { measure, ..self }
    }

    /// Makes known by what share of its size the loop is open.
    pub fn open(&mut self, share: T::Real) {
        self.measure = O::open::<T>(self.measure, share);
    }

    /// By which pivots of Λ are measured.
    #[inline(always)]
    pub fn measure(&self) -> O::Measure<T> {
        self.measure
    }

    /// The gain with columns of another type.
    #[inline(always)]
    pub fn mapped<X: Copy>(self, column: impl FnMut(V) -> X) -> LoopGain<X, T, C, O> {
        let Self { columns, inverse, riding, factors, gap, compliance, measure } = self;
        LoopGain { columns: O::map(&columns, column), inverse, riding, factors, gap, compliance, measure }
    }

    /// y as the elimination met it: what velocities, loads and springs contribute.
    #[inline(always)]
    pub fn gap(&self) -> &O::Each<T> {
        &self.gap
    }

    /// What the elimination makes of y more, of whatever else acts in the arms: y as it would have met it, and what that adds to y of the
    /// forces that ride on; `take(w, y/Λ)` takes w y/Λ from e.
    #[cfg_attr(optimised, inline(always))]
    pub fn absorbed(&self, gap: &O::Each<T>, riding: C::Each<T>, take: impl FnMut(V, T)) -> (O::Each<T>, C::Each<T>) {
        let reduced = O::reduced(self, gap);
        let shares = O::zip(&reduced, &self.inverse, |gap, inverse| gap * inverse);
        O::zip(&self.columns, &shares, take);
        let mut riding = riding;
        O::zip(&self.riding, &reduced, |row, gap| riding = C::zip(&riding, &row, |sum, x| (-x).mul_add(gap, sum)));
        (reduced, riding)
    }

    /// With y of other coefficients, as the elimination would have met it.
    #[inline(always)]
    pub fn meet(&mut self, gap: O::Each<T>) {
        self.gap = gap;
    }

    /// With more of y, as the elimination would have met it.
    #[inline(always)]
    pub fn burden(&mut self, more: &O::Each<T>) {
        self.gap = O::zip(&self.gap, more, |gap, more| gap + more);
    }

    /// Λ of the loop, its station held.
    pub fn compliance(&self) -> &O::Pairs<T> {
        &self.compliance
    }

    /// Whether the pivots of the gain yield: what velocities, loads and springs contribute may overflow where they do.
    pub fn is_finite(&self) -> bool {
        let mut finite = true;
        O::map(&self.inverse, |x| finite &= x.is_finite());
        finite
    }
}

impl<V: Copy, T: Scalar, C: Closures> Cuts<V, T, C> {
    /// With the columns of a loop besides, at the station where it is cut: nothing yields there.
    #[cfg_attr(optimised, inline(always))]
    pub fn around<O: Own>(self, columns: O::Each<V>) -> Cuts<V, T, Looped<C, O>> {
        Cuts {
            columns: (self.columns, columns),
            compliance: (self.compliance, O::each(|_| C::each(|_| T::zero())), O::no_pairs()),
            gap: (self.gap, O::each(|_| T::zero())),
        }
    }
}

impl<V: Copy, T: Scalar, C: Closures, O: Own> Cuts<V, T, Looped<C, O>> {
    /// Where both arms of a loop meet: what the other one says of the loop's forces is added.
    #[cfg_attr(optimised, inline(always))]
    pub fn joined(self, side: &Cuts<V, T, O>, mut sum: impl FnMut(V, V) -> V) -> Self {
        let ((columns, own), (pairs, riding, lower), (gap, own_gap)) = (self.columns, self.compliance, self.gap);
        Self {
            columns: (columns, O::zip(&own, &side.columns, &mut sum)),
            compliance: (pairs, riding, O::plus_pairs(&lower, &side.compliance)),
            gap: (gap, O::zip(&own_gap, &side.gap, |a, b| a + b)),
        }
    }
}

/// A relation at whose station a torque acts besides, on the outboard part.
pub trait Twisted<N> {
    /// The relation with the torque.
    type Out: Copy;
    /// Adds the torque.
    fn twisted(self, torque: N) -> Self::Out;
}

/// The relation of one arm of a loop at the station where it meets the other arm's; columns of the space are of type `V`.
#[diagnostic::on_unimplemented(
    message = "arms that hand on `{Self}` and `{Side}` cannot close a loop",
    label = "these two cannot meet",
    note = "the arms of a loop are chains of one space and scalar, each with a body"
)]
pub trait Settle<V: Copy, T: Scalar, Side, C: Closures, O: Own> {
    /// The relation of both, without the forces of the loop.
    type Out: Copy;
    /// Joins both and eliminates the forces of the loop.
    fn settle(self, side: Side, measure: O::Measure<T>) -> (Self::Out, LoopGain<V, T, C, O>);
}
