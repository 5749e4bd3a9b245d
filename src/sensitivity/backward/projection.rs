//! Tips that are held: the forces that hold them in a stage, and the projection at the end of a step.
//!
//! The accelerations of a stage solve M a + c − τ − Γᵀλ = 0, Γ a + γ = target, and costates the same system with other right-hand sides:
//!
//! ```text
//! M w + Γᵀν = λ_a        Γ w = 0        P = w · R + ν · (Γ a + γ − target)
//! ```
//!
//! so that at the tip the costate sweep begins with G = ν and F = −λ. Both are solved by the elimination of the open chain: Γᵀ is a wrench at
//! the tip, which an inward walk begins with, and Λ = Γ M⁻¹ Γᵀ comes of one for each force. The end of a step is put back by what the last
//! stage knows of M, Γ and Λ: two corrections x of positions and one of rates, M x = Γᵀκ with κ = Λ⁻¹ y, y being what the tip misses. With x̄
//! their costates,
//!
//! ```text
//! M w + Γᵀν = x̄        Γ w = 0        ȳ = ν        of the stage: −∂/∂q (w · M x + ν · Γ x − κ · Γ w)
//! ```
//!
//! which is the costate sweep at rest, x for accelerations, G = ν, F = −κ at the tip, without springs.

use super::steps::{Stage, Steps};
use crate::adjoint::{BodyLaw, Burdened, EachOf, Reversed, Reversible, ReversibleTip};
use crate::element::{Coordinates, Element, Level, RealOf};
use crate::ends::{Resting, Root};
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::relation::{Acceleration, AccelerationOf, Additive, Closures, Solvable, Wrench, WrenchOf};
use crate::sensitivity::Gradient;
use crate::sensitivity::backward::steps::Record;
use crate::shape::{PerAxes, PerBody, PerJoint, Positions, Rates, Takes};
use crate::space::FrameOf;
use crate::stepper::displace::displace;
use crate::stepper::explicit::row_weights;
use crate::system::{Elements, MotionOf, System};
use crate::time::Explicit;
use crate::walks::burden::Burden;
use crate::walks::look::look;
use crate::walks::meet::Meet;
use crate::walks::pull_back::PullBack;
use crate::walks::pull_loads::PullLoads;
use crate::walks::reach::Reach;
use crate::walks::size::sizes;
use crate::walks::stir::Stir;
use crate::walks::swept::swept;
use num_traits::{One, Zero};

/// Corrections of positions; after them one of rates.
const PASSES: usize = 2;

/// The projection at the end of a step.
#[derive(Clone)]
pub(super) struct Projection<S: Reversed, E: Element<S>, X: Closures> {
    /// Positions before each correction, and after the last.
    places: [E::Position; PASSES + 1],
    /// Rates before their correction, and after it.
    missing: E::Rate,
    pub(super) rate: E::Rate,
    /// κ of each correction of positions, and of that of rates.
    forces: [X::Each<S::Scalar>; PASSES + 1],
}

impl<S: Reversed, E: Element<S>, X: Closures> Projection<S, E, X> {
    pub(super) fn new(elements: &E, zero: &E::Rate) -> Self {
        let place = elements.store::<Positions>(());
        let forces = core::array::from_fn(|_| X::each(|_| S::Scalar::zero()));
        let places = core::array::from_fn(|_| place.clone());
        Self { places, missing: zero.clone(), rate: zero.clone(), forces }
    }

    /// Positions after the last correction.
    pub(super) fn place(&self) -> &E::Position {
        &self.places[PASSES]
    }
}

/// Room for walks that find what holds a tip.
pub(super) struct Room<S: Reversed, E: Element<S>> {
    /// A posture besides those of stages.
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    zero: E::Rate,
    /// Costates, and what is solved for.
    pub(super) costates: E::Rate,
    solved: E::Rate,
    correction: E::Rate,
    of_position: E::Rate,
    of_rate: E::Rate,
    /// Costates of the positions of the last stage, by which the end of the step was put back.
    pub(super) of_stage: E::Rate,
    on_bodies: E::Store<PerBody<S::OnBody>>,
    in_joints: E::Store<PerJoint<S::InJoint>>,
    at_bodies: E::Store<PerBody<S::Vector>>,
    at_joints: E::Store<PerJoint<S::Vector>>,
    unloaded: E::Store<PerBody<Loaded<S>>>,
    efforts: E::Store<PerJoint<EffortOf<S>>>,
}

