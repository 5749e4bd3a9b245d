//! The costate sweep in the plane: what laws of springs and dampers do.

use crate::lift::Lift;
use crate::mechanics::planar::spring::Custom;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::{Jet, Scalar};
use crate::spring::{Spring, SpringLaw};

/// Most numbers that a joint is made of, those of its law among them.
pub(crate) const NUMBERS: usize = 6;
/// Position, rate and numbers of a law.
const INPUTS: usize = NUMBERS + 2;

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
}
