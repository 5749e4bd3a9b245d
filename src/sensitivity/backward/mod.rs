//! Gradients of runs: one number, computed from a whole run, by everything at once.

mod adaptive;
mod admission;
mod again;
mod apart;
mod assembly;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod at_change;
mod between;
mod checkpoints;
mod costates;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod course;
mod events;
mod held;
mod implicit;
mod lead;
mod linear;
mod loads;
mod memory;
mod metric;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod past;
mod projected;
mod projection;
mod record;
mod rules;
mod samples;
mod steps;
mod tape;
mod tied;

use super::gradient::{Costate, Gradient};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::EffortOf;
use crate::mirror::Rate;
use crate::relation::{Absent, Additive, Geometry};
use crate::scalar::{Elementary, Real};
use crate::stepper::advances;
use crate::system::{Dynamics, Elements, MotionOf, RateOf, Runs, System};
pub use checkpoints::Checkpoints;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(super) use course::Acting;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use course::Course;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use past::PastGradient;
use record::RecordOf;
use rules::Staged;
use steps::Steps;
pub use tape::Tape;

/// Runs of a scene by fixed steps or accepted ones, and their gradients.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// let (torques, mut by_torques) = ([0.1; 400], [0.0; 400]); // (N·m), in both pins, held over each of 200 steps
/// let mut states = [start; 201]; // before each step, and at the end
/// let mut backward = pendulum.backward(Rk4);
/// backward.run(&start, 0.01, 200, &torques, &mut states)?;
/// // By how much the second angle at the end changes with all that the run depends on.
/// let cost = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
///     200 => by.add(&[0.0, 1.0], &[0.0, 0.0]), // by positions and rates
///     _ => Ok(()),
/// };
/// let gradient = backward.gradient(&torques, &states, &mut by_torques, cost)?;
/// println!("{:?} {} {}", gradient.by_position(), gradient.by_gravity().y, by_torques[17]);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// By lengths, masses and inertias, or whatever else a scene is made of: [`Gradient::along`].
///
/// The steps are those of the rule itself with loads held over each step, and the gradient is theirs, exact but for rounding at any size of
/// step. A run goes forward once and keeps its states; the gradient makes each step once more, from the last to the first, and pulls
/// costates back through the gains of its stages. Room for one step is all that is needed besides the states, and nothing is allocated but
/// what the vectors of a scene take: room, once, and the gradient. Of long runs few states are kept
/// ([`gradient_between`](Self::gradient_between)); of short ones all that their stages know, on a tape
/// ([`gradient_on_tape`](Self::gradient_on_tape)).
///
/// Costs are read at states, or at samples between them ([`gradient_at`](Self::gradient_at)).
///
/// Steps lie between the times of the states: of one size ([`run`](Self::run)), as error control has chosen them
/// ([`run_adaptive`](Self::run_adaptive)), the last one [cut](Self::cut) at an event ([`gradient_to_event`](Self::gradient_to_event)).
///
/// Gradients over many times that it takes a perturbation to grow are exact, and as large as perturbations grow.
///
/// # What it knows
///
/// In the plane `Rod`, `RigidBody`, `PointMass`, `Pin`, `Weld`, `Slider` and `ElasticHinge` (with linear springs along axes of
/// the inboard body, along those of (33)-(35), or, by explicit rules, along fixed ones, each of three laws then of three numbers or less), in tuples, arrays, vectors
/// and branches, named or not, and in loops that a `Pin` or a `Weld` closes (`Network`, `ClosedLoop`), nested or not, from a `Pinned` or
/// `Clamped` root, or a `Free` one, to free tips, or to those that are `Pinned`, `Clamped` or `Guided` at a place that does not move. The
/// projection that puts a tip back and closes loops at the end of a step is part of the step, and of the gradient, as many corrections as it
/// takes; places, angles and lines of tips are parameters. Forces that hold a tip or close a loop are no part of states here: costs may not
/// read them. Initial coordinates are derived by as if each could be changed alone: a length, changed at fixed coordinates, opens a loop, which
/// the first step closes; starts that are [assembled](Self::assembled) close with it. Springs may have dampers and rest values;
/// a law of the user's own in a hinge ([`ElasticHinge::with`](crate::planar::ElasticHinge::with)) goes backward by itself where it is
/// generic over the scalar and [`lift!`](crate::lift!)ed, by jets of its angle, its rate and its numbers, six or less; so do loads on bodies
/// ([`under`](Self::under)), and [`Struts`](crate::struts::Struts) between them.
///
/// By [`Sdirk4`](crate::time::Sdirk4) and [`GeneralizedAlpha`](crate::time::GeneralizedAlpha), at fixed steps, the same scenes: they solve a step
/// by several sweeps, and costates go back through all of them. Laws that are not linear have second derivatives here, those of what they add to pivots.
///
/// `GeneralizedAlpha` remembers its auxiliary acceleration A. Its steps are those of [`step`](crate::stepper::Stepper::step): each begins with
/// the accelerations a that the torques of this step cause, where `simulate` goes on with those that the last sweep has left. A run begins with
/// A = a; the motions that it keeps hold (A − a) / h, by the size h of the step before (m/s³ or rad/s³), in the place of accelerations, without
/// which there is no gradient of it: states that another rule or `simulate` has left are refused. A step linearised is the first of a run.
///
/// In space `Rod`, `RigidBody` with its mass centre, axes of inertia and outboard end anywhere, `PointMass`, `Ball`, `Weld`, and `Revolute`,
/// `Prismatic`, `Cylindrical` and `Universal` with or without a `Spring` or a law of the user's own ([`Custom`](crate::planar::Custom); where
/// there are two laws, each of three numbers or less), `ElasticHinge` with a rotary spring, with linear springs or laws of three numbers or
/// less, and, alone, with a [`RotaryLaw`](crate::spatial::RotaryLaw) of the user's own of nine numbers or less, generic over the scalar and
/// [`lift!`](crate::lift!)ed, composed in the same ways, also
/// in loops that a `Ball`, a `Weld` or a `Revolute` closes, from a `Pinned`, `Clamped` or `Hinged` root, or a `Free` one, to tips that are
/// free, or `Pinned`, `Clamped` or `Hinged` at a place that does not move; of projections and initial coordinates holds what was said of the
/// plane. An attitude has three derivatives, by a rotation vector (rad) in axes of its body: costs add theirs in the same numbers, and steps
/// linearised have their rows and columns so. Rates of balls are angular velocities in axes of the body (rad/s). Torques are
/// [`Effort`](crate::spatial::Effort)s, in a ball a vector in these axes (of a ball that closes a loop: in axes of the main arm's last body),
/// in other joints one number for each coordinate. Loads on bodies and struts go backward as in the plane. Directions of axes, attitudes of welds and of the ground at both ends are parameters like all others.
///
/// In axes of bodies ([`robot`](crate::robot)) gradients go through hinges and slides with a `Spring`, `DryFriction`, `Stops`, a tuple of these, six numbers in
/// all, or a law of the user's own, through links, and through flanges to all that was said; by masses, mass centres, tensors, places and turns of
/// joints, reflected inertias. What a type says to be zero has no derivative.
///
/// Joints in all of these may be [`Driven`](crate::planar::Driven) by a law that can be lifted: its numbers are parameters. Joints may
/// [follow others](crate::planar::Couplings), where something is held or closed, too, but not beside a hinge with linear springs along fixed axes there.
///
/// Joints with modes, [`Coulomb`](crate::planar::Coulomb) and [`HardStops`](crate::planar::HardStops), change these at times that hang on everything:
/// such runs are made by [`course`](Self::course), by explicit rules, and their gradients by [`gradient_past`](Self::gradient_past); torques are held
/// over the run or over intervals of it, and laws, struts and couplings may act ([`under`](Self::under)). All else here refuses such scenes.
///
/// The ground of a root may [move](crate::planar::Moving), and that which a `Pinned` or `Clamped` tip stands on (in space its place alone): parameters of
/// such motions are not among the derivatives, and are refused where the gradient is asked for along them, but for an offset.
///
/// All else is an error of the compiler that names it.
///
#[doc = include_str!("costs.md")]
pub struct Backward<'s, S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged, L: BodyLaw<S> = Absent> {
    steps: Steps<'s, S, R, C, P, M, L>,
    record: RecordOf<S, R, C, P, M, L>,
    spare: MotionOf<S, R, C, P>,
    /// For gradients of which no parameters are asked.
    scratch: GradientOf<S, R, C, L>,
    method: M,
    /// Whether starts are assembled.
    assembled: bool,
}

