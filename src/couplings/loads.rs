//! Couplings as loads: forces that follow from the accelerations of a sweep without them, and of one by each.

use super::{Couplings, Tie, unit};
use crate::element::{Level, Loading, RealOf, Springs};
use crate::error::Fault;
use crate::loading::{EffortOf, LARGER, Yields, couples};
use crate::mirror::{Position, Rate};
use crate::relation::Additive;
use crate::scalar::{Real, Scalar};
use crate::transfer::{Efforts, FromEfforts};
use num_traits::{One, Zero};

/// What sweeps answer without couplings, and to the force of each.
struct Answers<T: Scalar, V, const K: usize> {
    /// Accelerations without, and by how much they miss what couplings ask of them.
    free: V,
    missed: [T; K],
    /// Forces (N·m, N), and what each adds, to all and to followers and leaders.
    sizes: [T::Real; K],
    responses: [V; K],
    pairs: [[[T; 2]; K]; K],
}

/// Adds a share of each response.
fn along<T: Scalar, V: Rate<T>, const K: usize>(sum: &mut V, responses: &[V; K], shares: [T; K]) {
    for (response, share) in responses.iter().zip(shares) {
        let mut response = response.clone();
        response.replace(&mut |x| x * share);
        sum.add(&response);
    }
}

impl<T: Scalar, const K: usize, L: Clone> Couplings<T, K, L> {
    /// What sweeps answer.
    fn answers<V: Rate<T>>(
        &self,
        acceleration: &mut V,
        sweep: &mut impl FnMut(&Self, bool, &mut V),
    ) -> Answers<T, V, K> {
        let (one, larger) = (T::Real::one(), T::Real::of(LARGER));
        sweep(&self.pulling([T::zero(); K]), false, acceleration);
        let (free, missed) = (acceleration.clone(), self.missed(acceleration));
        let sizes: [_; K] = core::array::from_fn(|k| self.ties[k].inertia * (one + missed[k].real().abs()) * larger);
        let responses: [V; K] = core::array::from_fn(|k| {
            sweep(&self.pulling(unit(k, T::constant(sizes[k]))), true, acceleration);
            let mut response = free.clone();
            response.mix_1(acceleration, (-one, &free));
            response
        });
        let pairs = responses.each_ref().map(|response| self.rates(response));
        Answers { free, missed, sizes, responses, pairs }
    }

    /// The forces that undo what is missed, by responses to a unit of each.
    pub(super) fn solved<V: Rate<T>>(&self, responses: &[V; K], missed: [T; K]) -> [T; K] {
        self.balanced_by(&responses.each_ref().map(|response| self.rates(response)), [T::Real::one(); K], missed)
    }

    /// Adds to a correction of positions, or of rates, what moves followers to where their leaders have them; gives the forces.
    pub(super) fn put_back<P: Position<T>>(
        &self,
        responses: &[P::Rate; K],
        level: Level,
        (position, rate): (&P, &P::Rate),
        correction: &mut P::Rate,
    ) -> [T; K] {
        let missed = if let Level::Place = level { self.apart(position) } else { self.missed(rate) };
        let moved = self.missed(correction);
        let forces = self.solved(responses, core::array::from_fn(|k| missed[k] + moved[k]));
        along(correction, responses, forces);
        forces
    }

    /// What forces λ exert in a joint.
    pub(super) fn exerted(&self, joint: usize, forces: &[T; K]) -> T {
        let mut effort = T::zero();
        for (Tie { joints: [follower, leader], ratio, .. }, force) in self.ties.iter().zip(forces) {
            if *follower == joint {
                effort += *force;
            } else if *leader == joint {
                effort -= *ratio * *force;
            }
        }
        effort
    }

    /// These loads with forces λ that are given.
    pub(super) fn pulling(&self, forces: [T; K]) -> Self {
        Self { forces, given: true, ..self.clone() }
    }
}

