//! The costate sweep under force elements.
//!
//! Over virtual velocities W and w of the inboard ends of its bodies a force element does π = Σ (W·f + w·m). Costates of what it reads of a body come
//! from jets of just that, and those of its numbers from jets of these, a few at a time.

use crate::scalar::Scalar;

/// Most numbers that the law of a force element is made of.
pub const FORCE: usize = 32;

/// Costates of the numbers of such a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfForce<T> {
    list: [T; FORCE],
    /// How many these are.
    count: usize,
}

impl<T: Scalar> OfForce<T> {
    /// None yet, of so many numbers.
    pub(crate) fn none(count: usize) -> Self {
        Self { list: [T::zero(); FORCE], count }
    }

    /// How many numbers there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// Of each number there is room for.
    pub fn list(&self) -> &[T] {
        self.list.get(..self.count).unwrap_or(&self.list)
    }

    /// Of each number there is room for.
    pub(crate) fn list_mut(&mut self) -> &mut [T] {
        let count = self.count.min(FORCE);
        &mut self.list[..count]
    }
}

/// Force elements of a space, as what acts on bodies in runs that go backward.
macro_rules! force_elements {
    ($Space:ident) => {
        impl<T: Scalar, F, L, const N: usize> BodyLaw<$Space<T>> for ForceElement<F, N, L>
        where
            F: ForceLaw<$Space<T>, N> + Lift<T, T> + Copy,
            L: ActsOnBodies<$Space<T>>,
            L::Law: LoadLaw<BodyMotion<T>, Value: Load<$Space<T>>> + BodyLaw<$Space<T>, OfNumbers = OfLaw<T>>,
        {
            type Beside<J: LoadLaw<JointMotion<T>> + Clone> = ForceElement<F, N, Loads<L::Law, J>>;
            type Whole<J: LoadLaw<JointMotion<T>, Value = $crate::loading::EffortOf<$Space<T>>> + Clone> =
                Self::Beside<J>;
            type OfNumbers = (OfForce<T>, OfLaw<T>);
            type Stirred = [(Vector<T>, Angular<T>); N];
            type Ties = ();

            fn beside<J: LoadLaw<JointMotion<T>> + Clone>(self, efforts: J) -> Self::Beside<J> {
                let others = Loads::none().on_bodies_by(self.others.law()).in_joints_by(efforts);
                ForceElement::by(self.bodies, self.law).and(others)
            }
            fn whole<J: LoadLaw<JointMotion<T>, Value = $crate::loading::EffortOf<$Space<T>>> + Clone>(
                self,
                efforts: J,
            ) -> Self::Beside<J> {
                self.beside(efforts)
            }
            fn of_nothing(&self) -> Self::OfNumbers {
                (OfForce::none(count(&self.law)), self.others.law().of_nothing())
            }
            fn known(&self, (of_force, _): &Self::OfNumbers) -> Result<(), Fault> {
                let (expected, given) = (FORCE, of_force.count());
                let list = "numbers of a law of a force element";
                if given <= expected { Ok(()) } else { Err(Fault::Count { list, expected, given }) }
            }
            fn unstirred() -> Self::Stirred {
                [(Additive::null(), Additive::null()); N]
            }
            fn ties(&self) {}
            fn of_ties(_: &mut Self::OfNumbers) -> [&mut [T]; 2] {
                [&mut [], &mut []]
            }
            fn listed((_, of_law): &Self::OfNumbers) -> &OfLaw<T> {
                of_law
            }
            fn each_number((of_force, of_law): &mut Self::OfNumbers, meet: &mut impl FnMut(&mut T)) {
                of_force.list_mut().iter_mut().for_each(&mut *meet);
                <L::Law as BodyLaw<$Space<T>>>::each_number(of_law, meet);
            }
        }

        impl<T: Scalar, F, L, const N: usize> ActsOnBodies<$Space<T>> for ForceElement<F, N, L>
        where
            L: Loading<$Space<T>> + Copy,
            F: ForceLaw<$Space<T>, N> + Copy,
            Self: BodyLaw<$Space<T>, Ties = ()> + Loading<$Space<T>>,
        {
            type Law = Self;
            fn law(&self) -> Self {
                *self
            }
        }

        impl<T: Scalar, F, L, const N: usize> ReversibleLoads<$Space<T>> for ForceElement<F, N, L>
        where
            F: ForceLaw<$Space<T>, N> + Lift<T, T> + Lift<T, Read<T>, Over: ForceLaw<$Space<Read<T>>, N>> + Copy,
            L: ActsOnBodies<$Space<T>>,
            L::Law: LoadLaw<BodyMotion<T>, Value: Load<$Space<T>>> + ReversibleLoads<$Space<T>, OfNumbers = OfLaw<T>>,
        {
            fn felt(
                walk: &mut PullLoads<Self, $Space<T>>,
                numbers: [T; BODY],
                frame: &Frame<T>,
                stirred: (Vector<T>, Angular<T>),
                sums: &mut [T; BODY],
            ) -> Felt<T> {
                let PullLoads { law, seen: ((seen, ()), all), surveys, time, body, level, of_law } = walk;
                let ((of_force, of_law), met) = (of_law, |k: &usize| law.bodies[*k] == *body);
                if *surveys {
                    (0..N).filter(met).for_each(|k| all[k] = stirred);
                    return Felt::null();
                }
                let mut felt = Felt::null();
                if let Some(first) = (0..N).find(met) {
                    let bodies = seen.map(|seen| seen.map_or(read(frame, numbers), |seen| still(&seen)));
                    let own = |k: usize| if law.bodies[k] == *body { read(frame, numbers) } else { bodies[k] };
                    let constant = <F as Lift<T, Read<T>>>::lift(&law.law, &mut Jet::of);
                    let loads = constant.loads(*time, &core::array::from_fn(own));
                    let slope = |k: usize| {
                        let terms = loads.iter().zip(&*all).map(|(load, weights)| slope(*weights, load, k));
                        terms.fold(T::zero(), |sum, term| sum + term)
                    };
                    add_numbers(sums, slope);
                    let on_body = (0..N).filter(met).fold(Wrench::none(), |sum, k| sum + value(&loads[k]));
                    felt = felt_by(slope, on_body, frame, stirred.1);
                    if first == 0 {
                        let list = of_force.list_mut();
                        for (block, sums) in list.chunks_mut(READ).enumerate() {
                            // The first number of the block is seed 0.
                            let over = seeded::<T, F, READ>(&law.law, 0_usize.wrapping_sub(block * READ)).0;
                            let loads = over.loads(*time, &bodies);
                            for (k, sum) in sums.iter_mut().enumerate() {
                                for (load, weights) in loads.iter().zip(&*all) {
                                    *sum += self::slope(*weights, load, k);
                                }
                            }
                        }
                    }
                }
                if const { !<L::Law as BodyLaw<$Space<T>>>::ON } {
                    return felt;
                }
                let at = (*time, *body, *level);
                felt + felt_beside(law.others.law(), at, of_law, numbers, frame, stirred, sums)
            }
        }
    };
}
pub(crate) use force_elements;
