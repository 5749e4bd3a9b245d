//! Motions displaced by weighted accelerations, and the size of such a displacement.

use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use num_traits::{One, Zero};

/// `sum = base + scale · Σ weights[j] · slopes[j]`, four terms at a time: one function of moderate size for all rows, however
/// many coordinates a tuple unrolls. What is no multiple of four comes first, where the base is read.
#[inline(never)]
pub(crate) fn gather<T: Scalar, R: Rate<T>>(sum: &mut R, base: &R, scale: T::Real, weights: &[f64], slopes: &[R]) {
    let count = weights.len().min(slopes.len());
    let (few, fours) = weights[..count].as_rchunks::<4>();
    let (few_slopes, fours_of_slopes) = slopes[..count].as_rchunks::<4>();
    let of = |weight: f64| T::Real::of(weight) * scale;
    match (few, few_slopes) {
        (&[u], [a]) => sum.mix_1(base, (of(u), a)),
        (&[u, v], [a, b]) => sum.mix_2(base, (of(u), a), (of(v), b)),
        (&[u, v, w], [a, b, c]) => sum.mix_3(base, (of(u), a), (of(v), b), (of(w), c)),
        _ => sum.set(base),
    }
    for (&[u, v, w, x], [a, b, c, d]) in fours.iter().zip(fours_of_slopes) {
        sum.add_4((of(u), a), (of(v), b), (of(w), c), (of(x), d));
    }
}

/// `sum = Σ weights[j] · slopes[j]`, as by [`gather`] from zero on, for scenes of few coordinates: in one pass, in registers. Where a
/// compiler knows the weights, which it does in code without loops alone, those that are zero cost nothing.
#[cfg_attr(optimised, inline(always))]
pub(super) fn gather_few<T: Scalar, R: Rate<T>>(sum: &mut R, zero: &R, weights: &[f64], slopes: &[R]) {
    let mut all = zero.clone();
    macro_rules! terms {
        ($($j:literal)*) => {$(
            if let (Some(weight), Some(slope)) = (weights.get($j), slopes.get($j))
                && *weight != 0.0
            {
                let mut more = zero.clone();
                more.mix_1(&all, (T::Real::of(*weight), slope));
                all = more;
            }
        )*};
    }
    terms!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
    *sum = all;
}

/// The past motion displaced by accelerations with these weights (in position, in rate): at a share `node` of the step. Sums are scaled by
/// its size, not weights: what a compiler knows of these it keeps.
/// The increment of positions is left, as a multiple of the square of that size.
pub(crate) fn displace<T: Scalar, P: Position<T>, C: Closures>(
    past: &Motion<T, P, C>,
    slopes: &[P::Rate],
    node: f64,
    weights: (&[f64], &[f64]),
    dt: T::Real,
    (zero, increment): (&P::Rate, &mut P::Rate),
    (position, rate): (&mut P, &mut P::Rate),
) {
    let one = T::Real::one();
    gather(increment, zero, one, weights.1, slopes);
    rate.mix_1(&past.rate, (dt, increment));
    gather(increment, zero, one, weights.0, slopes);
    position.drift_1(&past.position, (T::Real::of(node) * dt, &past.rate), (dt * dt, increment));
}

/// Mean square of errors in positions and rates, as multiples of tolerances (absolute and relative) of each.
pub(super) fn mean_square<T: Scalar, P: Position<T>, C: Closures>(
    next: &Motion<T, P, C>,
    (position, rate): (&P::Rate, &P::Rate),
    [of_position, of_rate]: [T::Real; 2],
) -> f64 {
    let (mut sum, mut count) = (T::Real::zero(), 0usize);
    // Of lanes each by its own size.
    let mut note = |error: T, size: T, tolerance: T::Real| {
        let share = (error / (size + T::one()).scale(tolerance)).real();
        sum += share * share;
        count += 1;
    };
    next.position.measure(position, &mut |error, size| note(error, size, of_position));
    rate.all(&next.rate, &mut |error, rate| {
        note(error, rate.abs(), of_rate);
        true
    });
    sum.as_f64() / count.max(1) as f64
}
