//! Tapes: all that the stages of steps know, kept while costates pass.

use super::record::RecordOf;
use super::rules::Staged;
use super::steps::TorquesOf;
use super::{Backward, CostateOf, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::EffortOf;
use crate::relation::Absent;
use crate::scalar::Real;
use crate::shape::PerJoint;
use crate::stepper::advances;
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use crate::walks::copy::copy;
use core::ops::Range;
use num_traits::Zero;

/// Room for a step of a tape: its motion, and all that its stages keep.
pub struct Tape<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged, L: BodyLaw<S> = Absent> {
    pub(super) before: MotionOf<S, R, C, P>,
    /// Size of the step (s).
    size: RealOf<S>,
    /// Torques held over it, where sweeps are made once more on the way back.
    torques: Option<TorquesOf<S, R, C>>,
    record: RecordOf<S, R, C, P, M, L>,
}

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged, L: BodyLaw<S>> Clone for Tape<S, R, C, P, M, L> {
    fn clone(&self) -> Self {
        let (before, torques, record) = (self.before.clone(), self.torques.clone(), self.record.clone());
        Self { before, size: self.size, torques, record }
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
    /// Room for a step of a tape: a slice of them is what [`gradient_between`](Self::gradient_between) needs.
    pub fn tape(&self) -> Tape<S, R, C, P, M, L> {
        let torques = M::IMPLICIT.then(|| self.steps.torques.clone());
        Tape { before: self.steps.scene.motion(), size: RealOf::<S>::zero(), torques, record: self.steps.record() }
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
        tape: &mut [Tape<S, R, C, P, M, L>],
        end: &mut MotionOf<S, R, C, P>,
    ) -> Result<(), Error> {
        advances(step)?;
        self.admits(steps, torques.len())?;
        let given = tape.len();
        let Some(tape) = tape.get_mut(..steps) else {
            return Err(Error::new(Fault::Count { list: "steps on a tape", expected: steps, given }));
        };
        if !(self.fits(start) && self.fits(end) && tape.iter().all(|room| self.fits(&room.before))) {
            return Err(Error::new(Fault::Shape));
        }
        self.begins(start, (step, steps), torques)?;
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
        tape: &[Tape<S, R, C, P, M, L>],
        end: &MotionOf<S, R, C, P>,
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        self.admits(steps, by_torques.len())?;
        let given = tape.len();
        let Some(tape) = tape.get(..steps) else {
            return Err(Error::new(Fault::Count { list: "steps on a tape", expected: steps, given }));
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
    pub(super) fn onto_tape(
        &mut self,
        (start, size): (RealOf<S>, RealOf<S>),
        between: Range<usize>,
        torques: &[EffortOf<S>],
        tape: &mut [Tape<S, R, C, P, M, L>],
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
    pub(super) fn back_from_tape(
        &mut self,
        between: Range<usize>,
        tape: &[Tape<S, R, C, P, M, L>],
        by_torques: &mut [EffortOf<S>],
        gradient: &mut GradientOf<S, R, C, L>,
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
}
