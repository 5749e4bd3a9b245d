//! Motions displaced by weighted accelerations, and the size of such a displacement.

use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use num_traits::{One, Zero};

/// `sum = base + scale · Σ weights[j] · slopes[j]`, four terms at a time: one function of moderate size for all rows, however
/// many coordinates a tuple unrolls.
#[inline(never)]
pub(super) fn gather<T: Scalar, R: Rate<T>>(sum: &mut R, base: &R, scale: T::Real, weights: &[f64], slopes: &[R]) {
    if weights.is_empty() {
        sum.combine(base, &[], []);
    }
    let mut started = false;
    for (weights, slopes) in weights.chunks(4).zip(slopes.chunks(4)) {
        let weight = |j: usize| T::Real::of(weights[j]) * scale;
        macro_rules! terms {
            ($M:literal) => {{
                let (weights, terms) = (core::array::from_fn(weight), core::array::from_fn(|j| &slopes[j]));
                if started { sum.accumulate::<$M>(&weights, terms) } else { sum.combine::<$M>(base, &weights, terms) }
            }};
        }
        match weights.len().min(slopes.len()) {
            4 => terms!(4),
            3 => terms!(3),
            2 => terms!(2),
            1 => terms!(1),
            _ => (),
        }
        started = true;
    }
}

/// The past motion displaced by accelerations with these weights (in position, in rate): at a share `node` of the step.
pub(super) fn displace<T: Scalar, P: Position<T>, C: Closures>(
    past: &Motion<T, P, C>,
    slopes: &[P::Rate],
    node: f64,
    weights: (&[f64], &[f64]),
    dt: T::Real,
    (zero, increment): (&P::Rate, &mut P::Rate),
    (position, rate): (&mut P, &mut P::Rate),
) {
    gather(increment, zero, dt * dt, weights.0, slopes);
    position.drift(&past.position, T::Real::of(node) * dt, &past.rate, &[T::Real::one()], [increment]);
    gather(rate, &past.rate, dt, weights.1, slopes);
}

/// Mean square of errors in positions and rates, as multiples of a tolerance (absolute and relative).
pub(super) fn mean_square<T: Scalar, P: Position<T>, C: Closures>(
    next: &Motion<T, P, C>,
    (position, rate): (&P::Rate, &P::Rate),
    tolerance: T::Real,
) -> f64 {
    let (mut sum, mut count) = (T::Real::zero(), 0usize);
    let mut note = |error: T, size: T::Real| {
        let share = error.real() / (tolerance * (T::Real::one() + size));
        sum += share * share;
        count += 1;
    };
    next.position.measure(position, &mut note);
    rate.all(&next.rate, &mut |error, rate| {
        note(error, rate.real().abs());
        true
    });
    sum.as_f64() / count.max(1) as f64
}
