//! Steps of a run with all that their stages keep for costates.

use super::again::{Again, AgainOf};
use super::apart::Apart;
use super::held::{Room, unturned};
use super::loads::Seen;
use super::projection::Projection;
use super::record::{Place, Record, RecordOf, Stage, StageOf};
use super::rules::Staged;
use super::tied::Tying;
use crate::adjoint::{BodyLaw, Burdened, Outboard, Reversed, Reversible, ReversibleTip};
use crate::element::{Coordinates, Element, Posture, RealOf};
use crate::ends::{Root, Tip};
use crate::loading::EffortOf;
use crate::mirror::{Rate, Retraction};
use crate::relation::{Additive, Closures, Cuts, Solvable, Wrench};
use crate::scalar::Real;
use crate::shape::{PerAxes, PerBody, PerClosure, PerJoint, PerLoop, Positions, Rates, Shape, Takes};
use crate::stepper::displace::{are_few, displace, displace_by_row, with_row};
use crate::system::{Elements, MotionOf, PositionOf, RateOf, System};
use crate::walks::missed::Turns;
use crate::walks::size::sizes;
use crate::walks::{Burden, Factor, Meet, Reach};
use crate::walks::{spread, unspread};
use num_traits::Zero;

/// Most rows that an explicit method has.
pub(super) const ROWS: usize = 16;

/// What puts the geometry of a sweep back.
type ProjectionOf<S, R, C> = Apart<Projection<S, Elements<S, R, C>>>;
/// A torque, or its costate, for each joint.
pub(super) type TorquesOf<S, R, C> = <Elements<S, R, C> as Shape<S>>::Store<PerJoint<EffortOf<S>>>;

/// What makes steps and pulls costates back through them.
pub(super) struct Steps<'s, S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Staged, L: BodyLaw<S>> {
    /// What acts on bodies.
    pub(super) loads: Seen<S, Elements<S, R, C>, L>,
    pub(super) scene: &'s System<S, R, C, P>,
    pub(super) rule: M,
    pub(super) sizes: <Elements<S, R, C> as Shape<S>>::Store<PerAxes<S::Size>>,
    /// Torques that are held over the step.
    pub(super) torques: TorquesOf<S, R, C>,
    /// Costates of these.
    pub(super) of_torques: TorquesOf<S, R, C>,
    /// Costates of the positions and rates of each row.
    pub(super) of_position: M::Rows<<Elements<S, R, C> as Element<S>>::Rate>,
    pub(super) of_rate: M::Rows<<Elements<S, R, C> as Element<S>>::Rate>,
    /// Costates of accelerations, and room for sums.
    pub(super) of_acceleration: <Elements<S, R, C> as Element<S>>::Rate,
    /// Costates of second derivatives of the step's coordinates, where positions are curved.
    pub(super) of_second: <Elements<S, R, C> as Element<S>>::Rate,
    pub(super) sum: <Elements<S, R, C> as Element<S>>::Rate,
    /// Where the step leads, where positions are curved.
    pub(super) end: (PositionOf<S, R, C>, RateOf<S, R, C>),
    pub(super) zero: <Elements<S, R, C> as Element<S>>::Rate,
    /// The costate of the step's size by what stages of an implicit rule do of their own, where it is asked for.
    pub(super) of_own: Option<S::Scalar>,
    /// The costate of what the rule remembers.
    pub(super) of_memory: <Elements<S, R, C> as Element<S>>::Rate,
    /// What puts the geometry of a sweep back where something is held or closed, if a rule does.
    pub(super) between: Option<ProjectionOf<S, R, C>>,
    /// Room for the sweeps of a stage of an implicit rule.
    pub(super) again: Option<AgainOf<S, R, C, P, L>>,
    /// Room for couplings of joints, if there are any.
    pub(super) tying: Option<Tying<S, R, C>>,
    pub(super) on_bodies: <Elements<S, R, C> as Shape<S>>::Store<PerBody<S::OnBody>>,
    pub(super) in_joints: <Elements<S, R, C> as Shape<S>>::Store<PerJoint<S::InJoint>>,
    /// −ν of loops, how their ends move, and nothing of them.
    pub(super) in_loops: <Elements<S, R, C> as Shape<S>>::Store<PerClosure>,
    pub(super) at_ends: <Elements<S, R, C> as Shape<S>>::Store<PerLoop<S::AtEnds>>,
    pub(super) no_loops: <Elements<S, R, C> as Shape<S>>::Store<PerClosure>,
    /// Turns of ends of loops, where nothing reads them.
    pub(super) no_turns: <Elements<S, R, C> as Shape<S>>::Store<Turns<S>>,
    /// Weights of each row's acceleration in the positions and rates of all rows: columns of the tableau.
    pub(super) weights: M::Rows<[[f64; ROWS]; 2]>,
    pub(super) nodes: [f64; ROWS],
    /// Room for what holds the tip and closes loops.
    pub(super) room: Option<Room<S, Elements<S, R, C>>>,
}

