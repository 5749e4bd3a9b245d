//! Gradients of long runs: few states kept, and what the steps between two of them need while costates pass.

use super::record::Record;
use super::rules::Staged;
use super::steps::{Steps, TorquesOf};
use super::{Backward, CostateOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::{Resting, Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::EffortOf;
use crate::relation::Additive;
use crate::scalar::Real;
use crate::sensitivity::Gradient;
use crate::shape::PerJoint;
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use crate::walks::copy::copy;
use core::ops::Range;
use num_traits::Zero;

/// A run of fixed steps of which few states are kept.
///
/// Memory is least where states and tape take as much: at √(`steps` / r), where a step of the tape takes r times as much as a state: with
/// RK4 some 35 in the plane (a four-bar linkage 41), 52 in space on balls and 128 on revolute joints, with DOP853 90 (111), 141 and 386. A
/// million steps of twenty rods by RK4 then take 6 MB.
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

/// Room for a step of a tape: its motion, and all that its stages keep.
pub struct Tape<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged> {
    before: MotionOf<S, R, C, P>,
    /// Size of the step (s).
    size: RealOf<S>,
    /// Torques held over it, where sweeps are made once more on the way back.
    torques: Option<TorquesOf<S, R, C>>,
    record: Record<S, Elements<S, R, C>, M, P::Closures>,
}

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged> Clone for Tape<S, R, C, P, M> {
    fn clone(&self) -> Self {
        let (before, torques, record) = (self.before.clone(), self.torques.clone(), self.record.clone());
        Self { before, size: self.size, torques, record }
    }
}

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Resting<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    EffortOf<S>: Additive,
{
    /// Room for a step of a tape: a slice of them is what [`gradient_between`](Self::gradient_between) needs.
    pub fn tape(&self) -> Tape<S, R, C, P, M> {
        let torques = M::IMPLICIT.then(|| self.steps.torques.clone());
        Tape { before: self.steps.scene.motion(), size: RealOf::<S>::zero(), torques, record: self.steps.record() }
    }

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
        self.independent(start)?;
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
    /// As [`gradient`](Self::gradient); [`Fault::Count`], which says how many states or steps of the tape are needed.
    pub fn gradient_between(
        &mut self,
        plan: Checkpoints<RealOf<S>>,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        tape: &mut [Tape<S, R, C, P, M>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<Gradient<S, Elements<S, R, C>>, Error> {
        self.planned(plan, torques.len(), states.len())?;
        self.admits(plan.steps, by_torques.len())?;
        let (longest, given) = (plan.every.max(1).min(plan.steps), tape.len());
        if given < longest {
            return Err(Error::new(Fault::Count { expected: longest, given }));
        }
        let states = &states[..plan.states()];
        let mut rooms = tape.iter().map(|room| &room.before);
        if !(states.iter().all(|state| self.fits(state)) && rooms.all(|room| self.fits(room))) {
            return Err(Error::new(Fault::Shape));
        }
        let mut gradient = self.begin(by_torques);
        let ([start, ..], [.., last]) = (states, states) else { return Ok(gradient) };
        let clock = (start.time, plan.step);
        cost(plan.steps, last, &mut gradient.start)?;
        for (k, state) in states[..states.len() - 1].iter().enumerate().rev() {
            let between = plan.between(k);
            if let [room, ..] = &mut *tape {
                self.steps.copy_past(state, &mut room.before);
            }
            self.onto_tape(clock, between.clone(), torques, tape);
            Steps::<S, R, C, P, M, L>::found_again(&states[k + 1], &self.spare)?;
            self.back_from_tape(between, tape, by_torques, &mut gradient, &mut cost)?;
        }
        self.finish(start, &mut gradient)?;
        Ok(gradient)
    }

    /// As [`run`](Self::run), onto a tape of as many steps, and the motion at the end: for short runs, as
    /// [`gradient_on_tape`](Self::gradient_on_tape) makes no step once more.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_on_tape(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        steps: usize,
        torques: &[EffortOf<S>],
        tape: &mut [Tape<S, R, C, P, M>],
        end: &mut MotionOf<S, R, C, P>,
    ) -> Result<(), Error> {
        self.admits(steps, torques.len())?;
        let given = tape.len();
        let Some(tape) = tape.get_mut(..steps) else {
            return Err(Error::new(Fault::Count { expected: steps, given }));
        };
        if !(self.fits(start) && self.fits(end) && tape.iter().all(|room| self.fits(&room.before))) {
            return Err(Error::new(Fault::Shape));
        }
        self.independent(start)?;
        self.spare.copy_state(start);
        self.steps.forget(&mut self.spare);
        if let [room, ..] = &mut *tape {
            self.steps.copy_past(&self.spare, &mut room.before);
        }
        self.onto_tape((start.time, step), 0..steps, torques, tape);
        end.copy_state(if steps > 0 { &self.spare } else { start });
        let motions = tape.iter().map(|room| &room.before).chain([&*end]);
        motions.skip(1).try_for_each(|motion| Dynamics::<Unloaded>::accept(self.steps.scene, motion))
    }

    /// As [`gradient`](Self::gradient), for a run of `steps` steps [on a tape](Self::run_on_tape), and equal to it to the last bit: 1.7
    /// plain runs with the run, where [`gradient`](Self::gradient) takes 2.6 (RK4, twenty rods, 50 steps).
    ///
    /// # Errors
    /// As [`gradient`](Self::gradient).
    pub fn gradient_on_tape(
        &mut self,
        steps: usize,
        tape: &[Tape<S, R, C, P, M>],
        end: &MotionOf<S, R, C, P>,
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<Gradient<S, Elements<S, R, C>>, Error> {
        self.admits(steps, by_torques.len())?;
        let given = tape.len();
        let Some(tape) = tape.get(..steps) else {
            return Err(Error::new(Fault::Count { expected: steps, given }));
        };
        if !(self.fits(end) && tape.iter().all(|room| self.fits(&room.before))) {
            return Err(Error::new(Fault::Shape));
        }
        let mut gradient = self.begin(by_torques);
        cost(steps, end, &mut gradient.start)?;
        self.back_from_tape(0..steps, tape, by_torques, &mut gradient, &mut cost)?;
        self.finish(tape.first().map_or(end, |room| &room.before), &mut gradient)?;
        Ok(gradient)
    }

    /// Makes steps of these numbers from the first motion of a tape, onto it; the motion after them is then the spare one.
    fn onto_tape(
        &mut self,
        (start, size): (RealOf<S>, RealOf<S>),
        between: Range<usize>,
        torques: &[EffortOf<S>],
        tape: &mut [Tape<S, R, C, P, M>],
    ) {
        let count = between.len();
        for (place, step) in between.enumerate() {
            let [room, rest @ ..] = &mut tape[place..] else { break };
            let end = start + size * RealOf::<S>::of((step + 1) as f64);
            room.size = end - room.before.time;
            self.steps.take_torques(torques, step);
            if let Some(torques) = &mut room.torques {
                copy::<S, _, PerJoint<EffortOf<S>>>(self.steps.scene.elements(), &self.steps.torques, torques);
            }
            let next = match rest {
                [room, ..] if place + 1 < count => &mut room.before,
                _ => &mut self.spare,
            };
            self.steps.step_to(end, &room.before, &mut room.record, next);
            room.record.begin(&mut room.before);
        }
    }

    /// Pulls costates back through steps of these numbers on a tape.
    fn back_from_tape(
        &mut self,
        between: Range<usize>,
        tape: &[Tape<S, R, C, P, M>],
        by_torques: &mut [EffortOf<S>],
        gradient: &mut Gradient<S, Elements<S, R, C>>,
        cost: &mut impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        for (step, room) in between.zip(tape).rev() {
            if let Some(torques) = &room.torques {
                copy::<S, _, PerJoint<EffortOf<S>>>(self.steps.scene.elements(), torques, &mut self.steps.torques);
            }
            self.steps.pull_back(&room.before, room.size, &room.record, None, gradient);
            self.steps.give_torques(by_torques, step);
            cost(step, &room.before, &mut gradient.start)?;
        }
        Ok(())
    }

    /// Refuses lists of torques and states that a plan has no use for.
    fn planned(&self, plan: Checkpoints<RealOf<S>>, torques: usize, given: usize) -> Result<(), Error> {
        let expected = plan.states();
        if given < expected {
            return Err(Error::new(Fault::Count { expected, given }));
        }
        self.admits(plan.steps, torques)
    }
}
