//! Steps of a rule that remembers: of the generalised-α family, whose auxiliary acceleration A goes on from step to step.
//!
//! With A₀ = a₀ + h o₀, κ, o_t and o_a the weights of a₁, a₀ and A₀ in A₁, and B = β κ h², Γ = γ κ h,
//!
//! ```text
//! q₁ = free + B a₁       free = q₀ + h v₀ + h² ((½ − β κ) a₀ + h p o₀)       p = ½ − β + β o_a
//! v₁ = free + Γ a₁       free =      v₀ + h  ((1 − γ κ) a₀ + h r o₀)         r = 1 − γ + γ o_a
//! o₁ = (κ − 1) (a₁ − a₀) / h + o_a o₀
//! ```
//!
//! a₀ is found where the step begins, under its torques; o, which is zero where a run begins, is what the rule remembers. Motions of a run
//! keep it in the place of their accelerations.
//!
//! Backward, a₁ gets B Q + Γ V + (κ − 1) ō / h and is [pulled back](super::implicit) to costates of both `free`; by these, and by ō, go a₀,
//! o₀, q₀ and v₀. The first geometry of the step, q₀ + h v₀ and v₀, gives q₀ and v₀ costates of its own.

use super::GradientOf;
use super::again::{follow, paired, unfollow};
use super::record::{Place, RecordOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::Real;
use crate::system::{Elements, MotionOf, PositionOf, RateOf};
use num_traits::Zero;

/// What a rule of the family makes of the motion before a step.
struct Weights<R> {
    /// Of a₀ in both `free`, and of o₀; their derivatives by the size of the step.
    first: [R; 2],
    memory: [R; 2],
    first_by_size: [R; 2],
    memory_by_size: [R; 2],
    /// Of a₁ − a₀, and of o₀, in o₁.
    change: R,
    last: R,
}

impl<R: Real> Weights<R> {
    /// The weights in a step (s); zeros for a rule without memory.
    fn of(rule: &impl Staged, step: R) -> Self {
        let none = || [R::zero(); 2];
        let Some(family) = rule.family() else {
            let (first, memory) = (none(), none());
            let (first_by_size, memory_by_size) = (none(), none());
            return Self { first, memory, first_by_size, memory_by_size, change: R::zero(), last: R::zero() };
        };
        let ([kappa, _, of_last], beta, gamma) = (family.recurrence(), family.beta, family.gamma);
        // A step that is too short for its time remembers what it has.
        let [change, last] =
            if step.is_zero() { [R::zero(), R::one()] } else { [R::of(kappa - 1.0) / step, R::of(of_last)] };
        let (u, v) = (R::of(0.5 - beta * kappa), R::of(1.0 - gamma * kappa));
        let (p, r) = (R::of(0.5 - beta + beta * of_last), R::of(1.0 - gamma + gamma * of_last));
        let square = step * step;
        Self {
            first: [u * square, v * step],
            memory: [p * square * step, r * square],
            first_by_size: [(u + u) * step, v],
            memory_by_size: [(p + p + p) * square, (r + r) * step],
            change,
            last,
        }
    }
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
    /// Makes a motion one in which a run begins.
    pub(super) fn forget(&self, start: &mut MotionOf<S, R, C, P>) {
        if const { M::REMEMBERS } {
            start.acceleration.set(&self.zero);
        }
    }

    /// Copies the state of a motion, and what the rule remembers of it.
    pub(super) fn copy_past(&self, from: &MotionOf<S, R, C, P>, into: &mut MotionOf<S, R, C, P>) {
        into.copy_state(from);
        if const { M::REMEMBERS } {
            into.acceleration.set(&from.acceleration);
        }
    }

    /// Where positions and rates would be at the end of a step without a₁.
    pub(super) fn remember(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        slopes: &[RateOf<S, R, C>],
        (position, rate): &mut Place<S, R, C>,
    ) {
        let Weights { first, memory, .. } = Weights::of(&self.rule, step);
        let (slope, offset) = (slopes.first().unwrap_or(&self.zero), &past.acceleration);
        position.drift_2(&past.position, (step, &past.rate), (first[0], slope), (memory[0], offset));
        rate.mix_2(&past.rate, (first[1], slope), (memory[1], offset));
    }

    /// Where positions and rates are at the end of a step whose stages have been evaluated, before closures put them back.
    pub(super) fn end_unprojected(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        slopes: &M::Rows<RateOf<S, R, C>>,
        into: (&mut PositionOf<S, R, C>, &mut RateOf<S, R, C>),
    ) {
        let (slopes, [own, _]) = (slopes.as_ref(), self.rule.own::<S::Scalar>(step));
        let [_, found, ..] = slopes else { return };
        let Some(mut room) = self.again.take() else { return };
        self.remember(past, step, slopes, &mut room.free);
        follow::<S, Elements<S, R, C>>((&room.free.0, &room.free.1), own, found, &self.zero, into);
        self.again = Some(room);
    }

    /// The motion at the end of a step whose stages have been evaluated.
    pub(super) fn end_with_memory(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &RecordOf<S, R, C, P, M, L>,
        next: &mut MotionOf<S, R, C, P>,
    ) {
        if let Some(projection) = &record.projection {
            next.position.clone_from(projection.place());
            next.rate.set(projection.rate());
        } else {
            self.end_unprojected(past, step, &record.accelerations, (&mut next.position, &mut next.rate));
        }
        let [first, found, ..] = record.accelerations.as_ref() else { return };
        let Weights { change, last, .. } = Weights::of(&self.rule, step);
        next.acceleration.mix_3(&self.zero, (change, found), (-change, first), (last, &past.acceleration));
    }

    /// Refuses states that are not those of a run by this rule, which remembers more than positions and rates: by the end of a step whose
    /// stages have been evaluated, and with it.
    pub(super) fn recognise(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        next: &MotionOf<S, R, C, P>,
        record: &RecordOf<S, R, C, P, M, L>,
        end: &mut MotionOf<S, R, C, P>,
    ) -> Result<(), Error> {
        if const { !M::REMEMBERS } {
            return Ok(());
        }
        self.end_with_memory(past, next.time - past.time, record, end);
        Self::found_again(next, end)
    }

    /// Refuses a state that is not where steps of this rule have led.
    pub(super) fn found_again(next: &MotionOf<S, R, C, P>, end: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        if !M::REMEMBERS || next.has_state(next.time, &end.position, &end.rate) {
            return Ok(());
        }
        let what = "the gradient of a run by a rule that remembers, from states that another run has left";
        Err(Error::new(Fault::Unsupported { what }).at_time(next.time.as_f64()))
    }

    /// From the costates after a step, which stand in its last row, to those before it.
    pub(super) fn pull_back_memory(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &RecordOf<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let (start, [first, found, ..]) = (&record.stages.as_ref()[0], record.accelerations.as_ref()) else { return };
        let ([own, by_size], weights) = (self.rule.own::<S::Scalar>(step), Weights::of(&self.rule, step));
        let Weights { change, last, .. } = weights;
        let one = RealOf::<S>::of(1.0);
        let Some(mut room) = self.again.take() else { return };
        let again = &mut *room;
        // Of where the step would be without a₁, for now.
        gradient.start.position.set(&self.zero);
        {
            self.remember(past, step, record.accelerations.as_ref(), &mut again.free);
            let (from, into) = ((&again.free.0, &again.free.1), (&mut again.read.0, &mut again.read.1));
            follow::<S, Elements<S, R, C>>(from, own, found, &self.zero, into);
            let of_position = &mut self.of_position.as_mut()[2];
            let (between, of_free) = ((&again.read.0, &again.free.0), &mut gradient.start.position);
            unfollow(between, (&self.zero, &mut self.sum), of_position, of_free);
            let (of_position, of_rate) = (&self.of_position.as_ref()[2], &self.of_rate.as_ref()[2]);
            if let Some(sum) = &mut self.of_own {
                *sum += paired::<S, Elements<S, R, C>>(by_size, (of_position, of_rate), found);
            }
            let (q, v, memory) = ((own[0], of_position), (own[1], of_rate), (change, &self.of_memory));
            self.of_acceleration.mix_3(&self.zero, q, v, memory);
        }
        self.again = Some(room);
        self.pull_back_solution(1, past, step, record, gradient);
        let Some(again) = self.again.as_deref_mut() else { return };
        let ([.., of_free, _], [.., by_free, by_end]) = (self.of_position.as_mut(), self.of_rate.as_mut()) else {
            return;
        };
        of_free.add(&gradient.start.position);
        by_free.add(by_end);
        // Coordinates of two steps: to there, and to the geometry that was predicted.
        gradient.start.position.set(&self.zero);
        again.read.0.drift_0(&past.position, (step, &past.rate));
        let ends = [(&again.free.0, &mut *of_free), (&again.read.0, &mut again.of_geometry.0)];
        for (end, of_end) in ends {
            let room = (&self.zero, &mut self.sum);
            unfollow((end, &past.position), room, of_end, &mut gradient.start.position);
        }
        let (again, of_free, by_free) = (&*again, &*of_free, &*by_free);
        if let Some(sum) = &mut self.of_own {
            let of = (of_free, by_free);
            *sum += paired::<S, Elements<S, R, C>>(weights.first_by_size, of, first);
            *sum += paired::<S, Elements<S, R, C>>(weights.memory_by_size, of, &past.acceleration);
            *sum += paired::<S, Elements<S, R, C>>([one, RealOf::<S>::zero()], of, &past.rate);
            let of = (&again.of_geometry.0, &again.of_geometry.1);
            *sum += paired::<S, Elements<S, R, C>>([one, RealOf::<S>::zero()], of, &past.rate);
        }
        let ([in_place, in_speed], memory) = (weights.first, weights.memory);
        let of_change = (-change, &self.of_memory);
        self.of_acceleration.mix_3(&self.zero, (in_place, of_free), (in_speed, by_free), of_change);
        self.sum.set(&self.of_memory);
        self.of_memory.mix_3(&self.zero, (last, &self.sum), (memory[0], of_free), (memory[1], by_free));
        self.pull_back_stage(Some(past), (0, true), past.time, (start, first), gradient);
        let Some(again) = &self.again else { return };
        let (q, v) = (self.of_position.as_ref(), self.of_rate.as_ref());
        let ([q_start, q_free, _], [v_start, v_free, _]) = (q, v) else { return };
        let (q_predicted, v_predicted) = &again.of_geometry;
        gradient.start.position.add(q_start);
        self.sum.mix_2(v_start, (one, v_free), (one, v_predicted));
        gradient.start.rate.mix_2(&self.sum, (step, q_free), (step, q_predicted));
    }
}