impl<S, L, const K: usize> Loading<S> for Couplings<S::Scalar, K, L>
where
    S: FromEfforts,
    L: Loading<S, InJoint: Efforts<S>> + Clone,
{
    type OnBody = L::OnBody;
    type InJoint = EffortOf<S>;
    type Seen = L::Seen;
    type Responses<V: Clone> = Option<[V; K]>;
    const ON: bool = true;
    const SURVEYS: bool = L::SURVEYS;
    const YIELDS: Yields = L::YIELDS;

    fn nothing() -> (L::OnBody, EffortOf<S>) {
        const { assert!(!couples::<S, L>(), "couplings stand in one list") }
        const { assert!(!L::BY_COORDINATE, "beside couplings joints are numbered from the root's on: take `Loads::efforts`") }
        (L::nothing().0, Additive::null())
    }
    fn unseen(&self) -> L::Seen {
        self.others.unseen()
    }
    fn survey(&self, seen: &mut L::Seen, body: usize, motion: &S::BodyMotion) {
        self.others.survey(seen, body, motion);
    }
    fn on_body(&self, seen: &L::Seen, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> L::OnBody {
        self.others.on_body(seen, time, body, motion)
    }
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> EffortOf<S> {
        S::of_efforts([self.exerted(joint, &self.forces), S::Scalar::zero(), S::Scalar::zero()])
            + S::of_efforts(self.others.in_joint(time, joint, motion).efforts())
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        if self.counts != [bodies, joints] {
            return Err(Fault::Shape); // of another scene with vectors
        }
        self.others.check(bodies, joints)
    }
    fn each_miss<P: Position<S::Scalar>>(
        &self,
        position: &P,
        rate: &P::Rate,
        tell: &mut impl FnMut(Level, usize, [S::Scalar; 2]),
    ) {
        let [places, rates] = [self.places(position), self.rates(rate)];
        let [apart, parting] = [self.apart(position), self.missed(rate)];
        for (k, Tie { joints: [follower, _], .. }) in self.ties.iter().enumerate() {
            tell(Level::Place, *follower, [apart[k], places[k][0]]);
            tell(Level::Velocity, *follower, [parting[k], rates[k][0]]);
        }
    }
    fn accelerated<V: Rate<S::Scalar>>(
        &self,
        read: bool,
        kept: Option<&mut Option<[V; K]>>,
        acceleration: &mut V,
        mut sweep: impl FnMut(&Self, bool, &mut V),
    ) {
        if self.given {
            return sweep(self, false, acceleration);
        }
        let Answers { free, missed, sizes, responses, pairs } = self.answers(acceleration, &mut sweep);
        let shares = self.balanced_at(&pairs, sizes, self.rates(&free));
        if let Some(kept) = kept {
            let kept = kept.insert(responses.clone());
            for (response, size) in kept.iter_mut().zip(sizes) {
                response.replace(&mut |x| x.scale(size.recip()));
            }
        }
        if read {
            // What is told of modes is not linear in forces, and closure forces are those of the last sweep.
            let forces = core::array::from_fn(|k| shares[k].scale(sizes[k]));
            sweep(&self.pulling(forces), true, acceleration);
            return self.still(acceleration, missed);
        }
        acceleration.set(&free);
        along(acceleration, &responses, shares);
    }
    fn yielded<V: Rate<S::Scalar>>(
        &self,
        led: (&L::Seen, &V),
        springs: impl Springs<S::Scalar>,
        see: impl Fn(&V) -> L::Seen,
        acceleration: &mut V,
        mut sweep: impl FnMut(&Self, bool, &mut V),
    ) {
        let beside = |others: &L, again: bool, acceleration: &mut V| {
            sweep(&Self { others: others.clone(), ..*self }, again, acceleration);
        };
        self.others.yielded(led, springs, see, acceleration, beside);
    }
    fn rejoin<P: Position<S::Scalar>>(
        &self,
        responses: &Option<[P::Rate; K]>,
        level: Level,
        motion: (&P, &P::Rate),
        correction: &mut P::Rate,
    ) {
        if let Some(responses) = responses {
            self.put_back(responses, level, motion, correction);
        }
    }
}
