//! Costates of positions, rates and parameters, from what loads on bodies read.

use crate::adjoint::Reversed;
use crate::relation::{Additive, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{Mut, PerAxes, PerBody, PerJoint, Positions, Rates, Ref, Selective, Walk};
use crate::space::FrameOf;

/// Carries costates of places and velocities inward, and adds to those of positions, rates and parameters.
pub struct PullLoads<L, T: Scalar> {
    /// What acts on bodies.
    pub law: L,
    /// Time (s).
    pub time: T::Real,
    /// The number of the body that was met last.
    pub body: usize,
    /// Costates of the numbers of the law, and how many it has.
    pub of_law: ([T; LAW], usize),
}

/// Most numbers that a law of loads is made of.
pub const LAW: usize = 6;

impl<S: Reversed, L> Walk<S> for PullLoads<L, S::Scalar> {
    type Carried = S::Felt;
    /// Posture; positions, rates and w; frames of bodies and what [`Stir`](super::stir::Stir) has kept; costates of parameters, positions
    /// and rates.
    type Stores = (
        Ref<PerAxes<S::X>>,
        Ref<PerAxes<S::Y>>,
        Ref<PerAxes<S::P>>,
        Ref<PerAxes<S::Q>>,
        (Ref<Positions>, Ref<Rates>, Ref<Rates>),
        (Ref<PerBody<(FrameOf<S>, WrenchOf<S>)>>, Ref<PerBody<S::OnBody>>, Ref<PerJoint<S::InJoint>>),
        (Mut<PerBody<S::OfNumbers>>, Mut<PerJoint<S::OfJoint>>),
        (Mut<Rates>, Mut<Rates>),
    );
}

impl<S: Reversed, L> Selective<S> for PullLoads<L, S::Scalar> {
    const OUTWARD: bool = false;

    #[inline(always)]
    fn branch(&mut self, chain: S::Felt, go: impl FnOnce(&mut Self, S::Felt) -> S::Felt) -> S::Felt {
        chain + go(self, S::Felt::null())
    }
}
