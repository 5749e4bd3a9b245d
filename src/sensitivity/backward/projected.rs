//! Costates, back through the [projection](super::projection) at the end of a step.
//!
//! The end of a step is put back by what the last stage knows of M, Γ and Λ ([`held`](super::held)): corrections x of positions, and then of
//! rates, M x = Γᵀκ with κ = Λ⁻¹ y, y being what the tip misses. With x̄ their costates,
//!
//! ```text
//! M w + Γᵀν = x̄        Γ w = 0        ȳ = ν        of the stage: −∂/∂q (w · M x + ν · Γ x − κ · Γ w)
//! ```
//!
//! which is the costate sweep at rest, x for accelerations, G = ν, F = −κ at the tip, without springs. A loop closes without moving the
//! station where it begins, so each has a system of its own, of what moves with it: M and Γ of its arms and of all that lies outboard, where
//! other loops stay closed. Couplings add a correction of the whole scene ([`Ties`](crate::adjoint::Ties)). Corrections are as many as a stepper makes,
//! and costates go back through each. Where positions are curved a correction is a step from the place before it. Under an implicit rule M is
//! that of its last sweep, with springs and dampers: by these, and by the size of the step, −w · W x has derivatives, too.

use super::GradientOf;
use super::held::{Posed, Room, add, opposite};
use super::metric::metric;
use super::projection::Projection;
use super::record::{Place, StageOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, EachOf, Reversed, Reversible, ReversibleTip, total};
use crate::element::{Coordinates, Element, Level, Posture, RealOf};
use crate::ends::Root;
use crate::mirror::{Position, Rate, Retraction};
use crate::relation::{AccelerationOf, Additive, Closures, Solvable};
use crate::shape::Takes;
use crate::system::{Elements, PositionOf, RateOf};
use crate::walks::missed::missed;
use crate::walks::singled::{self, Left, single};
use crate::walks::swept::swept;
use crate::walks::{PullBack, Stir};
use num_traits::Zero;

