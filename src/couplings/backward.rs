//! Couplings in runs that go backward, as [`Ties`] beside what acts on bodies.

use super::{Couplings, at, numbered};
use crate::adjoint::{ActsOnBodies, BodyLaw, LoadCostates, OfLaw, ReversibleLoads, Ties};
use crate::error::Fault;
use crate::loading::{EffortOf, LoadLaw, Loading, Unloaded, suits};
use crate::mechanics::planar::{self, Planar};
use crate::mechanics::spatial::{self, Spatial};
use crate::mirror::{Position, Rate};
use crate::relation::Geometry;
use crate::scalar::Scalar;
use crate::space::FrameOf;
use crate::transfer::FromEfforts;
use crate::visit::Level;
use crate::walks::pull_loads::PullLoads;
use num_traits::{One, Zero};

impl<S: FromEfforts, const K: usize> Ties<S> for Couplings<S::Scalar, K> {
    type Each<X: Clone> = [X; K];
    const COUNT: usize = K;

    fn each<X: Clone>(value: &X) -> [X; K] {
        core::array::from_fn(|_| value.clone())
    }
    fn add_rows<V: Rate<S::Scalar>>(&self, shares: &[S::Scalar; K], costates: &mut V) {
        for (tie, share) in self.ties.iter().zip(shares) {
            for (place, share) in tie.rates.into_iter().zip([*share, -tie.ratio * *share]) {
                let mut entry = S::Scalar::zero();
                costates.visit(&mut numbered(place, |x| entry = x));
                costates.replace(&mut at(place, entry + share));
            }
        }
    }
    fn balanced<V: Rate<S::Scalar>>(&self, responses: &[V; K], free: &V) -> [S::Scalar; K] {
        let pairs = responses.each_ref().map(|response| self.rates(response));
        self.balanced_at(&pairs, [One::one(); K], self.rates(free))
    }
    fn minus_weights<V: Rate<S::Scalar>>(&self, responses: &[V; K], costates: &V) -> [S::Scalar; K] {
        let along = responses.each_ref().map(|response| {
            let mut sum = S::Scalar::zero();
            response.all(costates, &mut |x, costate| {
                sum += x * costate;
                true
            });
            sum
        });
        self.solved(responses, along)
    }
    fn rejoin<P: Position<S::Scalar>>(
        &self,
        responses: &[P::Rate; K],
        level: Level,
        motion: (&P, &P::Rate),
        correction: &mut P::Rate,
    ) -> [S::Scalar; K] {
        self.put_back(responses, level, motion, correction)
    }
    fn weigh_missed<P: Position<S::Scalar>>(
        &self,
        level: Level,
        (position, rate, correction): (&P, &P::Rate, &P::Rate),
        minus_weights: &[S::Scalar; K],
        costates: &mut P::Rate,
        [of_ratios, of_offsets]: [&mut [S::Scalar]; 2],
    ) {
        Ties::<S>::add_rows(self, minus_weights, costates);
        let pairs = if let Level::Place = level { self.places(position) } else { self.rates(rate) };
        let corrections = self.rates(correction);
        for (k, weight) in minus_weights.iter().enumerate() {
            of_ratios[k] -= *weight * (pairs[k][1] + corrections[k][1]);
            if let Level::Place = level {
                of_offsets[k] -= *weight;
            }
        }
    }
    fn exert(&self, joint: usize, forces: &[S::Scalar; K], effort: &mut EffortOf<S>) {
        let none = S::Scalar::zero();
        *effort = *effort + S::of_efforts([self.exerted(joint, forces), none, none]);
    }
    fn weigh<V: Rate<S::Scalar>>(
        &self,
        [forces, minus_weights]: [&[S::Scalar; K]; 2],
        [acceleration, stirred]: [&V; 2],
        of_ratios: &mut [S::Scalar],
    ) {
        let [accelerations, stirred] = [acceleration, stirred].map(|motion| self.rates(motion));
        for (k, sum) in of_ratios.iter_mut().enumerate().take(K) {
            let ([_, acceleration], [_, w]) = (accelerations[k], stirred[k]);
            *sum -= minus_weights[k] * acceleration + forces[k] * w;
        }
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        Loading::<S>::check(self, bodies, joints)
    }
    fn suits<P: Position<S::Scalar>>(&self, position: &P, rate: &P::Rate) -> Result<(), (Fault, usize)> {
        suits::<S, P>(self, position, rate)
    }
}