/// The gradient of a run.
type GradientOf<S, R, C, L> = Gradient<S, Elements<S, R, C>, L>;
/// Costates of a motion of a scene.
type CostateOf<S, R, C> = Costate<RateOf<S, R, C>, <S as Geometry>::Scalar>;

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Runs by a rule whose gradients go backward: `Rk4`, `Dopri5`, `Dop853`, `Sdirk4` and `GeneralizedAlpha`.
    ///
    /// See [`sensitivity::Backward`](crate::sensitivity::Backward).
    pub fn backward<M: Staged>(&self, method: M) -> Backward<'_, S, R, C, P, M>
    where
        R: Root<S>,
        P: ReversibleTip<S>,
        Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, Absent, P::Closures>,
        Self: Runs<Unloaded, S, R, C, P>,
    {
        Backward::new(self, method, Absent)
    }
}

impl<'s, S, R, C, P, M, L> Backward<'s, S, R, C, P, M, L>
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
    fn new(scene: &'s System<S, R, C, P>, method: M, law: L) -> Self {
        let steps = Steps::new(scene, method, law);
        let scratch = Gradient::none(scene.elements(), &steps.zero, &law);
        Self { record: steps.record(), steps, spare: scene.motion(), scratch, method, assembled: false }
    }

    /// Runs `steps` steps of a size (s), and keeps the state before each of them and after the last, with the accelerations in which a
    /// step begins. `torques` are those in all joints (the root's first), held over the first step, then those over the second, and so on;
    /// or those of one step, held over all; or none.
    ///
    /// The last state has no accelerations but zeros, and by `Sdirk4`, which finds none where a step begins, so has each; by
    /// `GeneralizedAlpha` all have what the rule remembers instead: `with_accelerations` finds them.
    ///
    /// A step ends at a multiple of its size after the start, without the rounding of a running sum, as in
    /// [`simulate`](System::simulate).
    ///
    /// # Errors
    /// [`Fault::NotPositive`] for the step; [`Fault::Count`], which says how many states or torques are needed; [`Fault::Shape`] for motions of
    /// another scene; [`Fault::NonFiniteMotion`] or [`Fault::AngleOutOfRange`], with the time, [`Fault::NonFiniteLoad`] for torques, with the joint, too;
    /// [`Fault::OutOfRange`] for steps that the clock rounds away; [`Fault::RedundantClosures`] where the start holds its tip, or closes a loop, twice in the same
    /// way; [`Fault::NotAssembled`] where tips and loops are far from closed, or joints that follow others do not; what is wrong with the parameters of the rule; what
    /// [`LoadLaw::check`](crate::loading::LoadLaw::check) of the loads on bodies refuses.
    pub fn run(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        steps: usize,
        torques: &[EffortOf<S>],
        states: &mut [MotionOf<S, R, C, P>],
    ) -> Result<(), Error> {
        advances(step)?;
        self.admits(steps, torques.len())?;
        let given = states.len();
        let Some(states) = states.get_mut(..=steps) else {
            return Err(Error::new(Fault::Count { list: "states", expected: steps.saturating_add(1), given }));
        };
        if !(self.fits(start) && states.iter().all(|state| state.fits(start))) {
            return Err(Error::new(Fault::Shape));
        }
        self.begins(start, (step, steps), torques)?;
        states[0].copy_state(start);
        self.steps.forget(&mut states[0]);
        for k in 0..steps {
            let [past, next, ..] = &mut states[k..] else { break };
            self.steps.take_torques(torques, k);
            let time = start.time + step * RealOf::<S>::of((k + 1) as f64);
            self.steps.step_to(time, past, &mut self.record, next);
            self.record.begin(past);
            Dynamics::<Unloaded>::accept(self.steps.scene, next)?;
        }
        Ok(())
    }

    /// The gradient of a cost by everything, for a run whose states are `states`, from the last to the first: `cost` is told the number of
    /// each of them, and adds the derivatives of the cost by its position and rate. `by_torques` becomes the gradient by torques, of
    /// each step or of all; it may be empty.
    ///
    /// The steps are those of this method from one state to the next, as long as their times are apart: whatever run they are of. A rule that
    /// remembers, `GeneralizedAlpha`, knows its own run alone.
    ///
    /// What a cost reads besides positions and rates, a length for the place of the tip, is not in this gradient.
    ///
    /// # Errors
    /// [`Fault::Count`] for lists of another length, [`Fault::Shape`] for motions of another scene; [`Fault::OutOfRange`] for states that go back in
    /// time, as those beyond the end of a run do, with the time before; [`Fault::Unsupported`] where a rule that remembers is given states that are not of its run, with the time; [`Fault::NotFinite`] for a gradient that is none, of derivatives of the
    /// cost that are none; what the loads on bodies refuse, as in [`run`](Self::run); those of the cost.
    pub fn gradient(
        &mut self,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        let last = self.check(torques, states)?;
        self.admits(states.len() - 1, by_torques.len())?;
        let mut gradient = self.begin(by_torques);
        cost(states.len() - 1, last, &mut gradient.start)?;
        self.pull_back(torques, states, by_torques, &mut gradient, cost)?;
        Ok(gradient)
    }

    /// Pulls the costate of the last state back to the first.
    fn pull_back(
        &mut self,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        by_torques: &mut [EffortOf<S>],
        gradient: &mut GradientOf<S, R, C, L>,
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        for (k, pair) in states.windows(2).enumerate().rev() {
            let [past, next] = pair else { continue };
            let size = next.time - past.time;
            self.steps.take_torques(torques, k);
            self.steps.evaluate(past, size, &mut self.record);
            self.steps.recognise(past, next, &self.record, &mut self.spare)?;
            self.steps.pull_back(past, size, &self.record, None, gradient);
            self.steps.give_torques(by_torques, k);
            cost(k, past, &mut gradient.start)?;
        }
        states.first().map_or(Ok(()), |start| self.finish(start, gradient))
    }

    /// No gradient yet, by torques neither, nor what an earlier one has left of torques where its cost has failed.
    fn begin(&mut self, by_torques: &mut [EffortOf<S>]) -> GradientOf<S, R, C, L> {
        const { assert!(!S::Scalar::ROWS, "packs are for rows of linearised steps: gradients are over plain numbers") };
        by_torques.fill(EffortOf::<S>::null());
        self.steps.give_torques(&mut [], 0);
        self.steps.of_memory.set(&self.steps.zero);
        Gradient::none(self.steps.scene.elements(), &self.steps.zero, &self.steps.loads.law)
    }
}
