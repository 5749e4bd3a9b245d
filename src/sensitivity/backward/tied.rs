//! Couplings of joints in a stage: their forces, and what their rows do to costates ([`Ties`] has the equations).

use super::record::StageOf;
use super::rules::Staged;
use super::steps::{Steps, TorquesOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip, Ties};
use crate::element::{Element, RealOf};
use crate::ends::Root;
use crate::loading::EffortOf;
use crate::mirror::Rate;
use crate::shape::PerJoint;
use crate::space::FrameOf;
use crate::system::{Elements, MotionOf, RateOf};
use crate::walks::{copy::copy, unspread};
use num_traits::{One, Zero};

/// Room for couplings: efforts, theirs among them, and what one of them causes.
pub(super) type Tying<S, R, C> = (TorquesOf<S, R, C>, RateOf<S, R, C>);

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
    /// Whether joints are coupled.
    pub(super) const TIED: bool = <L::Ties as Ties<S>>::COUNT > 0;

    /// Finds what the force of each coupling causes, and these forces, after a sweep without them; puts them beside the torques of the step.
    pub(super) fn tie(
        &mut self,
        start: Option<&MotionOf<S, R, C, P>>,
        time: RealOf<S>,
        stage: &mut StageOf<S, R, C, P, L>,
        free: &RateOf<S, R, C>,
    ) {
        let Some((mut efforts, mut response)) = self.tying.take() else { return };
        let (ties, frame) = (self.loads.law.ties(), self.scene.ground(time));
        self.aside((&mut efforts, &mut response), |steps| {
            for k in 0..<L::Ties as Ties<S>>::COUNT {
                let mut unit = <L::Ties as Ties<S>>::each(&S::Scalar::zero());
                unit.as_mut()[k] = S::Scalar::one();
                steps.of_acceleration.set(&steps.zero);
                ties.add_rows(&unit, &mut steps.of_acceleration);
                steps.stir(start, &frame, (stage, free));
                stage.responses.as_mut()[k].set(&steps.of_acceleration);
            }
        });
        stage.tensions = ties.balanced(&stage.responses, free);
        let (elements, mut joint) = (self.scene.elements(), 0);
        copy::<S, _, PerJoint<EffortOf<S>>>(elements, &self.torques, &mut efforts);
        unspread::each_joint(elements, &mut efforts, &mut |effort| {
            ties.exert(joint, &stage.tensions, effort);
            joint += 1;
        });
        self.tying = Some((efforts, response));
    }

    /// Takes Cᵀν from the costates of the accelerations of a stage, which then move no coupling; gives −ν.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn untie(
        &mut self,
        start: Option<&MotionOf<S, R, C, P>>,
        frame: &FrameOf<S>,
        known: (&StageOf<S, R, C, P, L>, &RateOf<S, R, C>),
    ) -> Option<<L::Ties as Ties<S>>::Each<S::Scalar>> {
        let (mut efforts, mut response) = self.tying.take()?;
        response.set(&self.of_acceleration);
        self.aside((&mut efforts, &mut response), |steps| {
            steps.stir(start, frame, known);
        });
        let ties = self.loads.law.ties();
        let minus_weights = ties.balanced(&known.0.responses, &response);
        ties.add_rows(&minus_weights, &mut self.of_acceleration);
        self.tying = Some((efforts, response));
        Some(minus_weights)
    }

    /// Solves for other costates than those that wait, of torques and of accelerations.
    fn aside(
        &mut self,
        (efforts, costates): (&mut TorquesOf<S, R, C>, &mut RateOf<S, R, C>),
        solve: impl FnOnce(&mut Self),
    ) {
        core::mem::swap(&mut self.of_torques, efforts);
        core::mem::swap(&mut self.of_acceleration, costates);
        solve(self);
        core::mem::swap(&mut self.of_torques, efforts);
        core::mem::swap(&mut self.of_acceleration, costates);
    }
}
