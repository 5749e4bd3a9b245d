//! The least x with A x = b, where some of x are held at zero and rows of A may follow from others.

use crate::scalar::{Elementary, Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;

/// How much of a row must be left, as a share of what it was with nothing held, where it is a condition of its own.
const OWN: f64 = 1e-7;

/// The least numbers (by the sum of their squares) that change each condition by `wanted`: `rows` are changes for unit numbers. Those
/// that are `held` stay zero, and conditions that depend on others are left to these: whether they are met has to be looked at.
pub(super) fn least_change<T: Scalar>(mut rows: Vec<Vec<T>>, wanted: &[T], held: &[bool]) -> Vec<T> {
    let own = T::Real::of(OWN).max(T::Real::EPSILON.sqrt());
    let whole: Vec<T::Real> = rows.iter().map(|row| norm(row)).collect();
    for row in &mut rows {
        row.iter_mut().zip(held).filter(|(_, held)| **held).for_each(|(x, _)| *x = T::zero());
    }
    let mut left = wanted.to_vec();
    let mut change = vec![T::zero(); held.len()];
    let mut waiting: Vec<usize> = (0..rows.len()).collect();
    // Rows made orthogonal to those before, the one of which most is left first.
    while let Some((at, _)) = waiting
        .iter()
        .enumerate()
        .map(|(at, row)| (at, norm(&rows[*row]) / whole[*row]))
        .filter(|(_, share)| *share > own)
        .reduce(|most, next| if next.1 > most.1 { next } else { most })
    {
        let row = waiting.swap_remove(at);
        let length = dot(&rows[row], &rows[row]).sqrt().recip();
        let direction: Vec<T> = rows[row].iter().map(|x| *x * length).collect();
        let along = left[row] * length;
        for (x, direction) in change.iter_mut().zip(&direction) {
            *x = along.mul_add(*direction, *x);
        }
        for other in &waiting {
            let share = dot(&rows[*other], &direction);
            left[*other] = (-share).mul_add(along, left[*other]);
            for (x, direction) in rows[*other].iter_mut().zip(&direction) {
                *x = (-share).mul_add(*direction, *x);
            }
        }
    }
    change
}

fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (a, b)| a.mul_add(*b, sum))
}

fn norm<T: Scalar>(row: &[T]) -> T::Real {
    row.iter().fold(T::Real::of(0.0), |sum, x| sum + x.real() * x.real()).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conditions_are_met_by_the_least_change() {
        let rows = vec![vec![1.0, 2.0, -1.0, 0.5], vec![0.0, 1.0, 1.0, 3.0], vec![1.0, 3.0, 0.0, 3.5]];
        // The third is the sum of the others.
        let change = least_change(rows.clone(), &[1.0, -2.0, -1.0], &[false, false, true, false]);
        assert_eq!(change[2], 0.0);
        for (row, wanted) in rows.iter().zip([1.0, -2.0, -1.0]) {
            assert!((dot(row, &change) - wanted).abs() < 1e-14);
        }
        // The only direction that is left open is normal to it: (1, 2, ½) × (0, 1, 3).
        assert!((dot(&[change[0], change[1], change[3]], &[5.5, -3.0, 1.0])).abs() < 1e-14);
        // Nothing is left to move.
        assert_eq!(least_change(rows, &[1.0; 3], &[true; 4]), [0.0; 4]);
    }
}
