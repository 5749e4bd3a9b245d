//! The costate sweep in the plane: what laws of the user's own do.

pub(crate) use crate::adjoint::laws::{NUMBERS, ReversibleLaw, force, strain};

use crate::adjoint::jets::{Read, pull_back, pull_back_led};
use crate::element::Implicit;
use crate::lift::Lift;
use crate::mechanics::planar::spring::Custom;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;

/// A law of the user's own, by jets.
impl<T: Scalar, L> ReversibleLaw<T> for Custom<L>
where
    L: SpringLaw<T> + Lift<T, Read<T>, Over: SpringLaw<Read<T>>>,
{
    fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2] {
        pull_back(&self.0, [position, rate], of_force, of_numbers)
    }
    fn pull_back_led(&self, at: [T; 3], of_force: T, springs: Implicit<T::Real>, of_numbers: &mut [T]) -> [T; 2] {
        pull_back_led(&self.0, at, of_force, springs, of_numbers)
    }
}