/// Where a body is, and the wrench on it.
type Loaded<S> = (FrameOf<S>, WrenchOf<S>);

/// Σ ν c.
fn wrench<S: Reversed, P: ReversibleTip<S>>(tip: &P, weights: &EachOf<S, P>) -> WrenchOf<S> {
    let mut sum = Wrench::none();
    P::Closures::zip(&tip.columns(), weights, |column, weight| sum = WrenchOf::<S>::plus_scaled(sum, weight, column));
    sum
}

/// c · A for each c.
fn along<S: Reversed, P: ReversibleTip<S>>(tip: &P, acceleration: &AccelerationOf<S>) -> EachOf<S, P> {
    P::Closures::map(&tip.columns(), |column| column.work(acceleration))
}

/// What the costate sweep begins with at a tip weighed by ν and −λ, and what these do to gravity and to the numbers of the tip.
pub(super) fn weigh<S, R, C, P>(
    scene: &System<S, R, C, P>,
    (weight, force): (&EachOf<S, P>, &EachOf<S, P>),
    (reached, still): (AccelerationOf<S>, AccelerationOf<S>),
    stirred: &AccelerationOf<S>,
    gradient: &mut Gradient<S, Elements<S, R, C>>,
) -> S::Pulled
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
{
    let (tip, weights) = (scene.tip(), wrench(scene.tip(), weight));
    // The acceleration demanded of the tip is that of the ground.
    gradient.gravity = gradient.gravity - weights.force;
    let against = Acceleration { linear: reached.linear - still.linear, angular: reached.angular - still.angular };
    add(&mut gradient.tip, tip.of_columns((weight, &against), (force, stirred)));
    P::pulled(weights, wrench(tip, force))
}

/// Adds up.
fn add<T: Additive, const K: usize>(sums: &mut [T; K], more: [T; K]) {
    sums.iter_mut().zip(more).for_each(|(sum, more)| *sum = *sum + more);
}

/// −x for each number.
fn opposite<S: Reversed, V: Rate<S::Scalar>>(list: &mut V) {
    list.replace(&mut |x| -x);
}

impl<S: Reversed, E: Reversible<S>> Room<S, E> {
    pub(super) fn new(elements: &E, ground: FrameOf<S>) -> Self {
        let ((x, y, p, q), (on_body, in_joint)) = (S::blank(), S::untouched());
        let zero = elements.store::<Rates>(());
        Self {
            sizes: sizes(elements),
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
            costates: zero.clone(),
            solved: zero.clone(),
            correction: zero.clone(),
            of_position: zero.clone(),
            of_rate: zero.clone(),
            of_stage: zero.clone(),
            zero,
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            at_bodies: elements.store::<PerBody<_>>(S::Vector::null()),
            at_joints: elements.store::<PerJoint<_>>(S::Vector::null()),
            unloaded: elements.store::<PerBody<_>>((ground, Wrench::none())),
            efforts: elements.store::<PerJoint<_>>(EffortOf::<S>::null()),
        }
    }

    /// Solves M w = λ for the costates in `solved`, less a wrench at the tip; gives W and w of the tip.
    fn stir<P: ReversibleTip<S>>(
        &mut self,
        elements: &E,
        ground: &FrameOf<S>,
        stage: &Stage<S, E, P::Closures>,
        wrench: WrenchOf<S>,
    ) -> AccelerationOf<S> {
        let Stage { x, y, p, q, kept, pivots, .. } = stage;
        let Self { zero, solved, correction, on_bodies, in_joints, efforts, .. } = self;
        elements.take(&mut Meet, wrench, (x, y, p, q, kept, pivots, &mut *solved));
        let stores = (x, y, p, q, kept, (&*zero, &*correction, &mut *solved), (on_bodies, in_joints), efforts);
        P::stirred(&elements.take(&mut Stir, S::at_ground(ground), stores))
    }

