//! Ends that hold some directions of a body's attitude.
//!
//! The conditions are linear in its axes, and these, as a step expands them, in the coordinates; so no coordinates need be those of the end.

use super::algebra::{Matrix, Vector, apply, cross, from_fn, transposed};
use crate::mechanics::spatial::Frame;
use crate::paper::link::{End, dot, inverse};
use crate::paper::orient::Axes;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Real, Scalar};
use nalgebra::Vector3;

/// A root that turns about an axis of the ground, with a torque about it applied on the first body.
pub fn hinged_root<T: Scalar>(axis: Vector<T>, ground: &Frame<T>, first: &Axes<T, 3, 3>, drive: T) -> End<T, 6> {
    let attitude = super::algebra::rows(&ground.turn.attitude);
    let [along, one, two] = basis(axis).map(|direction| apply(&attitude, direction));
    let mut end = End::along_axes([true, true, true, true, true, false], [T::zero(); 6]);
    // The body's own axis has no part across that of the ground.
    let own = |k: usize| axis[k];
    let conditions = [one, two].map(|across| {
        let row = core::array::from_fn(|c| sum(|k| own(k) * sum(|i| across[i] * first.slopes[k][i][c])));
        (row, -sum(|k| own(k) * dot(&across, &first.points[k])))
    });
    turn(&mut end, [conditions[0].0, conditions[1].0, cross(conditions[0].0, conditions[1].0)], [one, two, along]);
    end.known[3..].copy_from_slice(&[conditions[0].1, conditions[1].1, -drive]);
    end
}

/// Adds to a tip whose place is held so many conditions of its attitude. They are closures from the fourth on: the residuals of an attitude,
/// and the torque that each exerts.
pub fn hold_attitude<T: Scalar>(
    end: &mut End<T, 6>,
    count: usize,
    last: &Axes<T, 3, 3>,
    residual: impl Fn(Columns<T>) -> [T; 6],
    pull: impl Fn(usize) -> Vector<T>,
) {
    let none = [T::zero(); 3];
    let columns = |place: Matrix<T>| {
        let [x, y, z] = place.map(Vector3::from);
        residual(Columns { x, y, z })
    };
    let unit = |k: usize, v: Vector<T>| core::array::from_fn(|j| if j == k { v } else { none });
    // Conditions are linear, so what the axes add to nothing.
    let moved = [0, 1, 2].map(|c| {
        (0..3).fold([T::zero(); 6], |sum, k| {
            let one = columns(unit(k, core::array::from_fn(|i| last.slopes[k][i][c])));
            core::array::from_fn(|j| sum[j] + one[j])
        })
    });
    let at = columns(last.points);
    let mut rows = from_fn(|j, c| moved[c][3 + j]);
    let mut pulls = [0, 1, 2].map(|j| if j < count { pull(3 + j) } else { none });
    let known: Vector<T> = core::array::from_fn(|j| if j < count { -at[3 + j] } else { T::zero() });
    if count == 2 {
        (rows[2], pulls[2]) = (cross(rows[0], rows[1]), cross(pulls[0], pulls[1]));
    }
    turn(end, rows, pulls);
    end.held[3..].copy_from_slice(&[true, true, count == 3]);
    end.known[3..].copy_from_slice(&known);
}

/// Puts directions in the slot of the angles.
fn turn<T: Scalar>(end: &mut End<T, 6>, rows: Matrix<T>, pulls: Matrix<T>) {
    let columns = transposed(&inverse(&rows));
    for k in 0..3 {
        for i in 0..3 {
            end.axes[3 + k][3 + i] = rows[k][i];
            end.bases[3 + k][3 + i] = columns[k][i];
            end.pulls[3 + k][3 + i] = pulls[k][i];
        }
    }
}

fn sum<T: Scalar>(term: impl Fn(usize) -> T) -> T {
    term(0) + term(1) + term(2)
}

/// An axis of length one, and two directions across it.
fn basis<T: Scalar>(axis: Vector<T>) -> [Vector<T>; 3] {
    let x = from_fn(|i, j| if i == j { T::one() } else { T::zero() });
    let beyond = axis[0].abs() - T::constant(T::Real::of(0.6)); // lanes decide each for itself
    let other = core::array::from_fn(|i| beyond.if_negative(x[0][i], x[1][i]));
    let one = cross(axis, other);
    let length = dot(&one, &one).sqrt().recip();
    let one = one.map(|x| x * length);
    [axis, one, cross(axis, one)]
}
