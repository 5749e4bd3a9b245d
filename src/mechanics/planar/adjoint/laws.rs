//! The costate sweep in the plane: what laws of the user's own do.

pub(crate) use crate::adjoint::laws::{NUMBERS, ReversibleLaw, force, strain};

use crate::element::Implicit;
use crate::lift::Lift;
use crate::mechanics::planar::spring::Custom;
use crate::scalar::{Jet, Scalar};
use crate::spring::SpringLaw;

/// Position, rate and numbers of a law.
const INPUTS: usize = NUMBERS + 2;

/// A law of the user's own: on jets of its position, its rate and its numbers.
impl<T: Scalar, L> ReversibleLaw<T> for Custom<L>
where
    L: SpringLaw<T> + Lift<T, Jet<T, INPUTS>, Over: SpringLaw<Jet<T, INPUTS>>>,
{
    fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2] {
        let mut seed = 1;
        let law = self.0.lift(&mut |number| {
            seed += 1;
            Jet::seed(number, seed)
        });
        let [of_position, of_rate, each @ ..] = law.force(Jet::seed(position, 0), Jet::seed(rate, 1)).eps;
        of_numbers.iter_mut().zip(each).for_each(|(sum, slope)| *sum += of_force * slope);
        [of_position * of_force, of_rate * of_force]
    }
    /// Second derivatives of the force are first ones of the pivot.
    fn pull_back_led(
        &self,
        [position, rate, change]: [T; 3],
        of_force: T,
        springs: Implicit<T::Real>,
        of_numbers: &mut [T],
    ) -> [T; 2] {
        let mut seed = 1;
        let law = self.0.lift(&mut |number| {
            seed += 1;
            Jet::seed(number, seed)
        });
        let (position, rate) = (Jet::seed(position, 0), Jet::seed(rate, 1));
        let (force, pivot) = (law.force(position, rate), law.pivot(position, rate, springs));
        let slope = |k: usize| of_force * pivot.eps[k].mul_add(change, force.eps[k]);
        of_numbers.iter_mut().zip(2..INPUTS).for_each(|(sum, k)| *sum += slope(k));
        [slope(0), slope(1)]
    }
}
