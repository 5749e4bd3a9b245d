//! Rates as plain lists of numbers, root to tip.

use crate::mirror::Rate;
use crate::scalar::Scalar;
use alloc::vec;
use alloc::vec::Vec;

/// The numbers of a rate, root to tip.
pub(crate) fn numbers<T: Scalar, V: Rate<T>>(rate: &V) -> Vec<T> {
    let mut numbers = vec![];
    rate.visit(&mut |x| numbers.push(x));
    numbers
}

/// Sets the numbers of a rate, root to tip.
pub(crate) fn set<T: Scalar, V: Rate<T>>(rate: &mut V, numbers: impl IntoIterator<Item = T>) {
    let mut numbers = numbers.into_iter();
    rate.replace(&mut |_| numbers.next().unwrap_or(T::zero()));
}

/// Unit vector `j` of `n`.
pub(crate) fn unit<T: Scalar>(n: usize, j: usize) -> impl Iterator<Item = T> {
    (0..n).map(move |i| if i == j { T::one() } else { T::zero() })
}
