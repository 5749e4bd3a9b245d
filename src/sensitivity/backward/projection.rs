//! The projection at the end of a step of a tip that is held.
//!
//! The end of a step is put back by what the last stage knows of M, Γ and Λ ([`held`](super::held)): two corrections x of positions and one of
//! rates, M x = Γᵀκ with κ = Λ⁻¹ y, y being what the tip misses. With x̄ their costates,
//!
//! ```text
//! M w + Γᵀν = x̄        Γ w = 0        ȳ = ν        of the stage: −∂/∂q (w · M x + ν · Γ x − κ · Γ w)
//! ```
//!
//! which is the costate sweep at rest, x for accelerations, G = ν, F = −κ at the tip, without springs.

use super::held::{Room, add, wrench};
use super::steps::{Record, Steps};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Coordinates, Element, Level, RealOf};
use crate::ends::Resting;
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::relation::{Additive, Closures, Solvable, Wrench};
use crate::sensitivity::Gradient;
use crate::shape::{Positions, Takes};
use crate::stepper::displace::displace;
use crate::stepper::explicit::row_weights;
use crate::system::{Elements, MotionOf};
use crate::time::Explicit;
use crate::walks::look::look;
use crate::walks::pull_back::PullBack;
use crate::walks::pull_loads::PullLoads;
use crate::walks::stir::Stir;
use crate::walks::swept::swept;
use num_traits::Zero;

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

/// −x for each number.
fn opposite<S: Reversed, V: Rate<S::Scalar>>(list: &mut V) {
    list.replace(&mut |x| -x);
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