impl<'s, S, R, C, P, M, L> Steps<'s, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
{
    /// Whether the tip is held.
    pub(super) const HELD: bool = P::Closures::COUNT > 0;
    /// Whether there are loops.
    pub(super) const LOOPED: bool = System::<S, R, C, P>::LOOPED;
    /// Whether corrections go on until they are rounding.
    pub(super) const SETTLES: bool = Self::LOOPED || Self::TIED;
    /// How deep closures are nested.
    pub(super) const CLOSED: usize = System::<S, R, C, P>::CLOSED;
    /// Whether sums are formed in registers, row by row.
    pub(super) const FEW: bool = are_few::<S::Scalar, RateOf<S, R, C>>();
    pub(super) const CURVED: bool = <PositionOf<S, R, C> as Retraction<S::Scalar>>::CURVED;

    pub(super) fn new(scene: &'s System<S, R, C, P>, rule: M, law: L) -> Self {
        let elements = scene.elements();
        let zero = elements.store::<Rates>(());
        let mut weights = M::rows(&[[0.0; ROWS]; 2]);
        for (column, [position, rate]) in weights.as_mut().iter_mut().enumerate() {
            for row in column + 1..=M::STAGES {
                let (of_position, of_rate) = M::weights(row);
                (position[row], rate[row]) = (of_position[column], of_rate[column]);
            }
        }
        let mut nodes = [0.0; ROWS];
        nodes.iter_mut().enumerate().take(M::STAGES + 1).for_each(|(row, node)| *node = M::node(row));
        let (on_body, in_joint, at_ends) = S::untouched();
        let no_torque = EffortOf::<S>::null();
        Self {
            loads: Seen::new(elements, law, scene.ground(RealOf::<S>::zero())),
            scene,
            rule,
            sizes: sizes(elements),
            torques: elements.store::<PerJoint<_>>(no_torque),
            of_torques: elements.store::<PerJoint<_>>(no_torque),
            of_position: M::rows(&zero),
            of_rate: M::rows(&zero),
            of_acceleration: zero.clone(),
            of_second: zero.clone(),
            end: (elements.store::<Positions>(()), zero.clone()),
            of_own: None,
            of_memory: zero.clone(),
            between: Self::RESTORED.then(|| Apart::new(Projection::new(elements, &zero))),
            again: M::IMPLICIT.then(|| Apart::new(Again::new(elements, &zero))),
            tying: Self::TIED.then(|| (elements.store::<PerJoint<_>>(no_torque), zero.clone())),
            sum: zero.clone(),
            zero,
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            in_loops: elements.store::<PerClosure>(()),
            at_ends: elements.store::<PerLoop<_>>(at_ends),
            no_loops: elements.store::<PerClosure>(()),
            no_turns: unturned::<S, _>(elements),
            weights,
            nodes,
            room: (Self::CLOSED > 0).then(|| Room::new(elements)),
        }
    }

