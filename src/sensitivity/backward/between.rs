//! Motions between the ends of a step: what costs there do to costates.
//!
//! Dense output is one more row of the tableau for each share θ of the step, linear in the accelerations k of all stages, of which some are its own,
//!
//! ```text
//! q_θ = q + θ h v + h² Σ b′_j k_j        v_θ = v + h Σ b_j k_j
//! ```
//!
//! so that costates of such a motion go to those of the k_j and of the motion before the step as those of other rows do. Those that stages of
//! its own get are pulled back at once; those of the step's other stages wait until costates pass these. What is closed is
//! [put back](super::projection) by gains at the motion itself. Implicit rules make a step of the size θ h instead, and so do costates.

use super::GradientOf;
use super::projection::Projection;
use super::record::{RecordOf, Stage, StageOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf};
use crate::ends::{Root, Tip};
use crate::mirror::{Rate, Retraction};
use crate::scalar::Real;
use crate::stepper::displace::displace;
use crate::system::{Elements, MotionOf, RateOf};
use num_traits::Zero;

/// Costates that motions between the ends of a step have left, and room for one of them.
pub(super) struct Between<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged, L: BodyLaw<S>> {
    /// Where the motion stands, and its sweep.
    pub(super) motion: MotionOf<S, R, C, P>,
    stage: StageOf<S, R, C, P, L>,
    slope: RateOf<S, R, C>,
    projection: Option<Projection<S, Elements<S, R, C>>>,
    /// Stages that only dense output reads, in their rows.
    stages: M::Rows<StageOf<S, R, C, P, L>>,
    /// Of accelerations of stages.
    pub(super) of_slopes: M::Rows<RateOf<S, R, C>>,
    /// Of positions, rates and memory before the step, and of the coordinates of the step at its end, where positions are curved.
    pub(super) of_past: [RateOf<S, R, C>; 3],
    pub(super) of_end: [RateOf<S, R, C>; 2],
    /// Of the motion after the step, and of its memory, which wait.
    waiting: [RateOf<S, R, C>; 3],
}

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
    pub(super) fn room_between(&self, record: &RecordOf<S, R, C, P, M, L>) -> Between<S, R, C, P, M, L> {
        let rate = || self.zero.clone();
        let projection = (Self::CLOSED > 0).then(|| Projection::new(self.scene.elements(), &self.zero));
        Between {
            motion: self.scene.motion(),
            stage: record.stages.as_ref()[0].clone(),
            slope: rate(),
            projection,
            stages: M::rows(&record.stages.as_ref()[0]),
            of_slopes: M::rows(&self.zero),
            of_past: [rate(), rate(), rate()],
            of_end: [rate(), rate()],
            waiting: [rate(), rate(), rate()],
        }
    }

    /// Evaluates the stages that only dense output reads, for a step to the next motion.
    fn evaluate_between(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        next: &MotionOf<S, R, C, P>,
        accelerations: &mut M::Rows<RateOf<S, R, C>>,
        stages: &mut M::Rows<StageOf<S, R, C, P, L>>,
    ) {
        let step = next.time - past.time;
        for row in M::STAGES..M::SLOPES {
            let Stage { position, rate, .. } = &mut stages.as_mut()[row];
            if row == M::STAGES {
                position.clone_from(&next.position);
                rate.set(&next.rate);
            } else {
                let (slopes, room) = (accelerations.as_ref(), (&self.zero, &mut self.sum));
                displace(past, slopes, M::node(row), M::weights(row), step, room, (&mut *position, &mut *rate));
                if Self::CURVED {
                    position.retract_rate(&past.position, rate);
                }
            }
            let time = past.time + RealOf::<S>::of(M::node(row)) * step;
            let (stage, slope) = (&mut stages.as_mut()[row], &mut accelerations.as_mut()[row]);
            self.sweep(None, None, self.rule.springs::<S::Scalar>(row, step), time, stage, slope);
            if Self::CURVED {
                stage.acceleration.set(slope);
                stage.position.inverse_retract_acceleration(&past.position, &stage.rate, slope);
            }
        }
    }

    /// Pulls costates of motions at shares of a step back, which `cost` adds to those of the motion where it stands, until there are no more shares.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn pull_back_between<E>(
        &mut self,
        (past, next): (&MotionOf<S, R, C, P>, &MotionOf<S, R, C, P>),
        record: &mut RecordOf<S, R, C, P, M, L>,
        between: &mut Between<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
        (shares, mut cost): (
            impl Iterator<Item = f64>,
            impl FnMut(&MotionOf<S, R, C, P>, &mut GradientOf<S, R, C, L>) -> Result<(), E>,
        ),
    ) -> Result<(), E> {
        let step = next.time - past.time;
        between
            .of_slopes
            .as_mut()
            .iter_mut()
            .chain(&mut between.of_past)
            .chain(&mut between.of_end)
            .for_each(|sum| sum.set(&self.zero));
        if !M::IMPLICIT {
            self.evaluate(past, step, record);
            self.evaluate_between(past, next, &mut record.accelerations, &mut between.stages);
        }
        let [position, rate, memory] = &mut between.waiting;
        position.set(&gradient.start.position);
        rate.set(&gradient.start.rate);
        memory.set(&self.of_memory);
        for share in shares {
            gradient.start.position.set(&self.zero);
            gradient.start.rate.set(&self.zero);
            if const { M::IMPLICIT } {
                self.pull_back_part(past, RealOf::<S>::of(share) * step, record, between, gradient, &mut cost)?;
            } else {
                self.pull_back_share(past, (share, step), record, between, gradient, &mut cost)?;
            }
        }
        let [position, rate, memory] = &between.waiting;
        gradient.start.position.set(position);
        gradient.start.rate.set(rate);
        self.of_memory.set(memory);
        for row in (M::STAGES..M::SLOPES).rev() {
            self.pull_back_row(row, past, step, &record.accelerations, between, gradient);
        }
        Ok(())
    }

    /// As a step of its own.
    fn pull_back_part<E>(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        size: RealOf<S>,
        record: &mut RecordOf<S, R, C, P, M, L>,
        between: &mut Between<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
        cost: &mut impl FnMut(&MotionOf<S, R, C, P>, &mut GradientOf<S, R, C, L>) -> Result<(), E>,
    ) -> Result<(), E> {
        self.step_to(past.time + size, past, record, &mut between.motion);
        cost(&between.motion, gradient)?;
        self.of_memory.set(&self.zero);
        self.pull_back(past, size, record, None, gradient);
        let [of_position, of_rate, of_memory] = &mut between.of_past;
        of_position.add(&gradient.start.position);
        of_rate.add(&gradient.start.rate);
        of_memory.add(&self.of_memory);
        Ok(())
    }

    /// By dense output.
    fn pull_back_share<E>(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        (share, step): (f64, RealOf<S>),
        record: &RecordOf<S, R, C, P, M, L>,
        between: &mut Between<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
        cost: &mut impl FnMut(&MotionOf<S, R, C, P>, &mut GradientOf<S, R, C, L>) -> Result<(), E>,
    ) -> Result<(), E> {
        let [in_position, in_rate] = M::dense(share);
        let weights = (&in_position[..M::SLOPES], &in_rate[..M::SLOPES]);
        let Between { motion, stage, slope, projection, of_slopes, of_past, .. } = &mut *between;
        let room = (&self.zero, &mut self.sum);
        let into = (&mut stage.position, &mut stage.rate);
        displace(past, record.accelerations.as_ref(), share, weights, step, room, into);
        if Self::CURVED {
            stage.position.retract_rate(&past.position, &mut stage.rate);
        }
        motion.time = past.time + RealOf::<S>::of(share) * step;
        motion.position.clone_from(&stage.position);
        motion.rate.set(&stage.rate);
        if let Some(projection) = projection {
            projection.places[0].clone_from(&stage.position);
            projection.rates[0].set(&stage.rate);
            let springs = self.rule.springs::<S::Scalar>(0, step);
            self.sweep(None, None, springs, motion.time, stage, slope);
            self.project(motion.time, stage, projection);
            motion.position.clone_from(projection.place());
            motion.rate.set(projection.rate());
        }
        cost(motion, gradient)?;
        if let Some(projection) = projection {
            let none = RealOf::<S>::zero();
            self.pull_back_projection((motion.time, none), (stage, &stage.position, None), projection, gradient);
            if let Some(room) = &self.room {
                gradient.start.position.add(&room.of_stage);
            }
        }
        let ([of_position, of_rate, _], of) = (of_past, &mut gradient.start);
        if Self::CURVED {
            let still = (&stage.rate, &self.zero);
            let of_step = (&mut of.position, &mut of.rate);
            stage.position.transposed_step(&past.position, still, &self.zero, of_step, of_position);
        } else {
            of_position.add(&of.position);
        }
        Self::spread((&of.position, &of.rate), (share, step), weights, of_slopes, of_rate, &mut self.sum);
        Ok(())
    }

    /// Gives what the coordinates of a row, and their first derivatives, read of accelerations and rates its costates.
    fn spread(
        (of_position, of_rate): (&RateOf<S, R, C>, &RateOf<S, R, C>),
        (node, step): (f64, RealOf<S>),
        (in_position, in_rate): (&[f64], &[f64]),
        of_slopes: &mut M::Rows<RateOf<S, R, C>>,
        of_past: &mut RateOf<S, R, C>,
        sum: &mut RateOf<S, R, C>,
    ) {
        let (real, square) = (RealOf::<S>::of, step * step);
        for ((of_slope, position), rate) in of_slopes.as_mut().iter_mut().zip(in_position).zip(in_rate) {
            sum.set(of_slope);
            of_slope.mix_2(sum, (real(*position) * square, of_position), (real(*rate) * step, of_rate));
        }
        sum.set(of_past);
        of_past.mix_2(sum, (real(node) * step, of_position), (real(1.0), of_rate));
    }

    /// From the costates of a stage that only dense output reads to those of stages before it.
    fn pull_back_row(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        accelerations: &M::Rows<RateOf<S, R, C>>,
        between: &mut Between<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let (stage, slope) = (&between.stages.as_ref()[row], &accelerations.as_ref()[row]);
        let Stage { position, rate, acceleration, .. } = stage;
        self.of_acceleration.set(&between.of_slopes.as_ref()[row]);
        if Self::CURVED {
            position.transposed_acceleration(&past.position, &mut self.of_acceleration);
        }
        let time = past.time + RealOf::<S>::of(M::node(row)) * step;
        self.pull_back_stage(None, (row, true), time, (stage, slope), gradient);
        let (of_position, of_rate) = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
        let [of_past, of_past_rate, _] = &mut between.of_past;
        // The motion after the step may have been put elsewhere than the step led.
        let put = row == M::STAGES && Self::CLOSED > 0;
        if Self::CURVED {
            let of_second = &between.of_slopes.as_ref()[row];
            let (here, of_here) = ((rate, acceleration), (&mut *of_position, &mut *of_rate));
            if put {
                position.transposed_second(&past.position, here, of_second, of_here, of_past);
            } else {
                position.transposed_step(&past.position, here, of_second, of_here, of_past);
            }
        }
        if row == M::STAGES {
            let ([in_position, in_rate], of_next) = (&mut between.of_end, &mut gradient.start);
            let [position, rate] =
                if Self::CURVED && !put { [in_position, in_rate] } else { [&mut of_next.position, &mut of_next.rate] };
            position.add(of_position);
            rate.add(of_rate);
            return;
        }
        if !Self::CURVED {
            of_past.add(of_position);
        }
        let (node, of) = (M::node(row), (&*of_position, &*of_rate));
        Self::spread(of, (node, step), M::weights(row), &mut between.of_slopes, of_past_rate, &mut self.sum);
    }
}
