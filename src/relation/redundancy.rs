//! Closures that say the same twice.

/// How small a pivot of Λ may be, as a share of its measure, where closures are independent: rounding leaves 1e-16 of a dependent
/// one, and a mechanism must come within 1e-5 rad of a singular place to have 1e-10.
const SMALLEST: f64 = 1e-10;
/// How small a pivot may be, as a share of its measure, where some closures may follow from others. Rounding leaves up to 2e-15 of one that
/// does (random four-bars), axes given to six digits up to 1e-11; at a distance (rad) from a dead point a closure that is needed has 0.1 to 1 times its square.
const FOLLOWING: f64 = 1e-11;
/// How small such a pivot may be for numbers that round coarsely, in roundings: 3 are left of one that follows from others.
const FOLLOWING_ROUNDINGS: f64 = 32.0;
/// How large a pivot of a closure that follows from others may be, in squares of the share of its size by which a loop is open: where closures
/// follow from others in closed postures alone, as Bennett's, a stage of a step is off these by what the rule has left out, and up to 26 squares
/// are left. Were they taken for independent, what they miss would be divided by next to nothing.
const OPEN: f64 = 64.0;
/// The most that an open loop makes of it: what is far from closed is to close.
const MOST_OPEN: f64 = 1e-5;
/// The smallest share for numbers that round coarsely, in roundings: straight chains of up to a thousand rods leave less of a
/// dependent pivot, and chains that are straight but for a thousandth of a radian have more.
const ROUNDINGS: f64 = 8.0;

/// How small a pivot may be, as a share of its measure, for numbers of this rounding.
pub(super) fn smallest_share(rounding: f64) -> f64 {
    SMALLEST.max(ROUNDINGS * rounding)
}

/// How small a pivot may be, as a share of its measure, where some may follow from others in a loop that is open by this share of its size.
pub(super) fn following_share(rounding: f64, open: f64) -> f64 {
    FOLLOWING.max(FOLLOWING_ROUNDINGS * rounding).max((OPEN * open * open).min(MOST_OPEN))
}

/// How much of a number of about one rounding may be, where pivots as small as this share of their measure divide.
pub(super) fn rounded(rounding: f64, least: f64) -> f64 {
    ROUNDINGS * rounding / least
}

/// Whether a pivot can be measured by this: not where no body has mass, or no extent to turn.
fn has_measure(measure: f64) -> bool {
    measure > 0.0 && measure.is_finite()
}

/// A row of a positive semidefinite matrix that depends on others, and the rank: by elimination with diagonal pivots, the largest
/// share of its measure first, down to the `least` share or that which `rounding`, of its numbers, leaves. Of the matrix the lower
/// triangle is read. What has no measure is measured by its own diagonal.
pub(super) fn dependent_row<const L: usize>(
    matrix: [[f64; L]; L],
    measure: [f64; L],
    least: f64,
    rounding: f64,
) -> Option<(usize, usize)> {
    if !matrix.iter().flatten().all(|entry| entry.is_finite()) {
        return None; // something else is wrong
    }
    let smallest = smallest_share(rounding).max(least);
    let mut rest: [[f64; L]; L] =
        core::array::from_fn(|i| core::array::from_fn(|j| if j <= i { matrix[i][j] } else { matrix[j][i] }));
    let measure: [f64; L] = core::array::from_fn(|i| if has_measure(measure[i]) { measure[i] } else { rest[i][i] });
    let mut waiting = [true; L];
    for rank in 0..L {
        let shares = (0..L).filter(|i| waiting[*i]).map(|i| (rest[i][i] / measure[i], i));
        let (share, row) = shares.fold((f64::NEG_INFINITY, 0), |best, next| if next.0 > best.0 { next } else { best });
        if share <= smallest {
            return Some(((0..L).rev().find(|i| waiting[*i]).unwrap_or(row), rank));
        }
        waiting[row] = false;
        let pivot = rest[row];
        for other in (0..L).filter(|i| waiting[*i]) {
            let factor = rest[other][row] / pivot[row];
            for (entry, above) in rest[other].iter_mut().zip(pivot) {
                *entry -= factor * above;
            }
        }
    }
    None
}
