//! The angles that positions of a robot stand for.

use super::standing::Standing;
use super::through::{Solid, Through, through};
use crate::scalar::Scalar;

/// Positions of joints, which become the angles that they stand for.
pub struct Angles<T, const N: usize> {
    pub list: [T; N],
    pub next: usize,
}

through!([const N: usize] Angles<T, N>, (), outward);

impl<T: Scalar, const N: usize> Through<T> for Angles<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, (): ()) {
        let own = self.next;
        self.next += 1;
        self.list[own] = axis.angle(self.list[own]);
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, (): ()) {}
}