    /// Finds λ of a stage whose tip would accelerate by `reached` without, and the accelerations with it.
    pub(super) fn hold<P: ReversibleTip<S>>(
        &mut self,
        (elements, tip): (&E, &P),
        ground: (&FrameOf<S>, AccelerationOf<S>),
        stage: &mut Stage<S, E, P::Closures>,
        acceleration: &mut E::Rate,
    ) where
        E: Takes<S, Burden>,
    {
        stage.compliance = P::Closures::no_pairs();
        for j in 0..P::Closures::COUNT {
            let mut count = 0;
            let unit: EachOf<S, P> = P::Closures::each(|_| {
                count += 1;
                if count == j + 1 { S::Scalar::one() } else { S::Scalar::zero() }
            });
            self.solved.set(&self.zero);
            let yielded = self.stir::<P>(elements, ground.0, stage, -wrench(tip, &unit));
            let minus = P::Closures::map(&along(tip, &yielded), |x| -x);
            stage.compliance = P::Closures::minus_outer(&stage.compliance, &minus, &unit);
        }
        let (demand, free) = (along(tip, &ground.1), along(tip, &stage.reached));
        let demand = P::Closures::zip(&demand, &free, |demand, free| demand - free);
        stage.force = P::Closures::solve(&stage.compliance, &demand);
        let Stage { x, y, p, q, kept, pivots, at_bodies, at_joints, .. } = stage;
        let beyond = -wrench(tip, &stage.force);
        elements.take(&mut Burden, beyond, (x, y, p, q, &self.unloaded, &mut *kept, pivots));
        let stores = (&*x, &*y, &*p, &*q, &*kept, acceleration, (at_bodies, at_joints));
        stage.reached = elements.take(&mut Reach, ground.1, stores);
    }

    /// ν for the costates in the room, and the wrench at the tip with which an inward walk begins.
    pub(super) fn weights<P: ReversibleTip<S>>(
        &mut self,
        (elements, tip): (&E, &P),
        ground: &FrameOf<S>,
        stage: &Stage<S, E, P::Closures>,
    ) -> (WrenchOf<S>, EachOf<S, P>) {
        self.solved.set(&self.costates);
        let yielded = self.stir::<P>(elements, ground, stage, Wrench::none());
        let weights = P::Closures::solve(&stage.compliance, &along(tip, &yielded));
        (wrench(tip, &weights), weights)
    }
}

