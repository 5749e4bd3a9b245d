//! Costates of positions, rates and parameters, from what loads on bodies read.

use super::missed::Turns;
use crate::adjoint::{BodyLaw, Reversed, ReversibleClosing, Surveyed};
use crate::element::Level;
use crate::relation::{Additive, Closures, WrenchOf};
use crate::shape::{
    Around, AtClosing, Ends, Mut, PerAxes, PerBody, PerClosure, PerJoint, Positions, Rates, Ref, Selective, Walk, Way,
};
use crate::space::{FrameOf, RealOf};

/// Carries costates of places and velocities inward, and adds to those of positions, rates and parameters.
pub struct PullLoads<L: BodyLaw<S>, S: Reversed> {
    /// What acts on bodies.
    pub law: L,
    /// What the law has seen of all bodies, and of their virtual velocities.
    pub seen: (Surveyed<S, L>, L::Stirred),
    /// Whether the law only sees virtual velocities here, before costates are found.
    pub surveys: bool,
    /// Time (s).
    pub time: RealOf<S>,
    /// The number of the body that was met last.
    pub body: usize,
    /// Of what the ends of loops miss costates are given.
    pub level: Level,
    /// Costates of the numbers of the law.
    pub of_law: L::OfNumbers,
}

/// Most numbers that a law of loads on one body is made of.
pub const LAW: usize = 6;

impl<S: Reversed, L: BodyLaw<S>> Walk<S> for PullLoads<L, S> {
    type Carried = S::Felt;
    /// Posture; positions, rates and w; frames of bodies, what [`Stir`](super::stir::Stir) has kept, costates −ν of what the ends of loops
    /// miss, and how these are turned; costates of parameters, positions and rates.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>, Ref<Rates>),
        (
            Ref<PerBody<(FrameOf<S>, WrenchOf<S>)>>,
            Ref<PerBody<S::OnBody>>,
            Ref<PerJoint<S::InJoint>>,
            (Ref<PerClosure>, Ref<Turns<S>>),
        ),
        (Mut<PerBody<S::OfNumbers>>, Mut<PerJoint<S::OfJoint>>),
        (Mut<Rates>, Mut<Rates>),
    );
}

impl<S: Reversed, L: BodyLaw<S>> Selective<S> for PullLoads<L, S> {
    const OUTWARD: bool = false;
    type In<Y: Way> = Self;

    #[inline(always)]
    fn branch(&mut self, chain: S::Felt, go: impl FnOnce(&mut Self, S::Felt) -> S::Felt) -> S::Felt {
        chain + go(self, S::Felt::null())
    }
}

impl<S: Reversed, L: BodyLaw<S>, K: ReversibleClosing<S>> Around<S, K> for PullLoads<L, S> {
    fn around(
        &mut self,
        closing: &K,
        outer: S::Felt,
        (x, y, p, q, _, (.., (minus_weights, turns)), (_, sums), _): AtClosing<'_, S, Self, K>,
        main: impl FnOnce(&mut Self, S::Felt) -> S::Felt,
        side: impl FnOnce(&mut Self, S::Felt) -> S::Felt,
    ) -> S::Felt {
        let (weights, axes) = (K::Closures::map(minus_weights, |x| -x), Ends { x, y, p, q });
        let [on_side, on_main] = closing.felt(axes, &weights, turns, self.level, sums);
        let side = side(self, on_side);
        main(self, outer + on_main) + side
    }
}