/// What acts on bodies beside couplings: for each space on its own, so that a compiler can tell laws of one body's motion from them.
macro_rules! backward {
    ($Space:ident, $JointMotion:ty) => {
        impl<T: Scalar, L: ActsOnBodies<$Space<T>>, const K: usize> BodyLaw<$Space<T>> for Couplings<T, K, L> {
            type Beside<J: LoadLaw<$JointMotion> + Clone> = <L::Law as BodyLaw<$Space<T>>>::Beside<J>;
            type Whole<J: LoadLaw<$JointMotion, Value = EffortOf<$Space<T>>> + Clone> =
                Couplings<T, K, Self::Beside<J>>;
            type OfNumbers = ([[T; K]; 2], <L::Law as BodyLaw<$Space<T>>>::OfNumbers);
            type Stirred = <L::Law as BodyLaw<$Space<T>>>::Stirred;
            type Ties = Couplings<T, K>;

            fn beside<J: LoadLaw<$JointMotion> + Clone>(self, efforts: J) -> Self::Beside<J> {
                self.others.law().beside(efforts)
            }
            fn whole<J: LoadLaw<$JointMotion, Value = EffortOf<$Space<T>>> + Clone>(
                self,
                efforts: J,
            ) -> Self::Whole<J> {
                self.ties().and(self.beside(efforts))
            }
            fn of_nothing(&self) -> Self::OfNumbers {
                ([[T::zero(); K]; 2], self.others.law().of_nothing())
            }
            fn known(&self, (_, of_law): &Self::OfNumbers) -> Result<(), Fault> {
                self.others.law().known(of_law)
            }
            fn unstirred() -> Self::Stirred {
                L::Law::unstirred()
            }
            fn ties(&self) -> Couplings<T, K> {
                let Self { ties, forces, given, counts, .. } = *self;
                Couplings { ties, forces, given, counts, others: Unloaded }
            }
            fn of_ties(([of_ratios, of_offsets], _): &mut Self::OfNumbers) -> [&mut [T]; 2] {
                [of_ratios, of_offsets]
            }
            fn listed((_, of_law): &Self::OfNumbers) -> &OfLaw<T> {
                L::Law::listed(of_law)
            }
            fn each_number(([of_ratios, of_offsets], of_law): &mut Self::OfNumbers, meet: &mut impl FnMut(&mut T)) {
                of_ratios.iter_mut().zip(of_offsets).flat_map(|(ratio, offset)| [ratio, offset]).for_each(&mut *meet);
                L::Law::each_number(of_law, meet);
            }
        }

        impl<T: Scalar, L, const K: usize> ReversibleLoads<$Space<T>> for Couplings<T, K, L>
        where
            L: ActsOnBodies<$Space<T>, Law: ReversibleLoads<$Space<T>>>,
        {
            fn felt(
                walk: &mut PullLoads<Self, $Space<T>>,
                numbers: <$Space<T> as LoadCostates>::OfNumbers,
                frame: &FrameOf<$Space<T>>,
                stirred: (<$Space<T> as Geometry>::Vector, <$Space<T> as Geometry>::Angular),
                sums: &mut <$Space<T> as LoadCostates>::OfNumbers,
            ) -> <$Space<T> as LoadCostates>::Felt {
                let (law, seen, of_law) = (walk.law.others.law(), walk.seen.clone(), walk.of_law.1.clone());
                let PullLoads { surveys, time, body, level, .. } = *walk;
                let mut within = PullLoads { law, seen, surveys, time, body, level, of_law };
                let felt = L::Law::felt(&mut within, numbers, frame, stirred, sums);
                (walk.seen, walk.of_law.1) = (within.seen, within.of_law);
                felt
            }
        }
    };
}
backward!(Planar, planar::JointMotion<T>);
backward!(Spatial, spatial::JointMotion<T>);
