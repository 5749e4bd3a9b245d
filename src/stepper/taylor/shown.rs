//! What is to be seen of the series of a step.

use super::TaylorStepper;
use crate::lift::Lift;
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::scalar::{Powers, Real, Scalar};
use crate::stepper::TimeIn;
use crate::system::SeriesDynamics;
use num_traits::{One, Zero};

impl<D: SeriesDynamics<L, P>, L, const P: usize> TaylorStepper<D, L, P> {
    /// Shows coefficient number `k` of each acceleration in the last step, root to tip: that of the power k of the time (s) since its
    /// start, from 0 to one less than the order.
    pub fn coefficients(&self, k: usize, mut each: impl FnMut(D::Scalar)) {
        if let Some(accelerations) = self.accelerations[..self.order].get(k) {
            accelerations.visit(&mut each);
        }
    }

    /// The motion of the last step as power series of the time (s) since its start: positions and rates, and with accelerations that a sweep finds all
    /// that can be read of it, joint forces among them. Of a scene over such numbers, and under loads over them: efforts that are functions of time
    /// are values of [`Powers::variable`] there.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Powers, Scalar};
    /// use catena::simulate::Stepper;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let (mut stepper, start) = (pendulum.stepper(Taylor::<12>), pendulum.at_rest(&[0.0, 0.0])?);
    /// let mut end = start;
    /// stepper.step(&start, &Unloaded, 0.02, &mut end)?;
    /// let scene = pendulum.lift(Powers::<f64, 12>::constant);
    /// let motion = scene.with_accelerations(stepper.motion_series(), &Unloaded)?;
    /// // The force in the second pin (N, along y), at its start and 0.02 s later.
    /// let series = scene.stations(&motion, &Unloaded)?.get(1).map(|station| station.internal.force.y.terms()).unwrap();
    /// let later = pendulum.stations(&end, &Unloaded)?.get(1).map(|station| station.internal.force.y).unwrap();
    /// let sum = series.iter().rev().fold(0.0, |sum, term| sum * 0.02 + term);
    /// assert!((sum - later).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn motion_series<V>(&self) -> Motion<Powers<D::Scalar, P>, V, D::Closures>
    where
        D::Position: Lift<D::Scalar, Powers<D::Scalar, P>, Over = V>,
        D::Rate: Lift<D::Scalar, Powers<D::Scalar, P>, Over = V::Rate>,
        V: Position<Powers<D::Scalar, P>>,
    {
        let mut motion = self.origin.lift(Powers::of);
        let (time, one) = (Powers::variable(Zero::zero(), P), TimeIn::<D, L>::one());
        let (mut power, mut displacement) = (time, motion.rate.clone());
        displacement.replace(&mut |rate| rate * time);
        for (k, coefficient) in self.accelerations[..self.order].iter().enumerate() {
            let mut term = coefficient.lift(&mut Powers::of);
            let share = |k: usize| one / TimeIn::<D, L>::of(k as f64);
            term.replace(&mut |x| (x * power).scale(share(k + 1)));
            motion.rate.add(&term);
            term.replace(&mut |x| (x * time).scale(share(k + 2)));
            displacement.add(&term);
            power *= time;
        }
        let before = motion.position.clone();
        motion.position.displace(&displacement);
        if V::CURVED {
            motion.position.retract_rate(&before, &mut motion.rate);
        }
        motion
    }
}
