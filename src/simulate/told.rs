//! Runs whose caller tells loads otherwise between steps: controllers that sample, partners that are simulated elsewhere.

use super::drive::Running;
use super::now::settled;
use super::shown::Shown;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, ensure_finite};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Runs, System};
use crate::time::Control;

impl<'a, S, R, C, P, L, M, E, K, O> Running<'a, S, R, C, P, L, M, E, K, O>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    K: Stepper<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    O: FnMut(&Now<'_, S, R, C, P, L>),
{
    /// Steps until one ends at a time (s) or later, which cuts none of them short.
    ///
    /// Loads may have changed since the last call, as when a controller sets a `Cell` that they read: the next step begins with what they cause now, as
    /// after [`resume`](crate::simulate::Simulation::resume). Under error control steps end where they end: a controller that samples at given times has fixed steps, or
    /// runs from one sample to the next.
    ///
    /// ```
    /// use catena::planar::*;
    /// use core::cell::Cell;
    /// let wheel = System::new(Pinned::origin(), RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]), Free)?;
    /// let torque = Cell::new(0.0);
    /// let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| torque.get());
    /// let mut run = wheel.simulation(Rk4::step(0.1)).loads(&loads).begin(wheel.motion(), 1.0, |_| ())?;
    /// run.until(0.5)?;
    /// torque.set(1.0);
    /// run.until(1.0)?;
    /// assert!((run.motion().rates()[0] - 0.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`step`](Self::step); [`Fault::NotFinite`](crate::Fault::NotFinite) for a time that is no number.
    pub fn until(&mut self, time: RealOf<S>) -> Result<(), Error> {
        ensure_finite(time <= RealOf::<S>::INFINITY, "time until which a run is to go on")?;
        self.go_on(time).0
    }

    /// Steps until a time (s), at which the last of them ends, or until the run does. Loads may have changed since the last call, as for
    /// [`until`](Self::until): for a controller that samples, for loads that jump at known times, and for partners that are simulated elsewhere.
    ///
    /// ```
    /// use catena::planar::*;
    /// use core::cell::Cell;
    /// let arm = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    /// let torque = Cell::new(0.0);
    /// let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| torque.get());
    /// let mut run = arm.simulation(Dop853::tolerance(1e-9)).loads(&loads).begin(arm.at_rest(&[-1.0])?, 1.0, |_| ())?;
    /// for sample in 0..100 {
    ///     let (angle, rate) = (run.motion().coordinates()[0], run.motion().rates()[0]);
    ///     torque.set(5.0 - 40.0 * angle - 8.0 * rate); // held for 10 ms
    ///     run.up_to(0.01 * f64::from(sample + 1))?;
    /// }
    /// assert_eq!(run.motion().time(), 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Fixed steps count from there; under error control the steps that follow are as long as they were to be.
    ///
    /// # Errors
    /// As [`until`](Self::until).
    pub fn up_to(&mut self, time: RealOf<S>) -> Result<(), Error> {
        ensure_finite(time <= RealOf::<S>::INFINITY, "time up to which a run is to go on")?;
        let whole = self.end;
        self.end = whole.min(time);
        let (outcome, wanted) = self.go_on(time);
        let cut = self.past.time >= self.end;
        self.end = whole;
        outcome?;
        let control = self.plan.rule.control;
        if let (Control::Tolerance(_), true) = (control, cut) {
            self.progress.size = self.progress.size.max(wanted);
        }
        self.progress.fit(self.past.time, control, self.plan.every)
    }

    /// Steps until one ends at a time (s) or later, under loads as they are now; what the last step was to be (s).
    fn go_on(&mut self, time: RealOf<S>) -> (Result<(), Error>, RealOf<S>) {
        let mut wanted = self.progress.size;
        // Where no step follows loads stay to be seen.
        if self.progress.stopped || self.past.time >= time.min(self.end) {
            return (Ok(()), wanted);
        }
        let mut outcome = self.look_anew().map(|()| true);
        while let Ok(true) = outcome
            && self.past.time < time
        {
            wanted = self.progress.size;
            outcome = self.step();
        }
        self.see();
        (outcome.map(|_| ()), wanted)
    }

    /// Keeps what loads cause now, to be compared with what they cause later.
    fn see(&mut self) {
        self.caused = Some(settled(self.plan.system, self.plan.loads, &self.past));
    }

    /// Looks at loads anew, which may have changed since they were last seen at this motion.
    fn look_anew(&mut self) -> Result<(), Error> {
        let Some(caused) = self.caused.take().filter(|caused| caused.time == self.past.time) else {
            return Ok(());
        };
        let settled = caused.acceleration.all(&self.past.acceleration, &mut Scalar::is_identical);
        self.adapt((!settled).then_some(&caused));
        if const { Self::CUTS } {
            self.settle_anew()?;
        }
        if self.value.is_some() {
            self.value = self.value(Shown::Past)?;
        }
        Ok(())
    }
}
