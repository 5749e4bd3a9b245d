//! Steps of a run, forward with all that their stages keep, and backward.
//!
//! Costates go backward through the very steps of the run, those of the [costate sweep](crate::adjoint); from one stage of a step to the
//! one before it they go by the columns of the tableau. With rows i = 0 .. s, of which s is the step itself, and Q, V the costates of
//! positions and rates of a row,
//!
//! ```text
//! λ_j = Σ_{i>j} (h² (A·A)_ij Q_i + h A_ij V_i)      (Q_j, V_j) = pull back λ_j      Q = Σ Q_i      V = Σ V_i + h Σ c_i Q_i
//! ```
//!
//! Where positions are curved, rules sum up coordinates of the step: then Q, V and λ are the costates of these, of their first and of their
//! second derivatives, from and to which [`Position`] translates, and positions before the step get their share from each row.

use crate::adjoint::{Reversed, Reversible, ReversibleRoot, ReversibleTip};
use crate::element::{Element, RealOf};
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::relation::{Additive, Open, Wrench};
use crate::scalar::Real;
use crate::sensitivity::Gradient;
use crate::shape::{Kept, PerAxes, PerBody, PerJoint, Positions, Rates, Shape, Takes};
use crate::stepper::displace::{displace, gather};
use crate::stepper::explicit::row_weights;
use crate::system::{Elements, MotionOf, PositionOf, RateOf, System};
use crate::time::Explicit;
use crate::walks::factor::Factor;
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
    /// Accelerations of the outboard ends of bodies and joints.
    at_bodies: E::Store<PerBody<S::Vector>>,
    at_joints: E::Store<PerJoint<S::Vector>>,
    position: E::Position,
    rate: E::Rate,
    /// Accelerations, where those of the step's coordinates are others.
    acceleration: E::Rate,
}

/// A step with what its stages keep.
pub(super) struct Record<S: Reversed, E: Element<S>, M: Explicit> {
    stages: M::Rows<Stage<S, E>>,
    accelerations: M::Rows<E::Rate>,
}

impl<S: Reversed, E: Element<S>, M: Explicit> Clone for Record<S, E, M> {
    fn clone(&self) -> Self {
        let (mut stages, mut accelerations) =
            (M::rows(&self.stages.as_ref()[0]), M::rows(&self.accelerations.as_ref()[0]));
        stages.as_mut().clone_from_slice(self.stages.as_ref());
        accelerations.as_mut().clone_from_slice(self.accelerations.as_ref());
        Self { stages, accelerations }
    }
}

impl<S: Reversed, E: Element<S>, M: Explicit> Record<S, E, M> {
    /// Accelerations in which the step begins.
    pub(super) fn first(&self) -> &E::Rate {
        &self.accelerations.as_ref()[0]
    }
}

/// What makes steps and pulls costates back through them.
pub(super) struct Steps<'s, S: Reversed, R: crate::ends::Root<S>, C: Element<S>, P, M: Explicit> {
    pub(super) scene: &'s System<S, R, C, P>,
    sizes: <Elements<S, R, C> as Shape<S>>::Store<PerAxes<S::Size>>,
    /// Torques that are held over the step.
    torques: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<EffortOf<S>>>,
    /// Costates of these.
    of_torques: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<EffortOf<S>>>,
    /// Costates of the positions and rates of each row.
    of_position: M::Rows<<Elements<S, R, C> as Element<S>>::Rate>,
    of_rate: M::Rows<<Elements<S, R, C> as Element<S>>::Rate>,
    /// Costates of accelerations, and room for sums.
    of_acceleration: <Elements<S, R, C> as Element<S>>::Rate,
    /// Costates of second derivatives of the step's coordinates, where positions are curved.
    of_second: <Elements<S, R, C> as Element<S>>::Rate,
    sum: <Elements<S, R, C> as Element<S>>::Rate,
    /// Where the step leads, where positions are curved.
    end: (PositionOf<S, R, C>, RateOf<S, R, C>),
    pub(super) zero: <Elements<S, R, C> as Element<S>>::Rate,
    on_bodies: <Elements<S, R, C> as Shape<S>>::Store<PerBody<S::OnBody>>,
    in_joints: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<S::InJoint>>,
    /// Weights of each row's acceleration in the positions and rates of all rows: columns of the tableau.
    weights: M::Rows<[[f64; ROWS]; 2]>,
    nodes: [f64; ROWS],
}