impl<S, R, C, P, M, L> Steps<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Resting<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S> + Burdened<S, L>,
    EffortOf<S>: Additive,
{
    /// The end of a step, and its projection.
    pub(super) fn project(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &mut Record<S, Elements<S, R, C>, M, P::Closures>,
    ) {
        let (Some(room), Some(projection)) = (&mut self.room, &mut record.projection) else { return };
        let (elements, tip, time) = (self.scene.elements(), self.scene.tip(), past.time + step);
        let (ground, stage) = (self.scene.ground(time), &record.stages.as_ref()[M::STAGES - 1]);
        let (row, slopes) = (M::STAGES, record.accelerations.as_ref());
        let Projection { places, missing, rate, forces } = projection;
        let (of, sums) = ((M::node(row), row_weights::<M>(row)), (&self.zero, &mut self.sum));
        displace(past, slopes, of.0, of.1, step, sums, (&mut places[0], &mut *missing));
        for pass in 0..=PASSES {
            let at = Coordinates { position: &places[pass], rate: &*missing, acceleration: &self.zero };
            let [place, velocity] = tip.residual(time, &look(elements, ground, at));
            let missed = if pass < PASSES { place } else { velocity };
            forces[pass] = P::Closures::solve(&stage.compliance, &missed);
            room.solved.set(&self.zero);
            room.stir::<P>(elements, &ground, stage, -wrench(tip, &forces[pass]));
            opposite::<S, _>(&mut room.solved);
            if let [before, after, ..] = &mut places[pass..] {
                after.clone_from(before);
                after.displace(&room.solved);
            } else {
                rate.set(missing);
                rate.add(&room.solved);
            }
        }
    }

    /// From the costates after the projection of a step to those before it; those of the last stage stay in the room.
    pub(super) fn pull_back_projection(
        &mut self,
        time: RealOf<S>,
        past: &MotionOf<S, R, C, P>,
        record: &Record<S, Elements<S, R, C>, M, P::Closures>,
        gradient: &mut Gradient<S, Elements<S, R, C>>,
    ) {
        let (Some(room), Some(projection)) = (&mut self.room, &record.projection) else { return };
        let (elements, tip, ground) = (self.scene.elements(), self.scene.tip(), self.scene.ground(time));
        let (row, zero) = (M::STAGES - 1, &self.zero);
        let stage = &record.stages.as_ref()[row];
        let position = if row == 0 { &past.position } else { &stage.position };
        room.of_stage.set(zero);
        for (pass, force) in projection.forces.iter().enumerate().rev() {
            let level = if pass < PASSES { Level::Place } else { Level::Velocity };
            // The correction x, and how it moves all stations.
            room.solved.set(zero);
            let moved = room.stir::<P>(elements, &ground, stage, -wrench(tip, force));
            room.correction.set(&room.solved);
            let kept = (&room.on_bodies, &room.in_joints);
            swept::<S, P, _>(elements, kept, &mut room.at_bodies, &mut room.at_joints);
            // w and ν.
            let start = &mut gradient.start;
            room.costates.set(if let Level::Place = level { &start.position } else { &start.rate });
            opposite::<S, _>(&mut room.costates);
            let (beyond, weights) = room.weights((elements, tip), &ground, stage);
            room.solved.set(&room.costates);
            let stirred = room.stir::<P>(elements, &ground, stage, beyond);
            // What the stage's M and Γ change of x.
            let Room { sizes, x, y, p, q, solved, correction, of_position, of_rate, on_bodies, in_joints, .. } = room;
            S::pose(elements, position, zero, ground.turn, sizes, x, y, p, q);
            let pulled = P::pulled(wrench(tip, &weights), wrench(tip, force));
            let reached = (&room.at_bodies, &room.at_joints, &*on_bodies, &*in_joints, &stage.pivots);
            let motion = (position, zero, &*correction, &*solved);
            let sums = (&mut gradient.bodies, &mut gradient.joints);
            let stores = (&*x, &*y, &*p, &*q, motion, reached, sums, (&mut *of_position, of_rate));
            let left = elements.take(&mut PullBack { laws: false }, pulled, stores);
            room.of_stage.add(of_position);
            gradient.ground = gradient.ground + S::of_ground(&left, &ground).1;
            add(&mut gradient.tip, tip.of_columns((&weights, &moved), (force, &stirred)));
            // What the tip misses.
            let (place, rate) = (&projection.places[pass], &projection.missing);
            S::pose(elements, place, rate, ground.turn, sizes, x, y, p, q);
            let at = Coordinates { position: place, rate, acceleration: zero };
            let frame = self.loads.see(elements, ground, at, time);
            solved.set(zero);
            let kept = (&mut *on_bodies, &mut *in_joints);
            let stores = (&*x, &*y, &*p, &*q, &stage.kept, (rate, zero, &mut *solved), kept, &mut room.efforts);
            elements.take(&mut Stir, S::at_ground(&ground), stores);
            let mut walk = PullLoads { law: self.loads.law, time, body: elements.bodies(), of_law: gradient.law };
            let nothing = Wrench::none();
            let felt = if let Level::Place = level { P::felt(beyond, nothing) } else { P::felt(nothing, beyond) };
            let start = (&mut gradient.start.position, &mut gradient.start.rate);
            let seen = (&self.loads.on_bodies, &*on_bodies, &*in_joints);
            let sums = (&mut gradient.numbers, &mut gradient.joints);
            let felt = elements.take(&mut walk, felt, (&*x, &*y, &*p, &*q, (place, rate, &*solved), seen, sums, start));
            gradient.law = walk.of_law;
            let (of_place, turn) = S::of_place(&felt);
            (gradient.place, gradient.ground) = (gradient.place + of_place, gradient.ground + turn);
            add(&mut gradient.tip, tip.of_residual(&weights, &frame, level));
        }
    }
}
