//! Gradients of long runs: few states kept, and what the steps between two of them need while costates pass.

use super::rules::Staged;
use super::steps::Steps;
use super::tape::Tape;
use super::{Backward, CostateOf, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::loading::EffortOf;
use crate::scalar::{Real, Scalar};
use crate::stepper::advances;
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use core::ops::Range;

/// A run of fixed steps of which few states are kept.
///
/// Memory is least where states and tape take as much: at √(`steps` / r), where a step of the tape takes r times as much as a state: with
/// RK4 some 30 in the plane, 44 in space on balls and 105 on revolute joints, with DOP853 75, 111 and 293. A million steps of twenty rods by
/// RK4 then take 5.5 MB, and for one run more 0.6 MB ([in levels](super::Backward::gradient_in_levels)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checkpoints<T> {
    /// Size of a step (s).
    pub step: T,
    /// Number of steps.
    pub steps: usize,
    /// A state is kept before every so many of them, one or more; as many steps has the tape.
    pub every: usize,
}

impl<T> Checkpoints<T> {
    /// How many states are kept: before the first step and every so many of the others, and after the last.
    pub fn states(&self) -> usize {
        self.steps.div_ceil(self.every.max(1)).saturating_add(1)
    }

    /// The numbers of the steps between a state that is kept and the next one.
    fn between(&self, state: usize) -> Range<usize> {
        let first = (state * self.every.max(1)).min(self.steps);
        first..(first + self.every.max(1)).min(self.steps)
    }
}

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// As [`run`](Self::run), keeping few states.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_between(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        plan: Checkpoints<RealOf<S>>,
        torques: &[EffortOf<S>],
        states: &mut [MotionOf<S, R, C, P>],
    ) -> Result<(), Error> {
        self.planned(plan, torques.len(), states.len())?;
        let states = &mut states[..plan.states()];
        if !(self.fits(start) && states.iter().all(|state| state.fits(start))) {
            return Err(Error::new(Fault::Shape));
        }
        self.begins(start, (plan.step, plan.steps), torques)?;
        states[0].copy_state(start);
        self.steps.forget(&mut states[0]);
        for k in 1..states.len() {
            let [past, next, ..] = &mut states[k - 1..] else { break };
            self.steps.copy_past(past, next);
            let between = plan.between(k - 1);
            for step in between.clone() {
                let time = start.time + plan.step * RealOf::<S>::of((step + 1) as f64);
                self.steps.take_torques(torques, step);
                self.steps.step_to(time, next, &mut self.record, &mut self.spare);
                if step == between.start {
                    self.record.begin(past);
                }
                core::mem::swap(next, &mut self.spare);
                Dynamics::<Unloaded>::accept(self.steps.scene, next)?;
            }
        }
        Ok(())
    }

    /// As [`gradient`](Self::gradient), for a run of which few states were kept, and equal to it to the last bit: from each of them the
    /// steps up to the next one are made once more, onto the tape, and costates pulled back through it. That is a run more at most,
    /// however long the run is.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::sensitivity::Checkpoints;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let start = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let mut backward = pendulum.backward(Rk4);
    /// let plan = Checkpoints { step: 1e-3, steps: 10_000, every: 50 };
    /// let (mut states, mut tape) = (vec![start; plan.states()], vec![backward.tape(); plan.every]); // 201 and 50
    /// backward.run_between(&start, plan, &[], &mut states)?;
    /// let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
    ///     10_000 => by.add(&[0.0, 1.0], &[0.0, 0.0]),
    ///     _ => Ok(()),
    /// };
    /// let gradient = backward.gradient_between(plan, &[], &states, &mut tape, &mut [], end)?;
    /// # assert!(gradient.by_gravity().y.is_finite());
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`gradient`](Self::gradient); [`Fault::Count`], which says how many states or steps of the tape are needed; [`Fault::Unsupported`] for states
    /// that another plan has kept, with the time of the first that this one has no use for.
    pub fn gradient_between(
        &mut self,
        plan: Checkpoints<RealOf<S>>,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        tape: &mut [Tape<S, R, C, P, M, L>],
        by_torques: &mut [EffortOf<S>],
        cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        let (longest, given) = (plan.every.max(1).min(plan.steps), tape.len());
        if given < longest {
            return Err(Error::new(Fault::Count { list: "steps on a tape", expected: longest, given }));
        }
        self.gradient_in_levels(plan, torques, states, &mut [], tape, by_torques, cost)
    }

    /// As [`gradient_between`](Self::gradient_between), on a tape of fewer steps than lie between two states: for one run more, `middle` keeps states
    /// between those, one for each length of the tape. Memory is then least where all three take as much. A million steps of twenty rods by RK4, of
    /// which every 5000th state is kept, 200 between these and 25 steps of the tape, take 0.6 MB. In instructions run and gradient are 4.4 plain runs then, and 3.4 with all the tape
    /// (twenty rods on pins, RK4, x86-64-v3; 5000 steps, states every 500 and every 25).
    ///
    /// # Errors
    /// As [`gradient_between`](Self::gradient_between); [`Fault::Count`] says how many states `middle` needs.
    #[allow(clippy::too_many_arguments)] // one for each kind of memory
    pub fn gradient_in_levels(
        &mut self,
        plan: Checkpoints<RealOf<S>>,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        middle: &mut [MotionOf<S, R, C, P>],
        tape: &mut [Tape<S, R, C, P, M, L>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        self.planned(plan, torques.len(), states.len())?;
        self.admits(plan.steps, by_torques.len())?;
        let (longest, length) = (plan.every.max(1).min(plan.steps), tape.len());
        if length == 0 && longest > 0 {
            return Err(Error::new(Fault::Count { list: "steps on a tape", expected: 1, given: 0 }));
        }
        let (needed, given) = (if length < longest { longest.div_ceil(length) } else { 0 }, middle.len());
        if given < needed {
            return Err(Error::new(Fault::Count { list: "states between", expected: needed, given }));
        }
        let states = &states[..plan.states()];
        let mut motions = states.iter().chain(&*middle).chain(tape.iter().map(|room| &room.before));
        if !motions.all(|motion| self.fits(motion)) {
            return Err(Error::new(Fault::Shape));
        }
        let mut gradient = self.begin(by_torques);
        let ([start, ..], [.., last]) = (states, states) else { return Ok(gradient) };
        let clock = (start.time, plan.step);
        for (k, state) in states.iter().enumerate() {
            let steps = if k + 1 == states.len() { plan.steps } else { plan.between(k).start };
            let late = state.time - (start.time + plan.step * RealOf::<S>::of(steps as f64));
            if !late.is_finite() || late.abs() > plan.step * RealOf::<S>::of(0.5) {
                let what = "the gradient of a run from states that were kept by another plan";
                return Err(Error::new(Fault::Unsupported { what }).at_time(state.time.as_f64()));
            }
        }
        cost(plan.steps, last, &mut gradient.start)?;
        for (k, state) in states[..states.len() - 1].iter().enumerate().rev() {
            let between = plan.between(k);
            let parts = between.len().div_ceil(length.max(1));
            let part_of = |part: usize| {
                let first = between.start + part * length;
                first..(first + length).min(between.end)
            };
            if parts > 1 {
                self.onto_middle(clock, state, (1..parts).map(|part| part_of(part - 1)), torques, middle);
            }
            for part in (0..parts).rev() {
                let from = if parts > 1 { &middle[part] } else { state };
                if let [room, ..] = &mut *tape {
                    self.steps.copy_past(from, &mut room.before);
                }
                self.onto_tape(clock, part_of(part), torques, tape);
                if part + 1 == parts {
                    Steps::<S, R, C, P, M, L>::found_again(&states[k + 1], &self.spare)?;
                }
                self.back_from_tape(part_of(part), tape, by_torques, &mut gradient, &mut cost)?;
            }
        }
        self.finish(start, &mut gradient)?;
        Ok(gradient)
    }

    /// Makes steps from a state that is kept, and keeps those in which parts begin.
    fn onto_middle(
        &mut self,
        (start, size): (RealOf<S>, RealOf<S>),
        state: &MotionOf<S, R, C, P>,
        parts: impl Iterator<Item = Range<usize>>,
        torques: &[EffortOf<S>],
        middle: &mut [MotionOf<S, R, C, P>],
    ) {
        self.steps.copy_past(state, &mut middle[0]);
        for (part, between) in parts.enumerate() {
            let [past, next, ..] = &mut middle[part..] else { break };
            self.steps.copy_past(past, next);
            for step in between {
                let time = start + size * RealOf::<S>::of((step + 1) as f64);
                self.steps.take_torques(torques, step);
                self.steps.step_to(time, next, &mut self.record, &mut self.spare);
                core::mem::swap(next, &mut self.spare);
            }
        }
    }

    /// Refuses lists of torques and states that a plan has no use for.
    fn planned(&self, plan: Checkpoints<RealOf<S>>, torques: usize, given: usize) -> Result<(), Error> {
        advances(plan.step)?;
        let expected = plan.states();
        if given < expected {
            return Err(Error::new(Fault::Count { list: "states", expected, given }));
        }
        self.admits(plan.steps, torques)
    }
}