    /// Room for a step.
    pub(super) fn record(&self) -> RecordOf<S, R, C, P, M, L> {
        let elements = self.scene.elements();
        let stage = Stage::new(elements, &self.zero);
        let projection = (Self::CLOSED > 0).then(|| Projection::new(elements, &self.zero));
        Record { stages: M::stages(&stage), accelerations: M::rows(&self.zero), projection }
    }

    /// Takes the torques of a step: none where none are given, whatever an earlier run was given.
    pub(super) fn take_torques(&mut self, torques: &[EffortOf<S>], step: usize) {
        let (elements, joints) = (self.scene.elements(), self.scene.joints());
        let first = if torques.len() == joints { 0 } else { step * joints };
        match torques.get(first..first + joints) {
            Some(torques) => spread::to_joints(elements, torques, |x| x, &mut self.torques),
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

    /// Positions and rates of a row, by the accelerations before it, as [`displace`] finds them.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn displace(
        row: usize,
        past: &MotionOf<S, R, C, P>,
        slopes: &[RateOf<S, R, C>],
        step: RealOf<S>,
        room: (&RateOf<S, R, C>, &mut RateOf<S, R, C>),
        into: (&mut PositionOf<S, R, C>, &mut RateOf<S, R, C>),
    ) {
        if const { Self::FEW } {
            with_row!(row, M::STAGES, |row| {
                displace_by_row(past, slopes, M::node(row), M::weights(row), step, room, into)
            });
        } else {
            displace(past, slopes, M::node(row), M::weights(row), step, room, into);
        }
    }

    /// The stages of a step, of which the first is the motion before it.
    pub(super) fn evaluate(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &mut RecordOf<S, R, C, P, M, L>,
    ) {
        for row in 0..M::STAGES {
            if M::IMPLICIT && !(M::REMEMBERS && row == 0) {
                self.solve(row, past, step, record);
                continue;
            }
            if row > 0 {
                let Stage { position, rate, .. } = &mut record.stages.as_mut()[row];
                let slopes = record.accelerations.as_ref();
                let (room, into) = ((&self.zero, &mut self.sum), (&mut *position, &mut *rate));
                Self::displace(row, past, slopes, step, room, into);
                if Self::CURVED {
                    position.retract_rate(&past.position, rate);
                }
            }
            let time = past.time + RealOf::<S>::of(M::node(row)) * step;
            let (stage, slope) = (&mut record.stages.as_mut()[row], &mut record.accelerations.as_mut()[row]);
            let springs = self.rule.springs::<S::Scalar>(row, step);
            self.sweep((row == 0).then_some(past), None, springs, time, stage, slope);
            if Self::CURVED && row > 0 {
                let Stage { position, rate, acceleration, .. } = &mut record.stages.as_mut()[row];
                let slope = &mut record.accelerations.as_mut()[row];
                acceleration.set(slope);
                position.inverse_retract_acceleration(&past.position, rate, slope);
            }
        }
        if const { Self::CLOSED > 0 } {
            self.end_projected(past, step, record);
        }
    }

    /// The step to a time, from the past motion to the next, which has no accelerations but what a rule remembers.
    pub(super) fn step_to(
        &mut self,
        time: RealOf<S>,
        past: &MotionOf<S, R, C, P>,
        record: &mut RecordOf<S, R, C, P, M, L>,
        next: &mut MotionOf<S, R, C, P>,
    ) {
        self.step_by(time - past.time, past, record, next);
        next.time = time;
    }

    /// The step of a size (s), whatever the clock makes of it.
    pub(super) fn step_by(
        &mut self,
        step: RealOf<S>,
        past: &MotionOf<S, R, C, P>,
        record: &mut RecordOf<S, R, C, P, M, L>,
        next: &mut MotionOf<S, R, C, P>,
    ) {
        self.evaluate(past, step, record);
        next.acceleration.set(&self.zero);
        next.time = past.time + step;
        if const { M::REMEMBERS } {
            self.end_with_memory(past, step, record, next);
            return;
        }
        if let Some(projection) = &record.projection {
            next.position.clone_from(projection.place());
            next.rate.set(projection.rate());
            return;
        }
        let (row, room) = (M::STAGES, (&self.zero, &mut self.sum));
        let into = (&mut next.position, &mut next.rate);
        Self::displace(row, past, record.accelerations.as_ref(), step, room, into);
        if Self::CURVED {
            next.position.retract_rate(&past.position, &mut next.rate);
        }
    }

    /// The sweep of a stage, at the start of a step or where the stage stands, with springs there, or where they are free; laws that are not
    /// linear then where the stage stands, or where they are free, too, by the acceleration that led there.
    #[inline(never)] // one copy for forward and backward
    #[allow(clippy::type_complexity)] // three in one argument
    pub(super) fn sweep(
        &mut self,
        start: Option<&MotionOf<S, R, C, P>>,
        free: Option<(&Place<S, R, C>, &RateOf<S, R, C>, bool)>,
        springs: M::Springs<S::Scalar>,
        time: RealOf<S>,
        stage: &mut StageOf<S, R, C, P, L>,
        acceleration: &mut RateOf<S, R, C>,
    ) {
        self.sweep_under(false, start, free, springs, time, stage, acceleration);
        if const { Self::TIED } {
            self.tie(start, time, stage, acceleration);
            self.sweep_under(true, start, free, springs, time, stage, acceleration);
        }
    }

    /// A sweep without the forces of couplings, or, once more, with them.
    #[inline(always)]
    #[allow(clippy::type_complexity, clippy::too_many_arguments)] // those of the sweep
    fn sweep_under(
        &mut self,
        tied: bool,
        start: Option<&MotionOf<S, R, C, P>>,
        free: Option<(&Place<S, R, C>, &RateOf<S, R, C>, bool)>,
        springs: M::Springs<S::Scalar>,
        time: RealOf<S>,
        stage: &mut StageOf<S, R, C, P, L>,
        acceleration: &mut RateOf<S, R, C>,
    ) {
        let (elements, ground) = (self.scene.elements(), self.scene.ground(time));
        let Stage { x, y, p, q, kept, pivots, at_bodies, at_joints, in_loops, position, rate, .. } = stage;
        let (position, rate) = start.map_or((&*position, &*rate), |past| (&past.position, &past.rate));
        if !tied {
            S::pose(elements, position, rate, ground.turn, &self.sizes, x, y, p, q);
        }
        let torques = self.tying.as_ref().filter(|_| tied).map_or(&self.torques, |(efforts, _)| efforts);
        let falling = ground.falling(self.scene.gravity());
        let still = self.scene.tip().ground(time).falling(self.scene.gravity());
        let beyond = Outboard::held(P::KIND, self.scene.tip().columns(), &still);
        let motion = match free {
            Some(((place, speed), led, true)) => (place, speed, (place, speed, led)),
            Some(((place, speed), led, false)) => (place, speed, (position, rate, led)),
            None => (position, rate, (position, rate, &self.zero)),
        };
        let chain = elements.take(&mut Factor::by(springs), beyond, (x, y, p, q, motion, torques, &mut *kept, pivots));
        let mut burden = Burden(Meet::nothing());
        if const { L::ON } {
            let motion = Coordinates { position, rate, acceleration: &self.zero };
            if !tied {
                self.loads.see(elements, ground, Posture { x, y, p, q }, motion, time);
            }
            elements.take(&mut burden, Wrench::none(), (x, y, p, q, &self.loads.on_bodies, &mut *kept, pivots));
        }
        let Cuts { columns, compliance, gap } = chain.relation.cuts;
        let demand = P::Closures::zip(&columns, &gap, |column, gap| column.work(&falling) - gap);
        let demand = P::Closures::zip(&demand, &burden.0.gaps, |demand, gap| demand - gap);
        (stage.compliance, stage.force) = (compliance, P::Closures::solve(&compliance, &demand));
        let mut walk = Reach { forces: stage.force };
        stage.reached =
            elements.take(&mut walk, falling, (x, y, p, q, &*kept, acceleration, (at_bodies, at_joints, in_loops)));
    }
}
