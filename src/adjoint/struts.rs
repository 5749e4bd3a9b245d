//! The costate sweep under struts.
//!
//! Over virtual velocities u₀ and u₁ of its ends a strut along a = p₁ − p₀ = ℓ n, whose force f pulls them together, does
//!
//! ```text
//! π = f s        f = k (ℓ − ℓ₀) + c ℓ̇        ℓ̇ = n·ȧ        s = n·(u₀ − u₁)
//! ∂π/∂a = s (k n + c (ȧ − ℓ̇ n)/ℓ) + f (u₀ − u₁ − s n)/ℓ        ∂π/∂ȧ = c s n
//! ∂π/∂k = s (ℓ − ℓ₀)        ∂π/∂c = s ℓ̇        ∂π/∂ℓ₀ = −k s
//! ```
//!
//! A law of its own takes its force F(ℓ, ℓ̇) from f, and −∂F/∂ℓ and −∂F/∂ℓ̇ stand beside k and c.
//!
//! What its ends read is carried inward as from a station of its own on each body. Virtual velocities of both ends have to be known first: one
//! more walk over bodies.

use super::Reversed;
use super::body_law::OfLaw;
use super::by_strut::ByStrut;
use super::laws::{NUMBERS, ReversibleLaw};
use crate::relation::Additive;
use crate::scalar::Scalar;
use crate::space::FrameOf;
use crate::struts::{End, Points, Sight, Strut, dot, is_absent, norm};
use nalgebra::SVector;
use num_traits::Zero;

/// A space in which costates of points of bodies are known.
pub trait ReversiblePoints<const D: usize>: Points<D> + Reversed {
    /// The virtual velocity of a point (m, body axes) of a body, for that of its inboard end and its w.
    fn stirred_at(
        frame: &FrameOf<Self>,
        at: [Self::Scalar; D],
        stirred: (Self::Vector, Self::Angular),
    ) -> SVector<Self::Scalar, D>;
    /// What is carried to the inboard end from such a point, where place, velocity and virtual velocity have costates, and the costate of its
    /// coordinates in body axes.
    fn felt_at(
        frame: &FrameOf<Self>,
        at: [Self::Scalar; D],
        stirring: Self::Angular,
        costates: [SVector<Self::Scalar, D>; 3],
    ) -> (Self::Felt, SVector<Self::Scalar, D>);
}

/// Costates of the numbers of struts, and of a law beside them.
pub type OfStruts<T, const D: usize, const N: usize> = ([ByStrut<T, D>; N], OfLaw<T>);

/// Virtual velocities of the ends of struts.
pub type EndsStirred<T, const D: usize, const N: usize> = [[SVector<T, D>; 2]; N];

/// What a strut does over virtual velocities, and its slopes by place and velocity of the second end: those by the first are the opposite.
struct Power<T, const D: usize> {
    by_place: SVector<T, D>,
    by_velocity: SVector<T, D>,
    /// By stiffness, damping and length.
    by_numbers: [T; 3],
    by_law: [T; NUMBERS],
    /// Whether the strut acts, and whether it is too short or too long for that.
    acts: bool,
    slack: bool,
}

