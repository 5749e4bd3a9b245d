//! Derivatives by the numbers that something is made of, along the seeds of the same over jets.

use crate::lift::Lift;
use crate::scalar::{Jet, Scalar};

/// Σ of derivatives, in the order in which [`Lift`] meets the numbers, times seeds.
pub(super) fn along<T: Scalar, V: Lift<Jet<T, K>, T>, const K: usize>(
    by: impl IntoIterator<Item = T>,
    over: &V,
) -> [T; K] {
    let (mut sum, mut list) = ([T::zero(); K], by.into_iter());
    over.lift(&mut |number: Jet<T, K>| {
        if let Some(by) = list.next() {
            sum.iter_mut().zip(number.eps).for_each(|(sum, part)| *sum += by * part);
        }
        number.re
    });
    sum
}
