//! Gradients of runs: one number, computed from a whole run, by everything at once.

mod adaptive;
mod admission;
mod again;
mod assembly;
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
use crate::scalar::Real;
use crate::system::{Dynamics, Elements, MotionOf, RateOf, Runs, System};
pub use checkpoints::Checkpoints;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use course::Course;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(super) use course::Efforts;
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
/// Joints in all of these may be [`Driven`](crate::planar::Driven) by a law that can be lifted: its numbers are parameters, and the time of an
/// event in such a scene has no gradient. Joints may [follow others](crate::planar::Couplings) where nothing is held or closed.
///
/// Joints with modes, [`Coulomb`](crate::planar::Coulomb) and [`HardStops`](crate::planar::HardStops), change these at times that hang on everything:
/// such runs are made by [`course`](Self::course), by explicit rules, and their gradients by [`gradient_past`](Self::gradient_past); torques are held
/// over the run, and nothing acts on bodies. All else here refuses such scenes.
///
/// The ground of a root may [move](crate::planar::Moving), as long as nothing is held and no loop closes: parameters of its motion are not among the
/// derivatives, and are refused where the gradient is asked for along them.
///
/// All else is an error of the compiler that names it.
///
/// # What it costs
///
/// Run and gradient by all initial values, all parameters and the torques of all joints at each step, in runs of the rule without
/// derivatives (`advance`), interleaved, 50 steps; beside it instructions, the same against a run under such torques, and instructions of the
/// plain run a body and stage:
///
/// | chain of rods on pins | x86-64-v3: time | instructions | under torques | plain | x86-64: time | instructions | under torques | plain |
/// |---|---:|---:|---:|---:|---:|---:|---:|---:|
/// | RK4, 2 | 3.0 | 4.2 | 3.8 | 89 | 4.1 | 4.9 | 3.3 | 128 |
/// | RK4, 2 in a tuple | 3.0 | 3.8 | 3.4 | 81 | 3.5 | 4.3 | 3.9 | 135 |
/// | RK4, 20 | 2.8 | 3.6 | 3.4 | 80 | 2.6 | 3.2 | 3.0 | 152 |
/// | RK4, 100 | 2.8 | 3.5 | 3.3 | 75 | 2.5 | 3.0 | 2.9 | 154 |
/// | DOP853, 2 | 3.1 | 4.6 | 4.1 | 87 | 4.0 | 5.2 | 3.5 | 127 |
/// | DOP853, 2 in a tuple | 3.3 | 4.1 | 3.7 | 84 | 3.7 | 4.4 | 4.1 | 141 |
/// | DOP853, 20 | 2.8 | 3.6 | 3.5 | 79 | 2.7 | 3.2 | 3.0 | 157 |
/// | DOP853, 100 | 2.9 | 3.4 | 3.3 | 79 | 2.6 | 3.0 | 2.9 | 168 |
///
/// Beside a sweep a step forms sums of its stages: of few coordinates in registers, by weights that a compiler knows, also on the way back. What
/// is held or closed:
///
/// | in the plane | x86-64-v3: time | instructions | under torques | plain | x86-64: time | instructions | under torques | plain |
/// |---|---:|---:|---:|---:|---:|---:|---:|---:|
/// | 3 rods, tip pinned, RK4 | 3.1 | 4.5 | 3.8 | 217 | 3.6 | 4.5 | 3.9 | 328 |
/// | 20 rods, tip pinned, RK4 | 3.8 | 4.5 | 4.0 | 170 | 3.8 | 4.3 | 3.9 | 294 |
/// | four-bar linkage, RK4 | 4.3 | 4.8 | 4.6 | 470 | 4.0 | 4.7 | 4.6 | 712 |
/// | four-bar linkage, DOP853 | 3.9 | 4.5 | 4.2 | 281 | 3.6 | 4.4 | 4.2 | 427 |
/// | rod and window of four, RK4 | 3.9 | 4.8 | 4.4 | 259 | 3.7 | 4.5 | 4.2 | 411 |
/// | rod and two windows in a row, RK4 | 4.8 | 5.5 | 5.0 | 268 | 4.2 | 5.2 | 4.9 | 414 |
/// | rod and five windows in a row, RK4 | 6.8 | 7.5 | 6.8 | 279 | 5.3 | 6.7 | 6.3 | 441 |
///
/// For each correction of a projection costates walk once for each loop: runs of many windows pay for that. In space:
///
/// | chain | x86-64-v3: time | instructions | under torques | plain | x86-64: time | instructions | under torques | plain |
/// |---|---:|---:|---:|---:|---:|---:|---:|---:|
/// | 3 rods on balls, RK4 | 3.4 | 3.5 | 3.4 | 620 | 3.4 | 3.4 | 3.2 | 941 |
/// | 3 rods on balls, DOP853 | 3.3 | 3.6 | 3.4 | 619 | 3.2 | 3.4 | 3.2 | 969 |
/// | 20 rods on balls, RK4 | 2.9 | 3.4 | 3.2 | 509 | 2.9 | 3.4 | 3.2 | 819 |
/// | 20 rods on balls, DOP853 | 2.9 | 3.4 | 3.2 | 544 | 3.0 | 3.5 | 3.3 | 870 |
/// | 3 rods on balls, tip on a ball, RK4 | 4.1 | 4.3 | 4.0 | 1117 | 6.1 | 4.2 | 4.0 | 1681 |
/// | 20 rods on balls, tip on a ball, RK4 | 3.9 | 4.3 | 4.0 | 946 | 3.8 | 4.3 | 4.2 | 1449 |
/// | rod and window of four on balls, RK4 | 4.2 | 4.3 | 4.2 | 1192 | 4.6 | 4.2 | 4.0 | 1838 |
/// | 3 rigid bodies on balls, RK4 | 3.3 | 3.4 | 3.3 | 782 | 3.5 | 3.5 | 3.3 | 1180 |
/// | 20 rigid bodies on balls, RK4 | 3.3 | 3.5 | 3.3 | 703 | 3.0 | 3.4 | 3.3 | 1120 |
/// | 7 rigid bodies on revolutes, RK4 | 3.5 | 3.8 | 3.7 | 703 | 3.5 | 3.6 | 3.6 | 1110 |
/// | 7 rigid bodies on revolutes, DOP853 | 3.5 | 3.8 | 3.7 | 704 | 3.6 | 3.6 | 3.6 | 1118 |
/// | 7 links on hinges, body axes, RK4 | 3.7 | 4.3 | 4.2 | 361 | 4.1 | 4.3 | 4.2 | 546 |
///
/// Seven rigid bodies on elastic balls take 3.7 (x86-64-v3, time; 2.8 on balls in the same run).
///
/// Past changes of mode, run and gradient take 2.6 to 2.8 plain runs (an arm of four rods whose joints rub and strike, DOP853 to 1e-6 and 1e-9, 37 and
/// 114 changes; x86-64-v3, time): the instants at which modes change are not looked for again.
///
/// A rigid body has thirteen parameters, whose derivatives are found whether somebody reads them or not. Times of a row differ by 0.1
/// from one measurement to the next, by 0.4 at most.
///
/// Under implicit rules rods with stiff hinges, instructions of the plain run a body and sweep; by `GeneralizedAlpha` the steps under
/// torques are those of `step`, with three sweeps instead of two:
///
/// | chain of rods on stiff hinges | x86-64-v3: time | instructions | under torques | plain | x86-64: time | instructions | under torques | plain |
/// |---|---:|---:|---:|---:|---:|---:|---:|---:|
/// | `Sdirk4`, 2 | 4.6 | 7.4 | 6.9 | 122 | 4.8 | 7.5 | 5.4 | 168 |
/// | `Sdirk4`, 20 | 4.2 | 5.1 | 4.9 | 110 | 3.8 | 4.2 | 4.1 | 207 |
/// | `GeneralizedAlpha`, 2 | 5.4 | 9.3 | 7.1 | 156 | 5.3 | 8.7 | 5.1 | 209 |
/// | `GeneralizedAlpha`, 20 | 5.1 | 6.7 | 4.8 | 122 | 4.5 | 5.2 | 3.9 | 233 |
///
/// Sweeps before the last are made a third time on the way back.
///
/// Seven rods on revolutes of which the first is driven take 3.6 plain runs' instructions with their gradient, seven rigid bodies in space 3.8;
/// under a coupling 3.6 and 2.9 of those under it (RK4, x86-64-v3).
///
/// One costate serves any number of derivatives; how the cost depends on their number was not measured. Runs
/// [on a tape](Self::gradient_on_tape) take 1.7 plain runs with their gradient (RK4, n = 20, 50 steps), runs of which
/// [few states](Self::gradient_between) are kept 2.7 (RK4, n = 20, a million steps); in space 1.8 and 2.8 (7 rigid bodies on revolutes, 3000
/// steps). (Times are the least of 400 in the tables, with other work on the other core; of these runs of 2000, of one and of 15.)
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
        EffortOf<S>: Additive,
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
    EffortOf<S>: Additive,
{
    fn new(scene: &'s System<S, R, C, P>, method: M, law: L) -> Self {
        let steps = Steps::new(scene, method, law);
        let scratch = Gradient::none(scene.elements(), &steps.zero);
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
    /// [`Fault::Count`], which says how many states or torques are needed; [`Fault::Shape`] for motions of another scene;
    /// [`Fault::NonFiniteMotion`] or [`Fault::AngleOutOfRange`], with the time; [`Fault::RedundantClosures`] where the start holds its tip,
    /// or closes a loop, twice in the same way; [`Fault::NotAssembled`] where joints that follow others do not; [`Fault::Unsupported`] where the
    /// ground moves, or joints are coupled, and something is held or closed; what is wrong with the parameters of the rule; what
    /// [`LoadLaw::check`](crate::loading::LoadLaw::check) of the loads on bodies refuses.
    pub fn run(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        steps: usize,
        torques: &[EffortOf<S>],
        states: &mut [MotionOf<S, R, C, P>],
    ) -> Result<(), Error> {
        self.admits(steps, torques.len())?;
        let given = states.len();
        let Some(states) = states.get_mut(..=steps) else {
            return Err(Error::new(Fault::Count { expected: steps.saturating_add(1), given }));
        };
        if !(self.fits(start) && states.iter().all(|state| state.fits(start))) {
            return Err(Error::new(Fault::Shape));
        }
        self.independent(start)?;
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
    /// [`Fault::Count`] for lists of another length, [`Fault::Shape`] for motions of another scene; [`Fault::Unsupported`] where a rule that
    /// remembers is given states that are not of its run, with the time; what the loads on bodies refuse, as in [`run`](Self::run); those of
    /// the cost.
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
        by_torques.fill(EffortOf::<S>::null());
        self.steps.give_torques(&mut [], 0);
        self.steps.of_memory.set(&self.steps.zero);
        Gradient::none(self.steps.scene.elements(), &self.steps.zero)
    }
}
