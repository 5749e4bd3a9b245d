//! What a strut does: length, rate, tension and energy.

use super::strut::line;
use super::{Ends, Strut, Struts, dot, norm};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::SVector;

/// A strut in a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrutReading<T> {
    /// Distance of its ends (m).
    pub length: T,
    /// How fast its ends part (m/s).
    pub rate: T,
    /// Force (N) that draws its ends together; negative where it pushes.
    pub tension: T,
    /// Energy stored (J).
    pub energy: T,
}

impl<T: Scalar, const D: usize, W: SpringLaw<T>> Strut<T, D, W> {
    /// A reading of this strut, for place and velocity of both ends.
    fn reading(&self, ends: [[SVector<T, D>; 2]; 2]) -> StrutReading<T> {
        let [[from, starting], [to, ending]] = ends;
        let (energy, (direction, length, rate)) = (self.energy(from, to), line(ends));
        if length.is_zero() {
            return StrutReading { length, rate: norm(ending - starting), tension: norm(self.force(ends)), energy };
        }
        StrutReading { length, rate, tension: dot(direction, self.force(ends)), energy }
    }
}

impl<T: Scalar, const D: usize, const N: usize, L, W: SpringLaw<T>> Struts<T, D, N, L, W> {
    /// Readings of all struts, for places and velocities of their ends.
    pub(crate) fn readings_at(&self, ends: &Ends<T, D, N>) -> [StrutReading<T>; N] {
        core::array::from_fn(|k| self.struts[k].reading(ends[k]))
    }
}
