//! Inertial parameters of all bodies of a robot, by their joints.

use super::number::{triangle_values, values};
use super::standing::Standing;
use super::through::{Solid, Through, through};
use crate::scalar::Scalar;

/// Mass, first moment (x, y, z) and tensor about the origin (xx, yy, zz, yz, xz, xy) of a body, in its axes.
pub type Parameters<T> = [T; 10];

/// Parameters of the base, and of the bodies on joints.
pub struct Solids<T, const N: usize> {
    pub base: Parameters<T>,
    pub bodies: [Parameters<T>; N],
    pub next: usize,
}

through!([const N: usize] Solids<T, N>, usize, outward);

impl<T: Scalar, const N: usize> Through<T> for Solids<T, N> {
    #[inline(always)]
    fn axis<A: Standing<T>>(&mut self, _: &A, _: usize) -> usize {
        self.next += 1;
        self.next - 1
    }
    #[cfg_attr(optimised, inline(always))]
    fn link<B: Solid<T>>(&mut self, link: &B, own: usize) -> usize {
        let ([x, y, z], [a, b, c, d, e, f]) = (values(link.moment()), triangle_values(link.tensor()));
        let body = self.bodies.get_mut(own).unwrap_or(&mut self.base);
        body.iter_mut().zip([link.mass(), x, y, z, a, b, c, d, e, f]).for_each(|(sum, number)| *sum += number);
        own
    }
}
