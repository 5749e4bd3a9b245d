//! Couplings of joints in a stage: their forces, and what their rows do to costates ([`Ties`] has the equations).

use super::GradientOf;
use super::held::opposite;
use super::record::{Place, StageOf};
use super::rules::Staged;
use super::steps::{Steps, TorquesOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip, Ties};
use crate::element::{Element, Level, RealOf};
use crate::ends::Root;
use crate::loading::EffortOf;
use crate::mirror::Rate;
use crate::sensitivity::Gradient;
use crate::shape::PerJoint;
use crate::space::FrameOf;
use crate::system::{Elements, MotionOf, PositionOf, RateOf};
use crate::walks::{copy::copy, swept::swept, unspread};
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

    /// From the costates of a correction that puts followers back, which are in the room, to those of the correction that closes, which they become,
    /// and those of what else it depends on.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn pull_back_ties(
        &mut self,
        level: Level,
        (place, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        clock: (RealOf<S>, RealOf<S>),
        (stage, position, free): (&StageOf<S, R, C, P, L>, &PositionOf<S, R, C>, Option<&Place<S, R, C>>),
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let Some(room) = &mut self.room else { return };
        let (ties, time) = (self.loads.law.ties(), clock.0);
        let (elements, resting) = (self.scene.elements(), self.scene.ground(time).at_rest());
        // λ and μ, and what is missed.
        let (at, motion) = ((level, time), (place, rate));
        let forces = Self::correct(self.scene, &ties, at, stage, motion, &self.zero, &mut room.correction);
        let minus_weights = ties.minus_weights(&stage.responses, &room.costates);
        ties.add_rows(&minus_weights, &mut room.costates);
        let Gradient { start, law, .. } = gradient;
        let costates = if let Level::Place = level { &mut start.position } else { &mut start.rate };
        ties.weigh_missed(level, (place, rate, &room.correction), &minus_weights, costates, L::of_ties(law));
        // The correction r λ, and how it moves all stations.
        core::mem::swap(&mut room.costates, &mut room.correction);
        room.costates.set(&self.zero);
        ties.add_rows(&forces, &mut room.costates);
        let force = room.meet::<P, _>(elements, stage);
        room.solved.set(&room.costates);
        room.forces.clone_from(&room.parted);
        let moved = room.stir::<P, _>(elements, &resting, stage, force, false);
        core::mem::swap(&mut room.costates, &mut room.correction);
        room.correction.set(&room.solved);
        let kept = (&room.on_bodies, &room.in_joints);
        swept::<S, _>(elements, kept, &mut room.at_bodies, &mut room.at_joints);
        // w and ν.
        room.solved.set(&room.costates);
        let held = room.meet::<P, _>(elements, stage);
        core::mem::swap(&mut room.costates, &mut room.solved);
        room.of_forces.clone_from(&room.parted);
        let stirred = room.stir::<P, _>(elements, &resting, stage, held, true);
        let none = <L::Ties as Ties<S>>::each(&S::Scalar::zero());
        ties.weigh([&forces, &none], [&room.solved, &room.solved], L::of_ties(&mut gradient.law)[0]);
        let weights = Some(opposite::<S, P::Closures>(&held));
        self.pull_back_pair((force, moved), (weights, stirred), clock, (stage, position, free), gradient);
    }
}
