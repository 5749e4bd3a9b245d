//! Gradients of runs: one number, computed from a whole run, by everything at once.
//!
//! Costates go backward through the very steps of the run, those of the [costate sweep](crate::adjoint); from one stage of a step to the
//! one before it they go by the columns of the tableau. With rows i = 0 .. s, of which s is the step itself, and Q, V the costates of
//! positions and rates of a row,
//!
//! ```text
//! λ_j = Σ_{i>j} (h² (A·A)_ij Q_i + h A_ij V_i)      (Q_j, V_j) = pull back λ_j      Q = Σ Q_i      V = Σ V_i + h Σ c_i Q_i
//! ```

use super::gradient::{Costate, Gradient};
use crate::adjoint::{Reversed, Reversible, ReversibleRoot, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, counted};
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::relation::{Additive, Open, Wrench};
use crate::scalar::Real;
use crate::shape::{Kept, PerAxes, PerBody, PerJoint, Positions, Rates, Shape, Takes};
use crate::stepper::displace::{displace, gather};
use crate::system::{Dynamics, Elements, MotionOf, PositionOf, RateOf, Runs, System};
use crate::time::Explicit;
use crate::walks::complete::complete;
use crate::walks::factor::Factor;
use crate::walks::fits::fits;
use crate::walks::measure::gains;
use crate::walks::meet::Meet;
use crate::walks::pull_back::PullBack;
use crate::walks::reach::Reach;
use crate::walks::size::sizes;
use crate::walks::stir::Stir;
use crate::walks::{spread, unspread};
use num_traits::{One, Zero};

/// Most rows that an explicit method has.
const ROWS: usize = 16;

/// What a stage of a step keeps for its costates.
#[derive(Clone)]
struct Stage<S: Reversed, E: Element<S>> {
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    kept: E::Store<Kept<Open>>,
    pivots: E::Store<PerJoint<S::Pivot>>,
    /// Accelerations of the outboard ends of bodies.
    reached: E::Store<PerBody<S::Vector>>,
    rate: E::Rate,
}

/// Runs of a scene by fixed steps of an explicit method, and their gradients.
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
/// let gradient = backward.gradient(0.01, &torques, &states, &mut by_torques, cost)?;
/// println!("{:?} {} {}", gradient.by_position(), gradient.by_gravity().y, by_torques[17]);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// By lengths, masses and inertias, or whatever else a scene is made of: [`Gradient::along`].
///
/// The steps are those of the rule itself with loads held over each step, and the gradient is theirs, exact but for rounding at any size of
/// step. A run goes forward once and keeps its states; the gradient makes each step once more, from the last to the first, and pulls
/// costates back through the gains of its stages. Room for one step is all that is needed besides the states, and nothing is allocated but
/// what the vectors of a scene take: room, once, and the gradient.
///
/// Gradients over many times that it takes a perturbation to grow are exact, and as large as perturbations grow.
///
/// # What it knows
///
/// In the plane `Rod`, `RigidBody`, `PointMass`, `Pin` and `Weld`, in tuples, arrays, vectors and branches, named or not, from a `Pinned` or
/// `Clamped` root that does not move to free tips. All else is an error of the compiler that names it.
///
/// # What it costs
///
/// Run and gradient by all initial values, all parameters and the torques of all joints at each step, in runs of the rule without
/// derivatives (`advance`), interleaved, 50 steps; beside it instructions, the same against a run under such torques, and instructions of the
/// plain run a body and stage:
///
/// | chain of rods on pins | x86-64-v3: time | instructions | under torques | plain | x86-64: time | instructions | under torques | plain |
/// |---|---:|---:|---:|---:|---:|---:|---:|---:|
/// | RK4, 2 | 2.9 | 3.7 | 3.4 | 127 | 2.8 | 3.5 | 3.3 | 185 |
/// | RK4, 20 | 2.7 | 3.4 | 3.3 | 85 | 2.4 | 3.0 | 2.9 | 163 |
/// | RK4, 100 | 2.7 | 3.4 | 3.2 | 74 | 2.4 | 2.9 | 2.8 | 154 |
/// | DOP853, 2 | 2.8 | 3.6 | 3.4 | 148 | 2.9 | 3.5 | 3.3 | 212 |
/// | DOP853, 20 | 2.8 | 3.4 | 3.3 | 94 | 2.5 | 3.0 | 2.9 | 175 |
/// | DOP853, 100 | 2.7 | 3.4 | 3.3 | 78 | 2.4 | 3.0 | 2.9 | 168 |
///
/// One costate serves any number of derivatives; how the cost depends on their number and on the length of runs was not measured. (Two cores shared with other work: times are the least of 400.)
pub struct Backward<'s, S: Reversed, R: Root<S>, C: Element<S>, P, M: Explicit> {
    scene: &'s System<S, R, C, P>,
    sizes: <Elements<S, R, C> as Shape<S>>::Store<PerAxes<S::Size>>,
    stages: M::Rows<Stage<S, Elements<S, R, C>>>,
    position: PositionOf<S, R, C>,
    accelerations: M::Rows<RateOf<S, R, C>>,
    /// Costates of the positions and rates of each row.
    of_position: M::Rows<RateOf<S, R, C>>,
    of_rate: M::Rows<RateOf<S, R, C>>,
    /// Costates of accelerations, and room for sums.
    of_acceleration: RateOf<S, R, C>,
    sum: RateOf<S, R, C>,
    zero: RateOf<S, R, C>,
    on_bodies: <Elements<S, R, C> as Shape<S>>::Store<PerBody<S::OnBody>>,
    in_joints: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<S::InJoint>>,
    torques: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<EffortOf<S>>>,
    of_torques: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<EffortOf<S>>>,
    /// Weights of each row's acceleration in the positions and rates of all rows: columns of the tableau.
    weights: M::Rows<[[f64; ROWS]; 2]>,
}

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Runs by fixed steps of an explicit method, whose gradients go backward.
    ///
    /// See [`sensitivity::Backward`](crate::sensitivity::Backward).
    pub fn backward<M: Explicit>(&self, method: M) -> Backward<'_, S, R, C, P, M>
    where
        R: ReversibleRoot<S>,
        P: ReversibleTip<S>,
        Elements<S, R, C>: Reversible<S>,
        Self: Runs<Unloaded, S, R, C, P>,
        EffortOf<S>: Additive,
    {
        Backward::new(self, method)
    }
}

