//! The projection at the end of a step, of a tip that is held, of loops that are closed and of joints that are coupled, as a stepper makes it.

use super::held::opposite;
use super::record::{Record, RecordOf, StageOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip, Ties};
use crate::element::{Coordinates, Element, Level, Posture, RealOf};
use crate::ends::Root;
use crate::mirror::{Position, Rate, Retraction};
use crate::relation::{Acceleration, Solvable};
use crate::scalar::{Real, Scalar};
use crate::shape::Positions;
use crate::system::{Corrections, Elements, MOST_CORRECTIONS, MotionOf, PositionOf, RateOf, System};
use crate::walks::look::look;
use crate::walks::restore::restore;

/// Most positions, or rates, of a projection: before it, and after each correction.
const PLACES: usize = MOST_CORRECTIONS + 2;

/// The projection at the end of a step.
#[derive(Clone)]
pub(super) struct Projection<S: Reversed, E: Element<S>> {
    /// Positions before each correction, and after the last; how many corrections there were.
    pub(super) places: [E::Position; PLACES],
    pub(super) moves: usize,
    /// Rates before each correction, and after the last; how many corrections there were.
    pub(super) rates: [E::Rate; PLACES],
    pub(super) changes: usize,
}

impl<S: Reversed, E: Element<S>> Projection<S, E> {
    pub(super) fn new(elements: &E, zero: &E::Rate) -> Self {
        let place = elements.store::<Positions>(());
        let places = core::array::from_fn(|_| place.clone());
        Self { places, moves: 0, rates: core::array::from_fn(|_| zero.clone()), changes: 0 }
    }

    /// Positions after the last correction.
    pub(super) fn place(&self) -> &E::Position {
        &self.places[self.moves]
    }

    /// Rates after the last correction.
    pub(super) fn rate(&self) -> &E::Rate {
        &self.rates[self.changes]
    }
}

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
    /// Where a step ends, and its projection.
    pub(super) fn end_projected(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &mut RecordOf<S, R, C, P, M, L>,
    ) {
        let Record { stages, accelerations, projection } = record;
        let Some(projection) = projection else { return };
        let Projection { places: [place, ..], rates: [rate, ..], .. } = &mut *projection;
        if const { M::REMEMBERS } {
            self.end_unprojected(past, step, accelerations, (place, rate));
        } else {
            let sums = (&self.zero, &mut self.sum);
            Self::displace(M::STAGES, past, accelerations.as_ref(), step, sums, (&mut *place, &mut *rate));
            if Self::CURVED {
                place.retract_rate(&past.position, rate);
            }
        }
        self.project(past.time + step, &stages.as_ref()[M::STAGES - 1], projection);
    }

    /// The projection of a motion that stands where corrections begin, by what a stage keeps: as a stepper makes it.
    pub(super) fn project(
        &mut self,
        time: RealOf<S>,
        stage: &StageOf<S, R, C, P, L>,
        projection: &mut Projection<S, Elements<S, R, C>>,
    ) {
        let Some(room) = &mut self.room else { return };
        let Projection { places, moves, rates, changes } = projection;
        let most = if Self::SETTLES { MOST_CORRECTIONS } else { Self::CLOSED };
        let (scene, ties, none, into) = (self.scene, self.loads.law.ties(), &self.zero, &mut room.correction);
        let correct = |level, motion: (&_, &_), correction: &mut _| {
            Self::correct(scene, &ties, (level, time), stage, motion, none, correction);
        };
        let mut corrections = Corrections::<S::Scalar>::begin();
        places[0].visit(&mut |x| corrections.see(x));
        *moves = 0;
        for count in 0..=most {
            let [before, after, ..] = &mut places[count..] else { break };
            correct(Level::Place, (before, &rates[0]), into);
            after.clone_from(before);
            after.displace(into);
            *moves = count + 1;
            if Self::SETTLES && (corrections.end(into, count >= Self::CLOSED) || corrections.overshoot()) {
                break;
            }
        }
        if Self::SETTLES && corrections.lead_nowhere() {
            places[*moves].replace(&mut |_| S::Scalar::constant(RealOf::<S>::INFINITY));
        }
        let mut corrections = Corrections::<S::Scalar>::begin();
        rates[0].visit(&mut |x| corrections.see(x));
        *changes = 0;
        for count in 1..=most {
            let [before, after, ..] = &mut rates[count - 1..] else { break };
            correct(Level::Velocity, (&places[*moves], before), into);
            after.set(before);
            after.add(into);
            *changes = count;
            if Self::SETTLES && corrections.end(into, count >= Self::CLOSED) {
                break;
            }
        }
    }

    /// The correction of positions or rates, to first order; gives the forces of couplings.
    pub(super) fn correct(
        scene: &System<S, R, C, P>,
        ties: &L::Ties,
        (level, time): (Level, RealOf<S>),
        stage: &StageOf<S, R, C, P, L>,
        (position, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        zero: &RateOf<S, R, C>,
        correction: &mut RateOf<S, R, C>,
    ) -> <L::Ties as Ties<S>>::Each<S::Scalar> {
        let (elements, ground) = (scene.elements(), scene.ground(time));
        let at = Coordinates { position, rate, acceleration: zero };
        let [place, velocity] = scene.tip().residual(time, &look(elements, ground, at));
        let residual = if let Level::Place = level { place } else { velocity };
        let force = P::Closures::solve(&stage.compliance, &opposite::<S, P::Closures>(&residual));
        let posture = Posture { x: &stage.x, y: &stage.y, p: &stage.p, q: &stage.q };
        let (still, kept) = (Acceleration::zero(), &stage.kept);
        restore::<S, _, P::Closures>(elements, ground, at, level, still, posture, kept, force, correction);
        ties.rejoin(&stage.responses, level, (position, rate), correction)
    }
}
