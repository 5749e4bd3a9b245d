//! Runs that end at an event: their last step cut there, and their gradients.
//!
//! A run ends where g(y) = 0, y being the motion after a last step whose size h makes it so. A cost Φ then changes by
//!
//! ```text
//! dΦ = (Φ_y − η g_y) dy at fixed h        η = (Φ_h + Φ_t) / (g_h + g_t)
//! ```
//!
//! with Φ_h, g_h the derivatives by the size of the last step, by which time ends later.

use super::loads::depend_on_time;
use super::rules::Staged;
use super::steps::Steps;
use super::{Backward, CostateOf, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Coordinates, Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault, ensure_finite};
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::scalar::{Elementary, Real, Scalar};
use crate::sensitivity::Costate;
use crate::simulate::crossing::{crosses, crossing, departure, of_one_number};
use crate::system::{Elements, MotionOf, PositionOf, Runs, System};
use core::any::TypeId;
use num_traits::Zero;

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
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
    /// Cuts the first step of a run in which a function of the motion crosses zero, so that it is zero at the step's end, and gives the
    /// number of steps up to there; none where it does not cross. The state of this number has no accelerations but zeros (by
    /// `GeneralizedAlpha` what that remembers); those beyond are of no run. Jets and dual numbers have there the derivatives at a fixed time.
    ///
    /// # Errors
    /// [`Fault::Count`] for torques of another number, [`Fault::Shape`] for motions of another scene, [`Fault::OutOfRange`] for states that go back in
    /// time, [`Fault::NotFinite`] where the function
    /// is no number, [`Fault::Unsupported`] for lanes, which cross zero one by one; what the loads on bodies refuse.
    pub fn cut(
        &mut self,
        torques: &[EffortOf<S>],
        states: &mut [MotionOf<S, R, C, P>],
        mut event: impl FnMut(&MotionOf<S, R, C, P>) -> S::Scalar,
    ) -> Result<Option<usize>, Error> {
        self.check(torques, states)?;
        of_one_number::<S::Scalar>()?;
        let mut value = |state: &_| {
            let value = event(state).real().as_f64();
            ensure_finite(!value.is_nan(), "value of the event function").map(|()| value)
        };
        let Some(first) = states.first() else { return Ok(None) };
        let mut before = value(first)?;
        for k in 1..states.len() {
            let [past, next, ..] = &mut states[k - 1..] else { break };
            let after = value(next)?;
            let size = next.time - past.time;
            let mut cut = |theta: f64, next: &mut _| {
                self.steps.take_torques(torques, k - 1);
                self.steps.step_to(past.time + size * RealOf::<S>::of(theta), past, &mut self.record, next);
                value(next)
            };
            let mut from = 0.0;
            if before == 0.0 || k == 1 {
                let (rounding, mut beyond) = (RealOf::<S>::EPSILON.sqrt().as_f64(), next.clone());
                (from, before) = departure([before, after], rounding, &mut |theta| cut(theta, &mut beyond))?;
            }
            if crosses([before, after]) {
                let share = |part: f64| from + (1.0 - from) * part;
                let part = crossing([before, after], &mut |part| cut(share(part), next))?;
                cut(share(part), next)?;
                return Ok(Some(k));
            }
            before = after;
        }
        Ok(None)
    }

    /// The gradient of a cost by everything, for a run that ends where a function of the motion is zero, whose last step was
    /// [cut](Self::cut) there: that of what is computed, the time of the end included. `event` adds the derivatives of that function.
    ///
    /// Both cost and function may read the time of the motion: [`Costate::time`]. The derivative of the time of the event itself is that of
    /// a cost which adds one to it at the last state, and nothing else.
    ///
    /// ```
    /// use catena::planar::*;
    /// // When does what is thrown upward at 2 m/s, from 1 m above it, hit the ground?
    /// let line = Slider::along(core::f64::consts::FRAC_PI_2);
    /// let ball = System::new(Clamped::at(0.0, 0.0, 0.0), (line, RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2])), Free)?.with_gravity(9.81);
    /// let mut start = ball.motion();
    /// start.set_coordinates(&[1.0])?;
    /// start.set_rates(&[2.0])?;
    /// let (mut backward, mut states) = (ball.backward(Rk4), [start; 101]);
    /// backward.run(&start, 0.01, 100, &[], &mut states)?;
    /// let Some(steps) = backward.cut(&[], &mut states, |state| state.position().1.0)? else { unreachable!() };
    /// let time = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| {
    ///     by.time += if step == steps { 1.0 } else { 0.0 };
    ///     Ok(())
    /// };
    /// let gradient =
    ///     backward.gradient_to_event(&[], &states[..=steps], &mut [], time, |_, by| by.add(&[1.0], &[0.0]))?;
    /// let root = (2.0_f64 * 2.0 + 2.0 * 9.81).sqrt();
    /// assert!((states[steps].time() - (2.0 + root) / 9.81).abs() < 1e-14);
    /// assert!((gradient.by_position()[0] - 1.0 / root).abs() < 1e-14); // (s/m)
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Where the ground moves, joints are driven or loads on bodies ([`under`](Self::under)) depend on time, what the last step's size changes is
    /// found by central differences of that step, to some 11 digits (7 of a run that has begun at 1e5 s: times are rounded); a law is taken to depend on it that gives other loads at three times of the
    /// last step, for a motion at its start, its end or one of its stages. A cost or function that reads what ground and drives do by themselves
    /// adds that to [`Costate::time`]. Scenes over jets, dual numbers and lanes are refused: times are plain numbers, and what the time of the end
    /// does to second derivatives, or in each lane, is not found.
    ///
    /// # Errors
    /// As [`gradient`](Self::gradient); [`Fault::Count`] for a run without a step; [`Fault::NotFinite`] where the function of the event does
    /// not change with the time of the end, so that no time is that of the event; [`Fault::Unsupported`] for numbers that are not plain.
    pub fn gradient_to_event(
        &mut self,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
        event: impl FnOnce(&MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        let last = self.check(torques, states)?;
        self.admits(states.len() - 1, by_torques.len())?;
        if TypeId::of::<S::Scalar>() != TypeId::of::<RealOf<S>>() {
            let what = "the gradient up to an event of numbers that carry derivatives, or lanes: times have none";
            return Err(Error::new(Fault::Unsupported { what }));
        }
        let [.., past, _] = states else {
            return Err(Error::new(Fault::Count { list: "states", expected: 2, given: states.len() }));
        };
        let (k, size) = (states.len() - 2, last.time - past.time);
        self.steps.take_torques(torques, k);
        self.steps.evaluate(past, size, &mut self.record);
        let over_time = self.last_depends_on_time(past, last, size);
        let mut gradient = self.begin(by_torques);
        let scratch = &mut self.scratch;
        scratch.start = gradient.start.clone();
        cost(states.len() - 1, last, &mut gradient.start)?;
        event(last, &mut scratch.start)?;
        let of_event = scratch.start.clone();
        // By the size of the last step, of either alone.
        let [mut by_cost, mut by_event] = [gradient.start.time, of_event.time];
        if over_time {
            let mut moves = [S::Scalar::zero(); 2];
            self.moved_by_size(past, last, [&gradient.start, &of_event], &mut moves);
            (by_cost, by_event) = (by_cost + moves[0], by_event + moves[1]);
        } else {
            let scratch = &mut self.scratch;
            for (start, by_size) in [(&gradient.start, &mut by_cost), (&of_event, &mut by_event)] {
                scratch.start.position.set(&start.position);
                scratch.start.rate.set(&start.rate);
                *by_size += self.steps.of_size(past, size, &self.record, scratch);
            }
        }
        self.steps.give_torques(&mut [], 0);
        self.steps.of_memory.set(&self.steps.zero);
        let moves = by_event.is_finite() && !by_event.real().is_zero();
        ensure_finite(moves, "time of the end per change of the event's function")?;
        let share = by_cost * by_event.recip();
        let Costate { mut position, mut rate, time } = of_event;
        position.replace(&mut |x| -(share * x));
        rate.replace(&mut |x| -(share * x));
        gradient.start.position.add(&position);
        gradient.start.rate.add(&rate);
        gradient.start.time -= share * time;
        self.pull_back(torques, states, by_torques, &mut gradient, cost)?;
        Ok(gradient)
    }

    /// Whether what acts in the last step, from a motion to one, depends on time, on ground that moves or drives.
    fn last_depends_on_time(&self, past: &MotionOf<S, R, C, P>, last: &MotionOf<S, R, C, P>, size: RealOf<S>) -> bool {
        if const { PositionOf::<S, R, C>::CLOCKED || !(R::RESTS && P::RESTS) } {
            return true;
        }
        if const { !L::ON } {
            return false;
        }
        let Steps { scene, zero, .. } = &self.steps;
        let law = self.steps.loads.law;
        let times = [0.0, 0.37, 1.0].map(|share| past.time + size * RealOf::<S>::of(share));
        let depends = |position: &_, rate: &_| {
            let motion = Coordinates { position, rate, acceleration: zero };
            depend_on_time(law, scene.elements(), scene.ground(past.time), motion, &times)
        };
        // What multiplies the time may be zero at either end.
        let stages = &self.record.stages.as_ref()[usize::from(!M::IMPLICIT || M::REMEMBERS)..M::STAGES]; // the first of others is `past`
        depends(&past.position, &past.rate)
            || depends(&last.position, &last.rate)
            || stages.iter().any(|stage| depends(&stage.position, &stage.rate))
    }

    /// What each of some costates sees move as the last step grows: by central differences of order four of that step, whose times move, too.
    fn moved_by_size(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        last: &MotionOf<S, R, C, P>,
        costates: [&CostateOf<S, R, C>; 2],
        sums: &mut [S::Scalar; 2],
    ) {
        let (unit, mut next) = ((last.time - past.time) * RealOf::<S>::of(1.0 / 128.0), last.clone());
        for (steps, weight) in [(1.0, 8.0), (-1.0, -8.0), (2.0, -1.0), (-2.0, 1.0)] {
            let weight = RealOf::<S>::of(weight / 12.0) / unit;
            self.steps.step_to(last.time + unit * RealOf::<S>::of(steps), past, &mut self.record, &mut next);
            let moved = &mut self.scratch.start.position;
            next.position.apart(&last.position, moved);
            for (sum, costate) in sums.iter_mut().zip(costates) {
                let mut add = |costate: S::Scalar, by: S::Scalar| {
                    *sum += (costate * by).scale(weight);
                    true
                };
                costate.position.all(moved, &mut add);
                costate.rate.all(&next.rate, &mut add);
            }
        }
    }
}
