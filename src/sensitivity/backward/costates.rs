//! Costates, back through the steps of a run.
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

use super::GradientOf;
use super::between::Between;
use super::held::{opposite, weigh};
use super::record::{RecordOf, Stage, StageOf};
use super::rules::Staged;
use super::steps::{ROWS, Steps};
use crate::adjoint::{BodyLaw, Burdened, EachOf, Reversed, Reversible, ReversibleTip, Ties};
use crate::element::{Coordinates, Element, Level, Posture, RealOf};
use crate::ends::Root;
use crate::mirror::{Position, Rate, Retraction};
use crate::relation::{Additive, Solvable, Wrench};
use crate::scalar::Real;
use crate::sensitivity::Gradient;
use crate::sensitivity::gradient::Asked;
use crate::shape::Takes;
use crate::space::FrameOf;
use crate::stepper::displace::{gather, gather_few, with_row};
use crate::system::{Elements, MotionOf, PositionOf, RateOf};
use crate::walks::{Meet, PullBack, Stir};
use num_traits::{One, Zero};

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
    /// From the costates after a step, and what motions between have left, to those before it: the columns of the tableau, from the last to the
    /// first.
    pub(super) fn pull_back(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &RecordOf<S, R, C, P, M, L>,
        between: Option<&Between<S, R, C, P, M, L>>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let last = M::STAGES;
        if let (true, Some(projection)) = (Self::CLOSED > 0, &record.projection) {
            let stage = &record.stages.as_ref()[last - 1];
            let place = if last == 1 { &past.position } else { &stage.position };
            // Laws that stay where a stage is free were read there.
            let mut again = if Self::STAYS { self.again.take() } else { None };
            if let Some(again) = &mut again {
                self.remember(past, step, record.accelerations.as_ref(), &mut again.free);
            }
            let free = again.as_ref().map(|again| &again.free);
            self.pull_back_projection((past.time + step, step), (stage, place, free), projection, gradient);
            if again.is_some() {
                self.again = again;
            }
        }
        self.of_position.as_mut()[last].set(&gradient.start.position);
        self.of_rate.as_mut()[last].set(&gradient.start.rate);
        if const { M::REMEMBERS } {
            self.pull_back_memory(past, step, record, gradient);
            self.add_past(between, gradient);
            return;
        }
        if Self::CURVED {
            let (room, (position, rate)) = ((&self.zero, &mut self.sum), &mut self.end);
            let slopes = record.accelerations.as_ref();
            Self::displace(last, past, slopes, step, room, (&mut *position, &mut *rate));
            position.retract_rate(&past.position, rate);
            gradient.start.position.set(&self.zero);
            let of_end = (&mut self.of_position.as_mut()[last], &mut self.of_rate.as_mut()[last]);
            let of_past = &mut gradient.start.position;
            position.transposed_step(&past.position, (rate, &self.zero), &self.zero, of_end, of_past);
            if let Some(Between { of_end: [position, rate], .. }) = between {
                self.of_position.as_mut()[last].add(position);
                self.of_rate.as_mut()[last].add(rate);
            }
        }
        for row in (0..last).rev() {
            self.gather_later(row, step);
            if let Some(between) = between {
                self.of_acceleration.add(&between.of_slopes.as_ref()[row]);
            }
            let Stage { position, rate, acceleration, .. } = &record.stages.as_ref()[row];
            let curved = Self::CURVED && row > 0 && !M::IMPLICIT; // the first stage has turned by nothing
            if curved {
                self.of_second.set(&self.of_acceleration);
                position.transposed_acceleration(&past.position, &mut self.of_acceleration);
            }
            if const { M::IMPLICIT } {
                self.pull_back_solution(row, past, step, record, gradient);
                continue;
            }
            let time = past.time + RealOf::<S>::of(M::node(row)) * step;
            let (stage, slope) = (&record.stages.as_ref()[row], &record.accelerations.as_ref()[row]);
            self.pull_back_stage((row == 0).then_some(past), (row, true), time, (stage, slope), gradient);
            if let Some(room) = &self.room
                && row + 1 == last
            {
                self.of_position.as_mut()[row].add(&room.of_stage);
            }
            let (of_position, of_rate) = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
            let of_past = &mut gradient.start.position;
            if curved {
                let (here, of_here) = ((rate, acceleration), (of_position, of_rate));
                position.transposed_step(&past.position, here, &self.of_second, of_here, of_past);
            } else if Self::CURVED {
                of_past.add(of_position);
            }
        }
        self.gather_all(step, gradient);
        self.add_past(between, gradient);
    }

    /// λ of a row, by what later ones have left.
    #[cfg_attr(optimised, inline(always))]
    fn gather_later(&mut self, row: usize, step: RealOf<S>) {
        let (last, zero) = (M::STAGES, &self.zero);
        let (of_position, of_rate) = (self.of_position.as_ref(), self.of_rate.as_ref());
        if const { Self::FEW } {
            let [mut by_position, mut by_rate] = [zero.clone(), zero.clone()];
            with_row!(row, M::STAGES, |row| {
                let later = |k: usize| k > row && k <= last;
                gather_few(&mut by_position, zero, |k| later(k).then(|| M::weights(k).0[row]), of_position);
                gather_few(&mut by_rate, zero, |k| later(k).then(|| M::weights(k).1[row]), of_rate);
            });
            self.of_acceleration.mix_2(zero, (step * step, &by_position), (step, &by_rate));
            return;
        }
        let [position, rate] = &self.weights.as_ref()[row];
        let later = row + 1..last + 1;
        gather(&mut self.sum, zero, step * step, &position[later.clone()], &of_position[later.clone()]);
        gather(&mut self.of_acceleration, &self.sum, step, &rate[later.clone()], &of_rate[later]);
    }

    /// Costates before a step, by those of its rows.
    #[cfg_attr(optimised, inline(always))]
    fn gather_all(&mut self, step: RealOf<S>, gradient: &mut GradientOf<S, R, C, L>) {
        let (last, one, zero) = (M::STAGES, RealOf::<S>::one(), &self.zero);
        let (of_position, of_rate) = (&self.of_position.as_ref()[..=last], &self.of_rate.as_ref()[..=last]);
        if const { Self::FEW } {
            if !Self::CURVED {
                gather_few(&mut gradient.start.position, zero, |k| (k <= last).then_some(1.0), of_position);
            }
            gather_few(&mut self.sum, zero, |k| (k <= last).then(|| M::node(k)), of_position);
            gather_few(&mut self.of_acceleration, zero, |k| (k <= last).then_some(1.0), of_rate);
            gradient.start.rate.mix_1(&self.of_acceleration, (step, &self.sum));
            return;
        }
        if !Self::CURVED {
            gather(&mut gradient.start.position, zero, one, &[1.0; ROWS], of_position);
        }
        gather(&mut self.sum, zero, one, &[1.0; ROWS], of_rate);
        gather(&mut gradient.start.rate, &self.sum, step, &self.nodes, of_position);
    }

    /// Adds what motions between the ends of a step do to costates before it.
    fn add_past(&mut self, between: Option<&Between<S, R, C, P, M, L>>, gradient: &mut GradientOf<S, R, C, L>) {
        if let Some(Between { of_past: [position, rate, memory], .. }) = between {
            gradient.start.position.add(position);
            gradient.start.rate.add(rate);
            if const { M::REMEMBERS } {
                self.of_memory.add(memory);
            }
        }
    }

    /// From the costates after a step to those before it, and that of its size.
    pub(super) fn of_size(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &RecordOf<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) -> S::Scalar {
        self.of_own = Some(S::Scalar::zero());
        self.of_memory.set(&self.zero);
        self.pull_back(past, step, record, None, gradient);
        let mut sum = self.of_own.take().unwrap_or(S::Scalar::zero());
        if const { M::REMEMBERS } {
            return sum;
        }
        let (one, slopes) = (RealOf::<S>::one(), record.accelerations.as_ref());
        for row in 0..=M::STAGES {
            let (position, rate) = M::weights(row);
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

    /// Positions, rates and accelerations of a stage, those of the motion before a step where the stage is that.
    #[inline(always)]
    #[allow(clippy::type_complexity)] // three in one
    fn motion_of<'a>(
        start: Option<&'a MotionOf<S, R, C, P>>,
        (stage, slope): (&'a StageOf<S, R, C, P, L>, &'a RateOf<S, R, C>),
    ) -> (&'a PositionOf<S, R, C>, &'a RateOf<S, R, C>, &'a RateOf<S, R, C>) {
        match start {
            Some(past) => (&past.position, &past.rate, slope),
            None => (&stage.position, &stage.rate, Self::found(stage, slope)),
        }
    }

    /// M w + Γᵀν = λ, Γ w = 0 through the gains of a stage, for the costates of accelerations, which become w; gives −ν of what holds the tip,
    /// and what is carried there.
    #[inline(always)]
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn stir(
        &mut self,
        start: Option<&MotionOf<S, R, C, P>>,
        frame: &FrameOf<S>,
        (stage, slope): (&StageOf<S, R, C, P, L>, &RateOf<S, R, C>),
    ) -> (EachOf<S, P>, S::Stirred) {
        let elements = self.scene.elements();
        let Stage { x, y, p, q, kept, pivots, .. } = stage;
        let (position, rate, acceleration) = Self::motion_of(start, (stage, slope));
        let free = &mut self.of_acceleration;
        let mut walk = Meet::nothing();
        elements.take(&mut walk, Wrench::none(), (x, y, p, q, kept, pivots, &mut *free, &mut self.in_loops));
        let weight = P::Closures::solve(&stage.compliance, &walk.gaps);
        let kept_of_them = (&mut self.on_bodies, &mut self.in_joints, (&mut self.in_loops, &mut self.at_ends));
        let stores = (x, y, p, q, kept, (position, rate, acceleration, free), kept_of_them, &mut self.of_torques);
        let forces = opposite::<S, P::Closures>(&weight);
        let stirred = elements.take(&mut Stir { forces }, S::at_ground(frame), stores);
        (weight, stirred)
    }

    /// From the costates of the accelerations of a stage to those of its positions and rates.
    #[inline(never)]
    #[allow(clippy::type_complexity)] // two in one argument
    pub(super) fn pull_back_stage(
        &mut self,
        start: Option<&MotionOf<S, R, C, P>>,
        (row, laws): (usize, bool),
        time: RealOf<S>,
        (stage, slope): (&StageOf<S, R, C, P, L>, &RateOf<S, R, C>),
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let frame = self.scene.ground(time);
        if const { !(R::RESTS && P::RESTS) } {
            gradient.asked = Some(Asked::and(gradient.asked, time));
        }
        let minus_weights = if const { Self::TIED } { self.untie(start, &frame, (stage, slope)) } else { None };
        let (weight, stirred) = self.stir(start, &frame, (stage, slope));
        let elements = self.scene.elements();
        let Stage { x, y, p, q, pivots, at_bodies, at_joints, in_loops, .. } = stage;
        let (position, rate, acceleration) = Self::motion_of(start, (stage, slope));
        let free = &mut self.of_acceleration;
        if let Some(minus_weights) = &minus_weights {
            let [ratios, _] = L::of_ties(&mut gradient.law);
            self.loads.law.ties().weigh([&stage.tensions, minus_weights], [acceleration, &*free], ratios);
        }
        let mut pulled = S::Pulled::null();
        if const { Self::HELD } {
            let accelerations = (stage.reached, self.scene.tip().ground(time).falling(self.scene.gravity()));
            pulled = weigh(self.scene, (&weight, &stage.force), accelerations, &S::stirred(&stirred), gradient);
        }
        let Gradient { bodies, joints, .. } = gradient;
        let start = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
        let of_loops = (&self.in_loops, in_loops, &self.at_ends);
        let kept_of_them = (at_bodies, at_joints, &self.on_bodies, &self.in_joints, pivots, of_loops);
        let stores = (x, y, p, q, (position, rate, acceleration, &*free), kept_of_them, (bodies, joints), start);
        let left = elements.take(
            &mut PullBack { laws, torques: true, angular: PositionOf::<S, R, C>::CLOCKED },
            pulled,
            stores,
        );
        let (gravity, turn) = S::of_ground(&left, &frame);
        (gradient.gravity, gradient.ground) = (gradient.gravity + gravity, gradient.ground + turn);
        if const { L::ON } {
            let motion = Coordinates { position, rate, acceleration: &self.zero };
            self.loads.see(elements, frame, Posture { x, y, p, q }, motion, time);
            let Gradient { numbers, joints, law, .. } = gradient;
            let mut walk = self.loads.pull(elements, time, Level::Place, law.clone());
            let mut pull = |walk: &mut _| {
                let start = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
                let kept_of_them =
                    (&self.loads.on_bodies, &self.on_bodies, &self.in_joints, (&self.no_loops, &self.no_turns));
                let motion = (position, rate, &self.of_acceleration);
                let sums = (&mut *numbers, &mut *joints);
                elements.take(walk, S::Felt::null(), (x, y, p, q, motion, kept_of_them, sums, start))
            };
            if const { L::SURVEYS } {
                // Of nothing there are no costates yet.
                walk.surveys = true;
                pull(&mut walk);
                (walk.surveys, walk.body) = (false, elements.bodies());
            }
            let felt = pull(&mut walk);
            *law = walk.of_law;
            let (place, turn) = S::of_place(&felt, &frame);
            (gradient.place, gradient.ground) = (gradient.place + place, gradient.ground + turn);
        }
    }
}