impl<'s, S, R, C, P, M> Steps<'s, S, R, C, P, M>
where
    S: Reversed,
    R: ReversibleRoot<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit,
    Elements<S, R, C>: Reversible<S>,
    EffortOf<S>: Additive,
{
    const CURVED: bool = <<Elements<S, R, C> as Element<S>>::Position as Position<S::Scalar>>::CURVED;

    pub(super) fn new(scene: &'s System<S, R, C, P>) -> Self {
        let elements = scene.elements();
        let zero = elements.store::<Rates>(());
        let mut weights = M::rows(&[[0.0; ROWS]; 2]);
        for (column, [position, rate]) in weights.as_mut().iter_mut().enumerate() {
            for row in column + 1..=M::STAGES {
                (position[row], rate[row]) = (M::position(row)[column], M::rate(row)[column]);
            }
        }
        let mut nodes = [0.0; ROWS];
        nodes.iter_mut().enumerate().take(M::STAGES + 1).for_each(|(row, node)| *node = M::node(row));
        let (on_body, in_joint) = S::untouched();
        let no_torque = EffortOf::<S>::null();
        Self {
            scene,
            sizes: sizes(elements),
            torques: elements.store::<PerJoint<_>>(no_torque),
            of_torques: elements.store::<PerJoint<_>>(no_torque),
            of_position: M::rows(&zero),
            of_rate: M::rows(&zero),
            of_acceleration: zero.clone(),
            of_second: zero.clone(),
            sum: zero.clone(),
            end: (elements.store::<Positions>(()), zero.clone()),
            zero,
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            weights,
            nodes,
        }
    }

    /// Room for a step.
    pub(super) fn record(&self) -> Record<S, Elements<S, R, C>, M> {
        let elements = self.scene.elements();
        let (x, y, p, q) = S::blank();
        let stage = Stage {
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
            kept: gains(elements),
            pivots: elements.store::<PerJoint<_>>(S::no_pivot()),
            at_bodies: elements.store::<PerBody<_>>(S::Vector::null()),
            at_joints: elements.store::<PerJoint<_>>(S::Vector::null()),
            position: elements.store::<Positions>(()),
            rate: self.zero.clone(),
            acceleration: self.zero.clone(),
        };
        Record { stages: M::rows(&stage), accelerations: M::rows(&self.zero) }
    }

    /// Takes the torques of a step: none where none are given, whatever an earlier run was given.
    pub(super) fn take_torques(&mut self, torques: &[EffortOf<S>], step: usize) {
        let (elements, joints) = (self.scene.elements(), self.scene.joints());
        let first = if torques.len() == joints { 0 } else { step * joints };
        match torques.get(first..first + joints) {
            Some(torques) => spread::to_joints(elements, torques, &mut self.torques),
            None => unspread::from_joints(elements, &mut self.torques, EffortOf::<S>::null(), &mut []),
        }
    }

    /// Gives the costates of the torques of a step, and forgets them; if they are held over all steps, once they are complete.
    pub(super) fn give_torques(&mut self, by_torques: &mut [EffortOf<S>], step: usize) {
        let joints = self.scene.joints();
        if by_torques.len() == joints && step > 0 {
            return;
        }
        let list = by_torques.get_mut(step * joints..(step + 1) * joints).unwrap_or_default();
        unspread::from_joints(self.scene.elements(), &mut self.of_torques, EffortOf::<S>::null(), list);
    }

    /// The stages of a step, of which the first is the motion before it.
    pub(super) fn evaluate(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &mut Record<S, Elements<S, R, C>, M>,
    ) {
        for row in 0..M::STAGES {
            if row > 0 {
                let Stage { position, rate, .. } = &mut record.stages.as_mut()[row];
                let room = (&self.zero, &mut self.sum);
                let slopes = record.accelerations.as_ref();
                displace(past, slopes, M::node(row), row_weights::<M>(row), step, room, (&mut *position, &mut *rate));
                if Self::CURVED {
                    position.retract_rate(&past.position, rate);
                }
            }
            self.sweep(row, past, past.time + RealOf::<S>::of(M::node(row)) * step, record);
            if Self::CURVED && row > 0 {
                let Stage { position, rate, acceleration, .. } = &mut record.stages.as_mut()[row];
                let slope = &mut record.accelerations.as_mut()[row];
                acceleration.set(slope);
                position.inverse_retract_acceleration(&past.position, rate, slope);
            }
        }
    }

    /// The step to a time, from the past motion to the next, which has no accelerations.
    pub(super) fn step_to(
        &mut self,
        time: RealOf<S>,
        past: &MotionOf<S, R, C, P>,
        record: &mut Record<S, Elements<S, R, C>, M>,
        next: &mut MotionOf<S, R, C, P>,
    ) {
        let step = time - past.time;
        self.evaluate(past, step, record);
        let (row, room) = (M::STAGES, (&self.zero, &mut self.sum));
        let into = (&mut next.position, &mut next.rate);
        displace(past, record.accelerations.as_ref(), M::node(row), row_weights::<M>(row), step, room, into);
        if Self::CURVED {
            next.position.retract_rate(&past.position, &mut next.rate);
        }
        next.acceleration.set(&self.zero);
        next.time = time;
    }

    /// The sweep of a stage.
    #[inline(never)] // one copy for forward and backward
    fn sweep(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        time: RealOf<S>,
        record: &mut Record<S, Elements<S, R, C>, M>,
    ) {
        let (elements, ground) = (self.scene.elements(), self.scene.ground(time));
        let Stage { x, y, p, q, kept, pivots, at_bodies, at_joints, position, rate, .. } =
            &mut record.stages.as_mut()[row];
        let (position, rate) = if row == 0 { (&past.position, &past.rate) } else { (&*position, &*rate) };
        S::pose(elements, position, rate, ground.turn, &self.sizes, x, y, p, q);
        elements.take(&mut Factor, S::nothing(), (x, y, p, q, (position, rate), &self.torques, kept, pivots));
        let acceleration = &mut record.accelerations.as_mut()[row];
        let falling = ground.falling(self.scene.gravity());
        elements.take(&mut Reach, falling, (x, y, p, q, kept, acceleration, (at_bodies, at_joints)));
    }

    /// From the costates after a step to those before it: the columns of the tableau, from the last to the first.
    pub(super) fn pull_back(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &Record<S, Elements<S, R, C>, M>,
        gradient: &mut Gradient<S, Elements<S, R, C>>,
    ) {
        let (last, one) = (M::STAGES, RealOf::<S>::one());
        self.of_position.as_mut()[last].set(&gradient.start.position);
        self.of_rate.as_mut()[last].set(&gradient.start.rate);
        if Self::CURVED {
            let (room, (position, rate)) = ((&self.zero, &mut self.sum), &mut self.end);
            let slopes = record.accelerations.as_ref();
            displace(past, slopes, M::node(last), row_weights::<M>(last), step, room, (&mut *position, &mut *rate));
            position.retract_rate(&past.position, rate);
            gradient.start.position.set(&self.zero);
            let of_end = (&mut self.of_position.as_mut()[last], &mut self.of_rate.as_mut()[last]);
            let of_past = &mut gradient.start.position;
            position.transposed_step(&past.position, (rate, &self.zero), &self.zero, of_end, of_past);
        }
        for row in (0..last).rev() {
            let [position, rate] = &self.weights.as_ref()[row];
            let later = row + 1..last + 1;
            let of_position = &self.of_position.as_ref()[later.clone()];
            gather(&mut self.sum, &self.zero, step * step, &position[later.clone()], of_position);
            let of_rate = &self.of_rate.as_ref()[later.clone()];
            gather(&mut self.of_acceleration, &self.sum, step, &rate[later], of_rate);
            let Stage { position, rate, acceleration, .. } = &record.stages.as_ref()[row];
            let curved = Self::CURVED && row > 0; // the first stage has turned by nothing
            if curved {
                self.of_second.set(&self.of_acceleration);
                position.transposed_acceleration(&past.position, &mut self.of_acceleration);
            }
            self.pull_back_stage(row, past, past.time + RealOf::<S>::of(M::node(row)) * step, record, gradient);
            let (of_position, of_rate) = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
            let of_past = &mut gradient.start.position;
            if curved {
                let (here, of_here) = ((rate, acceleration), (of_position, of_rate));
                position.transposed_step(&past.position, here, &self.of_second, of_here, of_past);
            } else if Self::CURVED {
                of_past.add(of_position);
            }
        }
        let (of_position, of_rate) = (&self.of_position.as_ref()[..=last], &self.of_rate.as_ref()[..=last]);
        if !Self::CURVED {
            gather(&mut gradient.start.position, &self.zero, one, &[1.0; ROWS], of_position);
        }
        gather(&mut self.sum, &self.zero, one, &[1.0; ROWS], of_rate);
        gather(&mut gradient.start.rate, &self.sum, step, &self.nodes, of_position);
    }

    /// The costate of the size of a step through which costates were pulled back.
    pub(super) fn of_size(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &Record<S, Elements<S, R, C>, M>,
    ) -> S::Scalar {
        let (one, slopes) = (RealOf::<S>::one(), record.accelerations.as_ref());
        let mut sum = S::Scalar::zero();
        for row in 0..=M::STAGES {
            let (position, rate) = row_weights::<M>(row);
            let (of_position, of_rate) = (&self.of_position.as_ref()[row], &self.of_rate.as_ref()[row]);
            let mut add = |costate: S::Scalar, slope| {
                sum += costate * slope;
                true
            };
            self.of_acceleration.mix_1(&self.zero, (RealOf::<S>::of(M::node(row)), &past.rate));
            gather(&mut self.sum, &self.of_acceleration, step + step, position, slopes);
            of_position.all(&self.sum, &mut add);
            gather(&mut self.sum, &self.zero, one, rate, slopes);
            of_rate.all(&self.sum, &mut add);
        }
        sum
    }

    /// From the costates of the accelerations of a stage to those of its positions and rates.
    #[inline(never)]
    fn pull_back_stage(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        time: RealOf<S>,
        record: &Record<S, Elements<S, R, C>, M>,
        gradient: &mut Gradient<S, Elements<S, R, C>>,
    ) {
        let elements = self.scene.elements();
        let Stage { x, y, p, q, kept, pivots, at_bodies, at_joints, position, rate, acceleration } =
            &record.stages.as_ref()[row];
        let (position, rate) = if row == 0 { (&past.position, &past.rate) } else { (position, rate) };
        let slope = &record.accelerations.as_ref()[row];
        let acceleration = if Self::CURVED && row > 0 { acceleration } else { slope };
        let free = &mut self.of_acceleration;
        elements.take(&mut Meet, Wrench::none(), (x, y, p, q, kept, pivots, free));
        let frame = self.scene.ground(time);
        let kept_of_them = (&mut self.on_bodies, &mut self.in_joints);
        let stores = (x, y, p, q, kept, (rate, acceleration, &mut *free), kept_of_them, &mut self.of_torques);
        elements.take(&mut Stir, S::at_ground(&frame), stores);
        let Gradient { bodies, joints, .. } = gradient;
        let start = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
        let kept_of_them = (at_bodies, at_joints, &self.on_bodies, &self.in_joints, pivots);
        let stores = (x, y, p, q, (position, rate, acceleration, &*free), kept_of_them, (bodies, joints), start);
        let left = elements.take(&mut PullBack, S::Pulled::null(), stores);
        let (gravity, turn) = S::of_ground(&left, &frame);
        (gradient.gravity, gradient.ground) = (gradient.gravity + gravity, gradient.ground + turn);
    }
}
