//! Laws of springs and dampers along one coordinate, in the plane and in space: how costates go backward through them.

use crate::element::{Implicit, Springs};
use crate::lift::Lift;
use crate::relation::{Absent, Coefficient, Term};
use crate::scalar::Scalar;
use crate::spring::{Spring, SpringLaw};
use crate::walks::{Led, Strain};

/// Most numbers that a joint is made of, those of its law among them.
pub const NUMBERS: usize = 6;
/// Most numbers of a rotary law of space: stiffnesses, dampings and rest values of three axes.
pub const ROTARY_NUMBERS: usize = NUMBERS + 3;

/// A law through which costates go backward.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the law `{Self}`",
    label = "not a law that the costate sweep knows",
    note = "it knows `Spring`, `DryFriction`, `Stops`, tuples of these, and laws of the user's own in hinges and struts (`ElasticHinge::with`, else `Custom(law)`) that are generic over the scalar and can be lifted: `catena::lift!`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleLaw<T: Scalar>: SpringLaw<T> {
    /// The costates of position and rate, given that of the force; adds to those of the law's numbers, in the order in which [`Lift`] meets
    /// them.
    fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2];

    /// Costates of position and rate, given that of force + pivot × change, which an implicit sweep reads where the last one has led.
    fn pull_back_led(&self, at: [T; 3], of_force: T, springs: Implicit<T::Real>, of_numbers: &mut [T]) -> [T; 2];
}

/// Of how many numbers something is made.
pub fn count<T: Scalar, L: Lift<T, T>>(law: &L) -> usize {
    let mut count = 0;
    law.lift(&mut |number| {
        count += 1;
        number
    });
    count
}

/// What a law gives in a sweep through which costates go backward, force and pivot: where the last sweep has led, if it is not linear, or
/// without the acceleration sought, as [`read`](crate::spring::read).
#[cfg_attr(optimised, inline(always))]
pub fn force<T: Scalar, L: SpringLaw<T>, By: Springs<T>>(law: &L, at: [T; 2], led: [T; 3], springs: By) -> [T; 2] {
    if const { L::LINEAR || !By::STIFF } {
        return [law.force(at[0], at[1]), law.pivot(at[0], at[1], springs)];
    }
    let [position, rate, acceleration] = led;
    let pivot = law.pivot(position, rate, springs);
    [pivot.mul_add(acceleration, law.force(position, rate)), pivot]
}

/// What a law does to costates where it is read apart from the geometry: of position and rate without the acceleration sought, or, where it
/// is not linear, of those to which the last sweep has led, and of the acceleration that did.
#[cfg_attr(optimised, inline(always))]
pub fn strain<T: Scalar, L: ReversibleLaw<T>>(
    follows: bool,
    law: &L,
    walk: &mut Strain<T>,
    ([position, rate, w], led): ([T; 3], Led<T>),
    sums: &mut [T],
) -> ([T; 2], Led<T>) {
    let none = T::zero();
    if !follows {
        return (law.pull_back(position, rate, w, sums), [none; 3]);
    }
    let [position, rate, change] = led;
    let [of_position, of_rate] = law.pull_back_led(led, w, walk.springs, sums);
    walk.of_size += w * change * law.pivot(position, rate, walk.by_size);
    ([none; 2], [of_position, of_rate, w * law.pivot(position, rate, walk.springs)])
}

impl<T: Scalar> ReversibleLaw<T> for Absent {
    #[inline(always)]
    fn pull_back(&self, _: T, _: T, _: T, _: &mut [T]) -> [T; 2] {
        [T::zero(); 2]
    }
    fn pull_back_led(&self, _: [T; 3], _: T, _: Implicit<T::Real>, _: &mut [T]) -> [T; 2] {
        [T::zero(); 2]
    }
}

impl<T: Scalar, K, D, P> ReversibleLaw<T> for Spring<K, D, P>
where
    K: Coefficient<T> + Lift<T, T>,
    D: Coefficient<T> + Lift<T, T>,
    P: Term<T> + Lift<T, T>,
{
    #[cfg_attr(optimised, inline(always))]
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
    /// The pivot has slopes by stiffness and damping alone.
    fn pull_back_led(
        &self,
        [position, rate, change]: [T; 3],
        of_force: T,
        springs: Implicit<T::Real>,
        of_numbers: &mut [T],
    ) -> [T; 2] {
        let found = self.pull_back(position, rate, of_force, of_numbers);
        let (of_pivot, mut sums) = (of_force * change, of_numbers.iter_mut());
        let mut add = |number: T, factor: T::Real| {
            if let Some(sum) = sums.next() {
                *sum += of_pivot.scale(factor);
            }
            number
        };
        self.stiffness.lift(&mut |k| add(k, springs.position));
        self.damping.lift(&mut |c| add(c, springs.rate));
        found
    }
}