impl<T: Scalar, const D: usize> Power<T, D> {
    fn of<W: ReversibleLaw<T>>(
        strut: &Strut<T, D, W>,
        [from, to]: [[SVector<T, D>; 2]; 2],
        [u, w]: [SVector<T, D>; 2],
    ) -> Self {
        let &Strut { stiffness: k, damping: c, length, .. } = strut;
        let (apart, parting, stirred) = (to[0] - from[0], to[1] - from[1], u - w);
        let distance = norm(apart);
        // Ends that meet have no direction: they may where nothing asks for one, and then it changes nothing.
        let inverse = if distance.real().is_zero() { T::zero() } else { distance.recip() };
        let n = apart * inverse;
        let (stretch, speed, s) = (distance - length, dot(n, parting), dot(n, stirred));
        let mut by_law = [T::zero(); NUMBERS];
        if strut.has_no_direction() && is_absent(length) {
            let (by_place, by_velocity) = (stirred * k, SVector::repeat(T::zero()));
            let by_numbers = [dot(apart, stirred), s * speed, -(k * s)];
            return Self { by_place, by_velocity, by_numbers, by_law, acts: true, slack: false };
        }
        let force = strut.tension(distance, speed);
        // Where it hangs slack nothing changes what it does.
        let (s, stirred) = (strut.acting(stretch, force, s), stirred.map(|x| strut.acting(stretch, force, x)));
        let [mut of_distance, mut of_speed] = [k * s, c * s];
        if W::ON {
            let [by_distance, by_speed] = strut.law.pull_back(distance, speed, -s, &mut by_law);
            [of_distance, of_speed] = [of_distance + by_distance, of_speed + by_speed];
        }
        let along = of_distance - (of_speed * speed + force * s) * inverse;
        Self {
            by_place: n * along + (parting * of_speed + stirred * force) * inverse,
            by_velocity: n * of_speed,
            by_numbers: [s * stretch, s * speed, -(k * s)],
            by_law,
            acts: !strut.acting(stretch, force, T::one()).is_zero(),
            slack: strut.acting(stretch, stretch, T::one()).is_zero(),
        }
    }
}

/// Sees virtual velocities of ends on the body met last.
pub fn stir<S: ReversiblePoints<D>, W, const D: usize, const N: usize>(
    struts: &[Strut<S::Scalar, D, W>; N],
    sight: &Sight<S::Scalar, D, N>,
    ends: &mut EndsStirred<S::Scalar, D, N>,
    body: usize,
    frame: &FrameOf<S>,
    stirred: (S::Vector, S::Angular),
) {
    for strut in sight.on(body) {
        for (end, velocity) in struts[strut].ends.iter().zip(&mut ends[strut]) {
            if let End::Body(k, at) = *end
                && k == body
            {
                *velocity = S::stirred_at(frame, at, stirred);
            }
        }
    }
}

/// Costates of the inboard end of the body met last, by what the ends on it read; adds to those of the numbers of struts, of which the first
/// end, which is on a body, gives those that both have in common.
pub fn felt<S: ReversiblePoints<D>, W: ReversibleLaw<S::Scalar>, const D: usize, const N: usize>(
    struts: &[Strut<S::Scalar, D, W>; N],
    (sight, stirred): (&Sight<S::Scalar, D, N>, &EndsStirred<S::Scalar, D, N>),
    body: usize,
    (frame, stirring): (&FrameOf<S>, S::Angular),
    of_struts: &mut [ByStrut<S::Scalar, D>; N],
) -> S::Felt {
    let mut felt = S::Felt::null();
    for k in sight.on(body) {
        let (strut, seen, stirred, by) = (&struts[k], &sight.ends[k], &stirred[k], &mut of_struts[k]);
        for (e, end) in strut.ends.iter().enumerate() {
            let End::Body(k, at) = *end else { continue };
            if k != body {
                continue;
            }
            let power = Power::of(strut, *seen, *stirred);
            let second = [power.by_place, power.by_velocity, -strut.force(*seen)];
            let costates = if e == 0 { second.map(|x| -x) } else { second };
            let (more, of_point) = S::felt_at(frame, at, stirring, costates);
            (felt, by.ends[e]) = (felt + more, by.ends[e] + of_point);
            if e == 0 {
                by.add(power.by_numbers, power.by_law, [power.acts, power.slack]);
                if let End::Ground(_) = strut.ends[1] {
                    by.ends[1] += power.by_place;
                }
            }
        }
    }
    felt
}

