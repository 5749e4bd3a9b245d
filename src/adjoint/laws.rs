//! Laws of springs and dampers along one coordinate, in the plane and in space: how costates go backward through them.

use crate::element::{Explicit, Implicit};
use crate::lift::Lift;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};

/// How springs enter sweeps through which costates go backward, where the law `L` is among them: implicitly, laws that are linear in position
/// and rate, which a sweep takes exactly.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run by an implicit rule goes backward through the law `{L}`",
    label = "an implicit rule, of which the costate sweep knows `Spring`",
    note = "explicit rules know laws of the user's own in hinges, too"
)]
pub trait Reads<L> {}

impl<L> Reads<L> for Explicit {}

impl<R> Reads<Absent> for Implicit<R> {}

impl<R, K, D, P> Reads<Spring<K, D, P>> for Implicit<R> {}

/// Most numbers that a joint is made of, those of its law among them.
pub const NUMBERS: usize = 6;
/// A law through which costates go backward.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the law `{Self}`",
    label = "not a law that the costate sweep knows",
    note = "it knows `Spring` and laws of the user's own in hinges (`ElasticHinge::with`) that are generic over the scalar and can be lifted: `catena::lift!`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleLaw<T: Scalar>: SpringLaw<T> {
    /// The costates of position and rate, given that of the force; adds to those of the law's numbers, in the order in which [`Lift`] meets
    /// them.
    fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2];
}

impl<T: Scalar> ReversibleLaw<T> for Absent {
    #[inline(always)]
    fn pull_back(&self, _: T, _: T, _: T, _: &mut [T]) -> [T; 2] {
        [T::zero(); 2]
    }
}

impl<T: Scalar, K, D, P> ReversibleLaw<T> for Spring<K, D, P>
where
    K: Coefficient<T> + Lift<T, T>,
    D: Coefficient<T> + Lift<T, T>,
    P: Term<T> + Lift<T, T>,
{
    #[inline(always)]
    fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2] {
        let Self { stiffness, damping, rest } = self;
        let strain = rest.take_from(position);
        let slopes = [-stiffness.times_onto(of_force, T::zero()), -damping.times_onto(of_force, T::zero())];
        let mut sums = of_numbers.iter_mut();
        // For each number that there is: as many as the types of the spring say.
        let mut add = |number: T, more: T| {
            if let Some(sum) = sums.next() {
                *sum += more;
            }
            number
        };
        stiffness.lift(&mut |k| add(k, -(strain * of_force)));
        damping.lift(&mut |c| add(c, -(rate * of_force)));
        rest.lift(&mut |u| add(u, -slopes[0]));
        slopes
    }
}
