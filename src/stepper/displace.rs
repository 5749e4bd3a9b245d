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

/// So many numbers have rates of a scene with few coordinates: there what a step does beside its sweeps would count, and code of its own
/// for each row is not much.
const FEW: usize = 24;
/// And so many of these stand in fields of their own, for each of which there is code: loops over items of arrays a compiler unrolls where
/// that pays, and puts side by side. Runs of arms of seven joints take a quarter less time by it, of eight rods two fifths; of sixteen rods it
/// would be a twentieth, for twice the time to compile.
const FIELDS: usize = 8;

/// Whether sums of rates are formed in registers, row by row.
pub(crate) const fn are_few<T: Scalar, R: Rate<T>>() -> bool {
    R::LENGTH <= FEW && R::FIELDS <= FIELDS && !T::LARGE
}

/// `sum = Σ weight(j) · slopes[j]`, as by [`gather`] from zero on, for scenes of few coordinates: in one pass, in registers. Where a
/// compiler knows the weights, which it does in code without loops alone, those that are zero cost nothing.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn gather_few<T: Scalar, R: Rate<T>>(
    sum: &mut R,
    zero: &R,
    weight: impl Fn(usize) -> Option<f64>,
    slopes: &[R],
) {
    let mut all = zero.clone();
    macro_rules! add {
        ($j:expr) => {
            if let (Some(weight), Some(slope)) = (weight($j), slopes.get($j))
                && weight != 0.0
            {
                let mut more = zero.clone();
                more.mix_1(&all, (T::Real::of(weight), slope));
                all = more;
            }
        };
    }
    // Where nothing is optimised a loop is a tenth of that to compile.
    #[cfg(not(optimised))]
    for j in 0..16 {
        add!(j);
    }
    #[cfg(optimised)]
    {
        macro_rules! terms {
            ($($j:literal)*) => {$(add!($j);)*};
        }
        terms!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
    }
    *sum = all;
}

/// Calls with the number of a row as a literal, up to a last one: a compiler then knows the weights of the row.
macro_rules! with_row {
    ($row:expr, $last:expr, |$name:ident| $call:expr) => {
        $crate::stepper::displace::with_row!($row, $last, |$name| $call, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    ($row:expr, $last:expr, |$name:ident| $call:expr, $($literal:literal)*) => {
        match $row {
            $($literal if (0..=$last).contains(&$literal) => {
                let $name: usize = $literal;
                $call
            })*
            _ => {}
        }
    };
}
pub(crate) use with_row;

/// [`displace`] by weights that a compiler knows: in registers where rates are few.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn displace_by_row<T: Scalar, P: Position<T>, C: Closures>(
    past: &Motion<T, P, C>,
    slopes: &[P::Rate],
    node: f64,
    (of_position, of_rate): (&[f64], &[f64]),
    dt: T::Real,
    (zero, increment): (&P::Rate, &mut P::Rate),
    (position, rate): (&mut P, &mut P::Rate),
) {
    if const { are_few::<T, P::Rate>() } {
        gather_few(increment, zero, |j| of_position.get(j).copied(), slopes);
        position.drift_1(&past.position, (T::Real::of(node) * dt, &past.rate), (dt * dt, increment));
        // Positions hang on the row before last, rates on the last, which has just been written: in one register with these they would
        // wait for it, and sines with them, while they could be found in the meantime.
        core::hint::black_box(&mut *position);
        let mut of_rates = zero.clone(); // the increment of positions is left
        gather_few(&mut of_rates, zero, |j| of_rate.get(j).copied(), slopes);
        rate.mix_1(&past.rate, (dt, &of_rates));
    } else {
        displace(past, slopes, node, (of_position, of_rate), dt, (zero, increment), (position, rate));
    }
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
