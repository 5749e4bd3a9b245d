//! What is kept of a step for costates.

use super::projection::Projection;
use super::rules::Staged;
use crate::adjoint::{BodyLaw, Reversed, Ties};
use crate::element::Element;
use crate::ends::Tip;
use crate::mirror::Rate;
use crate::motion::Motion;
use crate::relation::{Acceleration, AccelerationOf, Additive, Closures};
use crate::shape::{Kept, PerAxes, PerBody, PerClosure, PerJoint, Positions};
use crate::system::{Elements, PositionOf, RateOf};
use crate::walks::measure::gains;
use num_traits::Zero;

/// A step of a scene.
pub(super) type RecordOf<S, R, C, P, M, L> =
    Record<S, Elements<S, R, C>, M, <P as Tip<S>>::Closures, <L as BodyLaw<S>>::Ties>;
/// A stage of a scene.
pub(super) type StageOf<S, R, C, P, L> = Stage<S, Elements<S, R, C>, <P as Tip<S>>::Closures, <L as BodyLaw<S>>::Ties>;
/// Positions and rates.
pub(super) type Place<S, R, C> = (PositionOf<S, R, C>, RateOf<S, R, C>);

/// What a stage of a step keeps for its costates.
#[derive(Clone)]
pub(super) struct Stage<S: Reversed, E: Element<S>, X: Closures, Y: Ties<S>> {
    pub(super) x: E::Store<PerAxes<S::X>>,
    pub(super) y: E::Store<PerAxes<S::Y>>,
    pub(super) p: E::Store<PerAxes<S::P>>,
    pub(super) q: E::Store<PerAxes<S::Q>>,
    pub(super) kept: E::Store<Kept<X>>,
    pub(super) pivots: E::Store<PerJoint<S::Pivot>>,
    /// Accelerations of the outboard ends of bodies and joints.
    pub(super) at_bodies: E::Store<PerBody<S::Vector>>,
    pub(super) at_joints: E::Store<PerJoint<S::Vector>>,
    pub(super) position: E::Position,
    pub(super) rate: E::Rate,
    /// Accelerations, where those of the step's coordinates are others.
    pub(super) acceleration: E::Rate,
    /// λ of loops.
    pub(super) in_loops: E::Store<PerClosure>,
    /// Λ and λ of what holds the tip.
    pub(super) compliance: X::Pairs<S::Scalar>,
    pub(super) force: X::Each<S::Scalar>,
    /// Acceleration of the tip.
    pub(super) reached: AccelerationOf<S>,
    /// What a unit of the force of each coupling causes, and these forces.
    pub(super) responses: Y::Each<E::Rate>,
    pub(super) tensions: Y::Each<S::Scalar>,
}

impl<S: Reversed, E: Element<S>, X: Closures, Y: Ties<S>> Stage<S, E, X, Y> {
    /// Room for a stage.
    pub(super) fn new(elements: &E, zero: &E::Rate) -> Self {
        let (x, y, p, q) = S::blank();
        Self {
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
            kept: gains(elements),
            pivots: elements.store::<PerJoint<_>>(S::no_pivot()),
            at_bodies: elements.store::<PerBody<_>>(S::Vector::null()),
            at_joints: elements.store::<PerJoint<_>>(S::Vector::null()),
            position: elements.store::<Positions>(()),
            rate: zero.clone(),
            acceleration: zero.clone(),
            in_loops: elements.store::<PerClosure>(()),
            compliance: X::no_pairs(),
            force: X::each(|_| S::Scalar::zero()),
            reached: Acceleration::zero(),
            responses: Y::each(zero),
            tensions: Y::each(&S::Scalar::zero()),
        }
    }
}

/// A step with what its stages keep.
pub(super) struct Record<S: Reversed, E: Element<S>, M: Staged, X: Closures, Y: Ties<S>> {
    pub(super) stages: M::Stages<Stage<S, E, X, Y>>,
    pub(super) accelerations: M::Rows<E::Rate>,
    /// What puts the tip back where it is held and closes loops, if there is something.
    pub(super) projection: Option<Projection<S, E>>,
}

impl<S: Reversed, E: Element<S>, M: Staged, X: Closures, Y: Ties<S>> Clone for Record<S, E, M, X, Y> {
    fn clone(&self) -> Self {
        let (mut stages, mut accelerations) =
            (M::stages(&self.stages.as_ref()[0]), M::rows(&self.accelerations.as_ref()[0]));
        stages.as_mut().clone_from_slice(self.stages.as_ref());
        accelerations.as_mut().clone_from_slice(self.accelerations.as_ref());
        Self { stages, accelerations, projection: self.projection.clone() }
    }
}

impl<S: Reversed, E: Element<S>, M: Staged, X: Closures, Y: Ties<S>> Record<S, E, M, X, Y> {
    /// Gives the motion before the step the accelerations in which it begins, where the first stage stands there; else zeros. What a rule
    /// remembers stays.
    pub(super) fn begin(&self, before: &mut Motion<S::Scalar, E::Position, X>) {
        if const { M::REMEMBERS } {
            return;
        }
        before.acceleration.set(&self.accelerations.as_ref()[0]);
        if const { M::IMPLICIT } {
            before.acceleration.replace(&mut |_| S::Scalar::zero());
        }
    }
}