impl<'s, S, R, C, P, M> Backward<'s, S, R, C, P, M>
where
    S: Reversed,
    R: ReversibleRoot<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit,
    Elements<S, R, C>: Reversible<S>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    EffortOf<S>: Additive,
{
    fn new(scene: &'s System<S, R, C, P>, _: M) -> Self {
        let elements = scene.elements();
        let ((x, y, p, q), zero) = (S::blank(), elements.store::<Rates>(()));
        let stage = Stage {
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
            kept: gains(elements),
            pivots: elements.store::<PerJoint<_>>(S::no_pivot()),
            reached: elements.store::<PerBody<_>>(S::Vector::null()),
            rate: zero.clone(),
        };
        let mut weights = M::rows(&[[0.0; ROWS]; 2]);
        for (column, [position, rate]) in weights.as_mut().iter_mut().enumerate() {
            for row in column + 1..=M::STAGES {
                (position[row], rate[row]) = (M::position(row)[column], M::rate(row)[column]);
            }
        }
        let (on_body, in_joint) = S::untouched();
        let no_torque = EffortOf::<S>::null();
        Self {
            scene,
            sizes: sizes(elements),
            stages: M::rows(&stage),
            position: elements.store::<Positions>(()),
            accelerations: M::rows(&zero),
            of_position: M::rows(&zero),
            of_rate: M::rows(&zero),
            of_acceleration: zero.clone(),
            sum: zero.clone(),
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            torques: elements.store::<PerJoint<_>>(no_torque),
            of_torques: elements.store::<PerJoint<_>>(no_torque),
            zero,
            weights,
        }
    }

    /// Runs `steps` steps of a size (s), and keeps the state before each of them and after the last, with the accelerations in which a
    /// step begins. `torques` are those in all joints (the root's first), held over the first step, then those over the second, and so on;
    /// or none.
    ///
    /// # Errors
    /// [`Fault::Count`], which says how many states or torques are needed; [`Fault::Shape`] for motions of another scene;
    /// [`Fault::NonFiniteMotion`] or [`Fault::AngleOutOfRange`], with the time.
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
            return Err(Error::new(Fault::Count { expected: steps + 1, given }));
        };
        if !(self.fits(start) && states.iter().all(|state| state.fits(start))) {
            return Err(Error::new(Fault::Shape));
        }
        // Copies that allocate nothing.
        states[0].position.drift_0(&start.position, (RealOf::<S>::zero(), &self.zero));
        states[0].rate.set(&start.rate);
        states[0].time = start.time;
        for k in 0..steps {
            let [past, next, ..] = &mut states[k..] else { break };
            self.take_torques(torques, k);
            self.evaluate(past, step);
            past.acceleration.set(&self.accelerations.as_ref()[0]);
            let weights = (&M::position(M::STAGES)[..M::STAGES], &M::rate(M::STAGES)[..M::STAGES]);
            let room = (&self.zero, &mut self.sum);
            let into = (&mut next.position, &mut next.rate);
            displace(past, self.accelerations.as_ref(), M::node(M::STAGES), weights, step, room, into);
            next.time = past.time + step;
            next.acceleration.set(&self.zero);
            Dynamics::<Unloaded>::accept(self.scene, next)?;
        }
        Ok(())
    }

    /// The gradient of a cost by everything, for a run whose states are `states`, from the last to the first: `cost` is told the number of
    /// each of them, and adds the derivatives of the cost by its position and rate. `by_torques`, as long as `torques`, becomes the gradient
    /// by these; it may be empty.
    ///
    /// What a cost reads besides positions and rates, a length for the place of the tip, is not in this gradient.
    ///
    /// # Errors
    /// [`Fault::Count`] for lists of another length, [`Fault::Shape`] for motions of another scene; those of the cost.
    pub fn gradient(
        &mut self,
        step: RealOf<S>,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut Costate<RateOf<S, R, C>>) -> Result<(), Error>,
    ) -> Result<Gradient<S, Elements<S, R, C>>, Error> {
        let elements = self.scene.elements();
        let steps = states.len().saturating_sub(1);
        let Some(last) = states.last() else {
            return Err(Error::new(Fault::Count { expected: 1, given: 0 }));
        };
        self.admits(steps, torques.len())?;
        if !by_torques.is_empty() {
            self.admits(steps, by_torques.len())?;
        }
        if !(self.fits(last) && states.iter().all(|state| state.fits(last))) {
            return Err(Error::new(Fault::Shape));
        }
        let mut gradient = Gradient::none(elements, &self.zero);
        cost(steps, last, &mut gradient.start)?;
        for (k, state) in states.iter().enumerate().take(steps).rev() {
            self.take_torques(torques, k);
            self.evaluate(state, step);
            self.pull_back_step(state, step, &mut gradient);
            let joints = self.scene.joints();
            let list = by_torques.get_mut(k * joints..(k + 1) * joints).unwrap_or_default();
            unspread::from_joints(elements, &mut self.of_torques, EffortOf::<S>::null(), list);
            cost(k, state, &mut gradient.start)?;
        }
        complete::<S, _>(elements, &mut gradient.bodies);
        Ok(gradient)
    }

    /// Whether a motion is one of this scene.
    fn fits(&self, motion: &MotionOf<S, R, C, P>) -> bool {
        fits(self.scene.elements(), &motion.position, &motion.rate)
    }

    /// Refuses lists of torques of another length.
    fn admits(&self, steps: usize, given: usize) -> Result<(), Error> {
        let expected = steps * self.scene.joints();
        if given == 0 { Ok(()) } else { counted(expected, given) }
    }

    /// Takes the torques of a step: none where none are given, whatever an earlier run was given.
    fn take_torques(&mut self, torques: &[EffortOf<S>], step: usize) {
        let (elements, joints) = (self.scene.elements(), self.scene.joints());
        match torques.get(step * joints..(step + 1) * joints) {
            Some(torques) => spread::to_joints(elements, torques, &mut self.torques),
            None => unspread::from_joints(elements, &mut self.torques, EffortOf::<S>::null(), &mut []),
        }
    }

    /// The stages of a step, of which the first is the motion before it.
    fn evaluate(&mut self, past: &MotionOf<S, R, C, P>, step: RealOf<S>) {
        for row in 0..M::STAGES {
            if row > 0 {
                let (weights, room) = ((&M::position(row)[..row], &M::rate(row)[..row]), (&self.zero, &mut self.sum));
                let into = (&mut self.position, &mut self.stages.as_mut()[row].rate);
                displace(past, self.accelerations.as_ref(), M::node(row), weights, step, room, into);
            }
            self.sweep(row, past, past.time + RealOf::<S>::of(M::node(row)) * step);
        }
    }

    /// The sweep of a stage.
    #[inline(never)] // one copy for forward and backward
    fn sweep(&mut self, row: usize, past: &MotionOf<S, R, C, P>, time: RealOf<S>) {
        let (elements, ground) = (self.scene.elements(), self.scene.ground(time));
        let Stage { x, y, p, q, kept, pivots, reached, rate } = &mut self.stages.as_mut()[row];
        let (position, rate) = if row == 0 { (&past.position, &past.rate) } else { (&self.position, &*rate) };
        elements.pose(position, rate, ground.turn, &self.sizes, x, y, p, q);
        elements.take(&mut Factor, S::nothing(), (x, y, p, q, &self.torques, kept, pivots));
        let acceleration = &mut self.accelerations.as_mut()[row];
        elements.take(&mut Reach, ground.falling(self.scene.gravity()), (x, y, p, q, kept, acceleration, reached));
    }

    /// From the costates after a step to those before it: the columns of the tableau, from the last to the first.
    fn pull_back_step(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        gradient: &mut Gradient<S, Elements<S, R, C>>,
    ) {
        let (last, one) = (M::STAGES, RealOf::<S>::one());
        self.of_position.as_mut()[last].set(&gradient.start.position);
        self.of_rate.as_mut()[last].set(&gradient.start.rate);
        for row in (0..last).rev() {
            let [position, rate] = &self.weights.as_ref()[row];
            let later = row + 1..last + 1;
            let of_position = &self.of_position.as_ref()[later.clone()];
            gather(&mut self.sum, &self.zero, step * step, &position[later.clone()], of_position);
            let of_rate = &self.of_rate.as_ref()[later.clone()];
            gather(&mut self.of_acceleration, &self.sum, step, &rate[later], of_rate);
            self.pull_back_stage(row, past, past.time + RealOf::<S>::of(M::node(row)) * step, gradient);
        }
        let (of_position, of_rate) = (&self.of_position.as_ref()[..=last], &self.of_rate.as_ref()[..=last]);
        let mut nodes = [0.0; ROWS];
        nodes.iter_mut().enumerate().take(last + 1).for_each(|(row, node)| *node = M::node(row));
        gather(&mut gradient.start.position, &self.zero, one, &[1.0; ROWS], of_position);
        gather(&mut self.sum, &self.zero, one, &[1.0; ROWS], of_rate);
        gather(&mut gradient.start.rate, &self.sum, step, &nodes, of_position);
    }

    /// From the costates of the accelerations of a stage to those of its positions and rates.
    #[inline(never)]
    fn pull_back_stage(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        time: RealOf<S>,
        gradient: &mut Gradient<S, Elements<S, R, C>>,
    ) {
        let elements = self.scene.elements();
        let Stage { x, y, p, q, kept, pivots, reached, rate } = &self.stages.as_ref()[row];
        let rate = if row == 0 { &past.rate } else { rate };
        let (acceleration, free) = (&self.accelerations.as_ref()[row], &mut self.of_acceleration);
        elements.take(&mut Meet, Wrench::none(), (x, y, p, q, kept, pivots, free));
        let ground = S::at_ground(&self.scene.ground(time));
        let kept_of_them = (&mut self.on_bodies, &mut self.in_joints);
        let stores = (x, y, p, q, kept, (rate, acceleration, &mut *free), kept_of_them, &mut self.of_torques);
        elements.take(&mut Stir, ground, stores);
        let Gradient { bodies, joints, .. } = gradient;
        let start = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
        let kept_of_them = (reached, &self.on_bodies, &self.in_joints);
        let stores = (x, y, p, q, (rate, acceleration, &*free), kept_of_them, (bodies, joints), start);
        let left = elements.take(&mut PullBack, S::Pulled::null(), stores);
        gradient.gravity = gradient.gravity + S::of_gravity(&left);
    }
}