impl<S, R, C, P, M, L> Steps<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
{
    /// From the costates after a projection to those before it, in a step (s) at a time; those of the stage, which stood at a place, and those
    /// of where it was free, if laws were read there, stay in the room.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn pull_back_projection(
        &mut self,
        clock: (RealOf<S>, RealOf<S>),
        stage: (&StageOf<S, R, C, P, L>, &PositionOf<S, R, C>, Option<&Place<S, R, C>>),
        projection: &Projection<S, Elements<S, R, C>>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let Some(room) = &mut self.room else { return };
        // All corrections are by the stage as it stands at rest.
        let Room { sizes, rest: Posed { x, y, p, q }, still, .. } = &mut *room;
        still.clone_from(stage.1);
        still.stop_clocks();
        let ground = self.scene.ground(clock.0).at_rest();
        S::pose(self.scene.elements(), still, &self.zero, ground.turn, sizes, x, y, p, q);
        room.of_stage.set(&self.zero);
        room.of_speed.set(&self.zero);
        if Self::STAYS {
            room.of_free.0.set(&self.zero);
            room.of_free.1.set(&self.zero);
        }
        let Projection { places, moves, rates, changes } = projection;
        for rate in rates[..*changes].iter().rev() {
            let Some(room) = &mut self.room else { continue };
            room.costates.set(&gradient.start.rate);
            self.pull_back_correction(Level::Velocity, (&places[*moves], rate), clock, stage, gradient);
        }
        for pair in places[..=*moves].windows(2).rev() {
            let ([place, moved], Some(room)) = (pair, &mut self.room) else { continue };
            room.costates.set(&gradient.start.position);
            if Self::CURVED {
                // The correction is a step, and the place after it turns with the one before it.
                room.of_rate.set(&self.zero);
                gradient.start.position.set(&self.zero);
                let (still, of_step) = ((&self.zero, &self.zero), (&mut room.costates, &mut room.of_rate));
                moved.transposed_step(place, still, &self.zero, of_step, &mut gradient.start.position);
            }
            self.pull_back_correction(Level::Place, (place, &rates[0]), clock, stage, gradient);
        }
    }

    /// From the costates of a correction, which are in the room, to those of what it depends on.
    #[allow(clippy::type_complexity)] // two in one argument
    fn pull_back_correction(
        &mut self,
        level: Level,
        (place, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        (time, step): (RealOf<S>, RealOf<S>),
        (stage, position, free): (&StageOf<S, R, C, P, L>, &PositionOf<S, R, C>, Option<&Place<S, R, C>>),
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let Some(room) = &mut self.room else { return };
        let (elements, tip, ground) = (self.scene.elements(), self.scene.tip(), self.scene.ground(time));
        // What is missed, and costates of the correction that takes it away.
        let at = Coordinates { position: place, rate, acceleration: &self.zero };
        let Room { sizes, before: Posed { x, y, p, q }, .. } = &mut *room;
        S::pose(elements, place, rate, ground.turn, sizes, x, y, p, q);
        let frame = self.loads.see(elements, ground, Posture { x, y, p, q }, at, time);
        if Self::LOOPED {
            missed(elements, ground, at, level, &mut room.missed, &mut room.turns);
        }
        let [of_place, of_rate] = tip.residual(time, &frame);
        let residual = if let Level::Place = level { of_place } else { of_rate };
        if const { Self::TIED } {
            self.pull_back_ties(level, (place, rate), (time, step), (stage, position, free), gradient);
        }
        let Some(room) = &mut self.room else { return };
        room.costates.replace(&mut |x| -x);
        let held = room.meet::<P, _>(elements, stage);
        room.weights.clone_from(&room.nothing);
        let none: EachOf<S, P> = P::Closures::each(|_| S::Scalar::zero());
        let (mut weights, resting, loops) = (none, ground.at_rest(), room.loops);
        // The tip, and loop by loop.
        for closure in usize::from(!Self::HELD)..=loops {
            let Some(room) = &mut self.room else { return };
            let number = closure.checked_sub(1);
            room.solved.set(&self.zero);
            room.forces.clone_from(&room.missed);
            let mut force = none;
            if let Some(number) = number {
                single::<S, _>(elements, number, Left::Own, &mut room.solved, &mut room.forces);
            } else {
                room.forces.clone_from(&room.nothing);
                force = P::Closures::solve(&stage.compliance, &residual);
            }
            // The correction x, and how it moves all stations.
            let moved = room.stir::<P, _>(elements, &resting, stage, force, false);
            room.correction.set(&room.solved);
            let kept = (&room.on_bodies, &room.in_joints);
            swept::<S, _>(elements, kept, &mut room.at_bodies, &mut room.at_joints);
            // w and ν.
            room.solved.set(&room.costates);
            room.of_forces.clone_from(&room.parted);
            let mut minus_weight = none;
            if let Some(number) = number {
                single::<S, _>(elements, number, Left::Moving, &mut room.solved, &mut room.of_forces);
            } else {
                minus_weight = held;
                weights = opposite::<S, P::Closures>(&held);
            }
            let stirred = room.stir::<P, _>(elements, &resting, stage, minus_weight, true);
            let weights = number.is_none().then_some(weights);
            self.pull_back_pair((force, moved), (weights, stirred), (time, step), (stage, position, free), gradient);
            let Some(room) = &mut self.room else { return };
            if let Some(number) = number {
                single::<S, _>(elements, number, Left::Own, &mut room.solved, &mut room.of_forces);
                singled::add::<S, _>(elements, &room.of_forces, &mut room.weights);
            }
        }
        // What is missed.
        let (Some(room), zero) = (&mut self.room, &self.zero) else { return };
        let Room { before: Posed { x, y, p, q }, solved, on_bodies, in_joints, .. } = room;
        solved.set(zero);
        room.forces.clone_from(&room.nothing);
        let kept = (&mut *on_bodies, &mut *in_joints, (&mut room.forces, &mut room.at_ends));
        let stores = (&*x, &*y, &*p, &*q, &stage.kept, (place, rate, zero, &mut *solved), kept, &mut room.efforts);
        elements.take(&mut Stir { forces: none }, S::at_ground(&ground), stores);
        let mut walk = self.loads.pull(elements, time, level, gradient.law.clone());
        let felt = tip.felt(&weights, &frame, level);
        let start = (&mut gradient.start.position, &mut gradient.start.rate);
        let seen = (&self.loads.on_bodies, &*on_bodies, &*in_joints, (&room.weights, &room.turns));
        let sums = (&mut gradient.numbers, &mut gradient.joints);
        let felt = elements.take(&mut walk, felt, (&*x, &*y, &*p, &*q, (place, rate, &*solved), seen, sums, start));
        gradient.law = walk.of_law;
        let (of_place, turn) = S::of_place(&felt, &ground);
        (gradient.place, gradient.ground) = (gradient.place + of_place, gradient.ground + turn);
        add::<S>(&mut gradient.tip, tip.of_residual(&weights, &frame, level));
    }

    /// What the M and Γ of a stage, and the springs in them, change of a correction x and the closure forces that go with it, by w and ν, both of
    /// which are in the room. Of a tip that is held where there are weights of it.
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn pull_back_pair(
        &mut self,
        (force, moved): (EachOf<S, P>, AccelerationOf<S>),
        (weights, stirred): (Option<EachOf<S, P>>, AccelerationOf<S>),
        (time, step): (RealOf<S>, RealOf<S>),
        (stage, position, free): (&StageOf<S, R, C, P, L>, &PositionOf<S, R, C>, Option<&Place<S, R, C>>),
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let Some(room) = &mut self.room else { return };
        let (elements, tip, resting) = (self.scene.elements(), self.scene.tip(), self.scene.ground(time).at_rest());
        let (columns, of, zero) = (tip.columns(), total::<S, P::Closures>, &self.zero);
        let Room { rest, still, solved, correction, of_position, of_rate, on_bodies, in_joints, .. } = room;
        let Posed { x, y, p, q } = &*rest;
        let mut pulled = S::Pulled::null();
        if let Some(weights) = &weights {
            pulled = S::pulled((of(&columns, weights), &moved), (of(&columns, &force), &stirred));
            add::<S>(&mut gradient.tip, tip.of_columns((weights, &moved), (&force, &stirred)));
        }
        let in_loops = (&room.of_forces, &room.forces, &room.at_ends);
        let reached = (&room.at_bodies, &room.at_joints, &*on_bodies, &*in_joints, &stage.pivots, in_loops);
        let motion = (&*still, zero, &*correction, &*solved);
        let sums = (&mut gradient.bodies, &mut gradient.joints);
        let stores = (x, y, p, q, motion, reached, sums, (&mut *of_position, &mut *of_rate));
        let angular = PositionOf::<S, R, C>::CLOCKED;
        let left = elements.take(&mut PullBack { laws: false, torques: false, angular }, pulled, stores);
        room.of_stage.add(of_position);
        if const { M::IMPLICIT } {
            let weights = self.rule.own::<S::Scalar>(step);
            let of_laws = (&mut *of_position, &mut *of_rate);
            let (led, of_led) = match free {
                Some((position, rate)) => ((position, rate), (&mut room.of_free.0, &mut room.of_free.1)),
                None => ((position, &stage.rate), (&mut room.of_stage, &mut room.of_speed)),
            };
            let pair = (&*correction, &*solved);
            let by_size = metric::<S, _>(elements, weights, pair, zero, &mut gradient.joints, of_laws, (led, of_led));
            if let Some(sum) = &mut self.of_own {
                *sum += by_size;
            }
        }
        gradient.ground = gradient.ground + S::of_ground(&left, &resting).1;
    }
}
