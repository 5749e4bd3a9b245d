//! Where accelerations lead from where a stage of an implicit rule is free, and the way back.

use super::GradientOf;
use super::again::follow;
use super::record::{Place, StageOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf};
use crate::ends::Root;
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::Real;
use crate::system::{Elements, MotionOf, PositionOf, RateOf};

impl<S, R, C, P, M, L> Steps<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
{
    /// The accelerations that a sweep has found, where those of the step's coordinates may be others.
    pub(super) fn found<'a>(stage: &'a StageOf<S, R, C, P, L>, slope: &'a RateOf<S, R, C>) -> &'a RateOf<S, R, C> {
        if Self::CHARTED { &stage.acceleration } else { slope }
    }

    /// Where an acceleration leads from where a stage is free, once that has been found.
    pub(super) fn lead(
        &self,
        (past, step): (&MotionOf<S, R, C, P>, RealOf<S>),
        row: usize,
        free: &Place<S, R, C>,
        by: &RateOf<S, R, C>,
        (position, rate): (&mut PositionOf<S, R, C>, &mut RateOf<S, R, C>),
    ) {
        let [own, _] = self.rule.own::<S::Scalar>(step);
        if !Self::CHARTED {
            follow::<S, Elements<S, R, C>>((&free.0, &free.1), own, by, &self.zero, (position, rate));
            return;
        }
        // Coordinates of the step add up, positions do not.
        let real = RealOf::<S>::of;
        position.drift_2(
            &past.position,
            (real(M::node(row)) * step, &past.rate),
            (step * step, &self.sum),
            (own[0], by),
        );
        rate.mix_1(&free.1, (own[1], by));
        position.retract_rate(&past.position, rate);
    }

    /// From the costates of where a row was led to those of its coordinates of the step.
    pub(super) fn unlead(
        &mut self,
        (past, row): (&MotionOf<S, R, C, P>, usize),
        (position, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let of_here = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
        let (here, of_past) = ((rate, &self.zero), &mut gradient.start.position);
        position.transposed_step(&past.position, here, &self.zero, of_here, of_past);
    }
}