/// Struts of a space, as what acts on bodies in runs that go backward: for each space on its own, so that a compiler can tell laws of one
/// body's motion from them.
macro_rules! struts {
    ($Space:ident, $D:literal) => {
        impl<T: Scalar, L, W, const N: usize> BodyLaw<$Space<T>> for Struts<T, $D, N, L, W>
        where
            L: ActsOnBodies<$Space<T>>,
            L::Law: LoadLaw<BodyMotion<T>, Value: Load<$Space<T>>> + BodyLaw<$Space<T>, OfNumbers = OfLaw<T>>,
            W: SpringLaw<T> + Lift<T, T>,
        {
            type Beside<J: LoadLaw<JointMotion<T>> + Clone> = Struts<T, $D, N, Loads<L::Law, J>, W>;
            type Whole<J: LoadLaw<JointMotion<T>, Value = $crate::loading::EffortOf<$Space<T>>> + Clone> =
                Self::Beside<J>;
            type OfNumbers = OfStruts<T, $D, N>;
            type Stirred = EndsStirred<T, $D, N>;
            type Ties = ();

            fn beside<J: LoadLaw<JointMotion<T>> + Clone>(self, efforts: J) -> Self::Beside<J> {
                let others = Loads::none().on_bodies_by(self.others().law()).in_joints_by(efforts);
                Struts::of(*self.struts()).and(others)
            }
            fn whole<J: LoadLaw<JointMotion<T>, Value = $crate::loading::EffortOf<$Space<T>>> + Clone>(
                self,
                efforts: J,
            ) -> Self::Beside<J> {
                self.beside(efforts)
            }
            fn of_nothing(&self) -> Self::OfNumbers {
                (self.struts().each_ref().map(ByStrut::none), self.others().law().of_nothing())
            }
            fn known(&self, (of_struts, _): &Self::OfNumbers) -> Result<(), Fault> {
                self.struts().iter().zip(of_struts).try_for_each(|(strut, by)| by.known(strut))
            }
            fn unstirred() -> Self::Stirred {
                [[SVector::repeat(T::zero()); 2]; N]
            }
            fn ties(&self) {}
            fn of_ties(_: &mut Self::OfNumbers) -> [&mut [T]; 2] {
                [&mut [], &mut []]
            }
            fn listed((_, of_law): &Self::OfNumbers) -> &OfLaw<T> {
                of_law
            }
            fn each_number((of_struts, of_law): &mut Self::OfNumbers, meet: &mut impl FnMut(&mut T)) {
                of_struts.iter_mut().flat_map(ByStrut::each_number).for_each(&mut *meet);
                <L::Law as BodyLaw<$Space<T>>>::each_number(of_law, meet);
            }
        }

        impl<T: Scalar, L, W, const N: usize> ActsOnBodies<$Space<T>> for Struts<T, $D, N, L, W>
        where
            L: Loading<$Space<T>> + Copy,
            W: SpringLaw<T>,
            Self: BodyLaw<$Space<T>, Ties = ()> + Loading<$Space<T>>,
        {
            type Law = Self;
            fn law(&self) -> Self {
                *self
            }
        }

        impl<T: Scalar, L, W, const N: usize> ReversibleLoads<$Space<T>> for Struts<T, $D, N, L, W>
        where
            W: ReversibleLaw<T> + Lift<T, T>,
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
                let PullLoads { law, seen: ((seen, ()), ends), surveys, time, body, level, of_law } = walk;
                let ((of_struts, of_law), struts) = (of_law, law.struts());
                if *surveys {
                    stir::<$Space<T>, W, $D, N>(struts, seen, ends, *body, frame, stirred);
                    return Felt::null();
                }
                let felt = felt::<$Space<T>, W, $D, N>(struts, (seen, ends), *body, (frame, stirred.1), of_struts);
                if const { !<L::Law as BodyLaw<$Space<T>>>::ON } {
                    return felt;
                }
                let at = (*time, *body, *level);
                felt + felt_beside(law.others().law(), at, of_law, numbers, frame, stirred, sums)
            }
        }
    };
}
pub(crate) use struts;
