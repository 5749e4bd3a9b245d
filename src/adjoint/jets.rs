//! Laws through which costates go backward by jets of what they read, and several laws along one coordinate.

use super::laws::{NUMBERS, ReversibleLaw, count};
use crate::element::Implicit;
use crate::lift::Lift;
use crate::scalar::{Jet, Scalar};
use crate::spring::{Custom, DryFriction, SpringLaw, Stops};

/// Position, rate and numbers of a law.
const INPUTS: usize = NUMBERS + 2;
/// A number with derivatives by all these.
pub type Read<T> = Jet<T, INPUTS>;

/// A law over jets of its numbers, from a seed on, and how many it has. Seeds beyond the last are none, nor are those before the first, of a seed that
/// wraps around.
pub fn seeded<T: Scalar, L: Lift<T, Jet<T, N>>, const N: usize>(law: &L, first: usize) -> (L::Over, usize) {
    let mut count = 0;
    let over = law.lift(&mut |number| {
        count += 1;
        Jet::seed(number, first.wrapping_add(count - 1))
    });
    (over, count)
}

/// [`ReversibleLaw::pull_back`] of a law on jets of its position, its rate and its numbers.
pub fn pull_back<T, L>(law: &L, [position, rate]: [T; 2], of_force: T, of_numbers: &mut [T]) -> [T; 2]
where
    T: Scalar,
    L: Lift<T, Read<T>, Over: SpringLaw<Read<T>>>,
{
    let force = seeded(law, 2).0.force(Jet::seed(position, 0), Jet::seed(rate, 1));
    let [of_position, of_rate, each @ ..] = force.eps;
    of_numbers.iter_mut().zip(each).for_each(|(sum, slope)| *sum += of_force * slope);
    [of_position * of_force, of_rate * of_force]
}

/// [`ReversibleLaw::pull_back_led`] of such a law: second derivatives of the force are first ones of the pivot.
pub fn pull_back_led<T, L>(
    law: &L,
    [position, rate, change]: [T; 3],
    of_force: T,
    springs: Implicit<T::Real>,
    of_numbers: &mut [T],
) -> [T; 2]
where
    T: Scalar,
    L: Lift<T, Read<T>, Over: SpringLaw<Read<T>>>,
{
    let (law, position, rate) = (seeded(law, 2).0, Jet::seed(position, 0), Jet::seed(rate, 1));
    let (force, pivot) = (law.force(position, rate), law.pivot(position, rate, springs));
    let slope = |k: usize| of_force * pivot.eps[k].mul_add(change, force.eps[k]);
    of_numbers.iter_mut().zip(2..INPUTS).for_each(|(sum, k)| *sum += slope(k));
    [slope(0), slope(1)]
}

macro_rules! by_jets {
    ($($Law:ident),*) => {$(
        impl<T: Scalar, X> ReversibleLaw<T> for $Law<T, X>
        where
            Self: SpringLaw<T> + Lift<T, Read<T>, Over: SpringLaw<Read<T>>>,
        {
            fn pull_back(&self, position: T, rate: T, of_force: T, of_numbers: &mut [T]) -> [T; 2] {
                pull_back(self, [position, rate], of_force, of_numbers)
            }
            fn pull_back_led(
                &self,
                at: [T; 3],
                of_force: T,
                springs: Implicit<T::Real>,
                of_numbers: &mut [T],
            ) -> [T; 2] {
                pull_back_led(self, at, of_force, springs, of_numbers)
            }
        }
    )*};
}
by_jets!(DryFriction, Stops);

/// A law of the user's own.
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

/// The rest of a list, after as many numbers as a law has.
fn beyond<'l, T: Scalar>(law: &impl Lift<T, T>, list: &'l mut [T]) -> (&'l mut [T], &'l mut [T]) {
    list.split_at_mut(count(law).min(list.len()))
}

/// Several laws: what each does adds up, and their numbers come one after the other.
macro_rules! laws {
    ($($Law:ident $i:tt),*) => {
        impl<T: Scalar, $($Law: ReversibleLaw<T> + Lift<T, T>),*> ReversibleLaw<T> for ($($Law,)*) {
            fn pull_back(&self, position: T, rate: T, of_force: T, numbers: &mut [T]) -> [T; 2] {
                let mut sum = [T::zero(); 2];
                $(
                    let (own, numbers) = beyond(&self.$i, numbers);
                    let [of_position, of_rate] = self.$i.pull_back(position, rate, of_force, own);
                    sum = [sum[0] + of_position, sum[1] + of_rate];
                )*
                let _ = numbers;
                sum
            }
            fn pull_back_led(
                &self,
                at: [T; 3],
                of_force: T,
                springs: Implicit<T::Real>,
                numbers: &mut [T],
            ) -> [T; 2] {
                let mut sum = [T::zero(); 2];
                $(
                    let (own, numbers) = beyond(&self.$i, numbers);
                    let [of_position, of_rate] = self.$i.pull_back_led(at, of_force, springs, own);
                    sum = [sum[0] + of_position, sum[1] + of_rate];
                )*
                let _ = numbers;
                sum
            }
        }
    };
}
laws!(A 0, B 1);
laws!(A 0, B 1, C 2);
laws!(A 0, B 1, C 2, D 3);
laws!(A 0, B 1, C 2, D 3, E 4);
