//! Gradients of costs at samples, wherever they fall between the steps of a run.

use super::rules::Staged;
use super::{Backward, CostateOf, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::loading::EffortOf;
use crate::scalar::{Real, Scalar};
use crate::system::{Elements, MotionOf, Runs, System};

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
    /// As [`gradient`](Self::gradient), of a cost at samples: `cost` is told the number of each of these `times` (s), from the last to the first, and
    /// the motion there, that of dense output as [`every`](crate::simulate::Simulation::every) shows it, and adds the derivatives of the cost by its
    /// position and rate. A run needs no more steps for samples that are dense.
    ///
    /// An integral along the run is a sum over samples, times the weights of a quadrature:
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let start = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let (mut backward, mut states) = (pendulum.backward(Dop853), [start; 11]);
    /// backward.run(&start, 0.1, 10, &[], &mut states)?;
    /// // The integral of the square of a rate, by two points in each fortieth of a second.
    /// let times: [f64; 80] = core::array::from_fn(|k| 0.025 * ((k / 2) as f64 + 0.5 + [-0.5, 0.5][k % 2] / 3_f64.sqrt()));
    /// let mut integral = 0.0;
    /// let gradient = backward.gradient_at(&[], &states, &times, &mut [], |_, now, by| {
    ///     let rate = now.rates()[1];
    ///     integral += 0.0125 * rate * rate;
    ///     by.add(&[0.0; 2], &[0.0, 0.025 * rate])
    /// })?;
    /// # let at = |gravity: f64| -> Result<f64, catena::Error> {
    /// #     let mut sum = 0.0;
    /// #     let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(gravity);
    /// #     scene.simulation(Dop853::step(2.5e-3)).run(start, 1.0, |now| sum += 2.5e-3 * now.motion().rates()[1].powi(2))?;
    /// #     Ok(sum)
    /// # };
    /// # let (found, difference) = (-gradient.by_gravity().y, (at(9.82)? - at(9.80)?) / 0.02);
    /// # assert!((found - difference).abs() < 2e-2 * difference.abs(), "{found} {difference}");
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// A sample that falls on the end of a step is the state there. Implicit rules make a step of that share of the step for a sample, as in
    /// `simulate`.
    ///
    /// # Errors
    /// As [`gradient`](Self::gradient); [`Fault::OutOfRange`] for times that do not rise, or beyond the run.
    pub fn gradient_at(
        &mut self,
        torques: &[EffortOf<S>],
        states: &[MotionOf<S, R, C, P>],
        times: &[RealOf<S>],
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<GradientOf<S, R, C, L>, Error> {
        let last = self.check(torques, states)?;
        self.admits(states.len() - 1, by_torques.len())?;
        let mut earliest = states[0].time;
        for time in times {
            if !(earliest <= *time && *time <= last.time) {
                let (value, least, most) = (time.as_f64(), earliest.as_f64(), last.time.as_f64());
                let (parameter, outside) = ("time of a sample", "samples lie within a run, and their times rise");
                return Err(Error::new(Fault::OutOfRange { parameter, value, least, most, outside }));
            }
            earliest = *time;
        }
        let mut gradient = self.begin(by_torques);
        let mut between = self.steps.room_between(&self.record);
        let mut samples = times.len();
        for (k, pair) in states.windows(2).enumerate().rev() {
            let [past, next] = pair else { continue };
            let size = next.time - past.time;
            // A sample that falls on the end of a step but for rounding is its end.
            let slack = RealOf::<S>::EPSILON * RealOf::<S>::of(4.0) * (past.time.abs() + size);
            let after = |time: RealOf<S>| times.partition_point(|sample| *sample <= time);
            let (inner, first) = (after(next.time - slack).min(samples), after(past.time + slack).min(samples));
            for sample in (inner..samples).rev() {
                cost(sample, next, &mut gradient.start)?;
            }
            self.steps.take_torques(torques, k);
            if inner > first {
                let shares = (first..inner).rev().map(|sample| ((times[sample] - past.time) / size).as_f64());
                let mut number = inner;
                let mut cost = |motion: &_, gradient: &mut GradientOf<S, R, C, L>| {
                    number -= 1;
                    cost(number, motion, &mut gradient.start)
                };
                self.steps.pull_back_between(
                    (past, next),
                    &mut self.record,
                    &mut between,
                    &mut gradient,
                    (shares, &mut cost),
                )?;
            }
            if inner == first || M::IMPLICIT {
                self.steps.evaluate(past, size, &mut self.record);
            }
            self.steps.recognise(past, next, &self.record, &mut self.spare)?;
            let left = (inner > first).then_some(&between);
            self.steps.pull_back(past, size, &self.record, left, &mut gradient);
            self.steps.give_torques(by_torques, k);
            samples = first.min(inner);
        }
        for sample in (0..samples).rev() {
            cost(sample, &states[0], &mut gradient.start)?;
        }
        self.finish(&states[0], &mut gradient)?;
        Ok(gradient)
    }
}
