//! A run under way: its steps, samples by dense output, location of events.

use super::accept::Taken;
use super::crossing::{DEPARTED, crosses, crossing, departure, of_one_number};
use super::now::settled;
use super::shown::Shown;
use super::{EventFunction, Now, Progress, Simulation, limits};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, ensure_finite};
use crate::mirror::Rate;
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::{Stepper, modes_of_one};
use crate::system::Dynamics;
use crate::system::{MotionOf, Runs, System};
use crate::time::Control;
use num_traits::One;

/// A run under way, step by step: made by [`begin`](Simulation::begin) and [`resume`](Simulation::resume).
pub struct Running<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L, M, E, K, O> {
    pub(super) plan: Simulation<'a, S, R, C, P, L, M, E>,
    pub(super) end: RealOf<S>,
    pub(super) stepper: K,
    pub(super) past: MotionOf<S, R, C, P>,
    pub(super) next: MotionOf<S, R, C, P>,
    pub(super) between: MotionOf<S, R, C, P>,
    pub(super) observe: O,
    pub(super) progress: Progress<RealOf<S>>,
    /// The value of the event function at the past motion.
    pub(super) value: Option<f64>,
    /// The motion at which loads were last seen between steps, with the accelerations that they caused.
    pub(super) caused: Option<MotionOf<S, R, C, P>>,
}

/// What came of a step.
enum Outcome {
    Continue,
    /// An event was shown.
    Event,
    Stop,
}

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
    /// Refuses what makes no run, and motions of another scene; whether joints of the start were [let go](Self::accelerated).
    fn check(&mut self) -> Result<bool, Error> {
        modes_of_one::<S::Scalar>(Self::MODES)?;
        if const { <E as EventFunction<Now<'a, S, R, C, P, L>, S::Scalar>>::ON || Self::KINKS > 0 } {
            of_one_number::<S::Scalar>()?;
        }
        // Positions may be those of another motion: driven coordinates keep their time.
        self.past.set_time(self.past.time);
        self.next.set_time(self.next.time);
        let system = self.plan.system;
        system.fits(&self.past)?;
        system.loadable(self.plan.loads)?;
        system.stands(&self.past)?;
        system.suited(&self.past, self.plan.loads)?;
        let mut loosened = false;
        if System::<S, R, C, P>::CLOSED > 0 {
            // Whether they are independent, once.
            loosened = self.accelerated()?;
            system.nearly_closed(&self.past, self.plan.loads, &mut system.workspace())?;
        }
        let Simulation { rule, every, longest, .. } = &self.plan;
        limits::check([self.past.time, self.end], rule.control, *every, *longest)?;
        Ok(loosened)
    }

    /// Makes the start ready and shows it.
    pub(super) fn start(&mut self) -> Result<(), Error> {
        let loosened = self.check()?;
        let system = self.plan.system;
        let mut workspace = Dynamics::<L>::workspace(system);
        // In a copy, not shown before all is well: a run that cannot start gives the start back as it was.
        if System::<S, R, C, P>::CLOSED > 0 {
            system.lead(&mut self.next, self.plan.loads, &mut workspace)?;
        }
        system.accelerate(&mut self.next, self.plan.loads, &mut workspace)?;
        if loosened {
            self.stands_between()?;
        } else if const { Self::MODES } {
            self.begin_modes(false)?;
        }
        self.value = self.value(Shown::Next)?;
        core::mem::swap(&mut self.past, &mut self.next);
        self.caused = Some(self.past.clone());
        let size = match self.plan.rule.control {
            Control::Fixed(dt) => dt,
            Control::Tolerance(tolerance) => self.first_step(tolerance),
        };
        self.progress = Progress::at(self.past.time, size);
        self.progress.trials.under(self.plan.rule.control, System::<S, R, C, P>::CLOSED > 0);
        self.show(Shown::Past, false);
        Ok(())
    }

    /// Takes up what another run has left: its memory, and what scene and loads caused where the method has left other accelerations.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub(super) fn take_up(&mut self, memory: &K::Memory, caused: Option<&MotionOf<S, R, C, P>>) -> Result<(), Error> {
        self.check()?;
        if let Some(caused) = caused {
            ensure_finite(caused.is_finite(), "saved run")?;
            if !caused.fits(&self.past) {
                return Err(Error::new(Fault::Shape));
            }
        }
        if !self.stepper.remembers(memory, &self.past) {
            return Err(Error::new(Fault::Shape));
        }
        self.stepper.restore(memory);
        let control = self.plan.rule.control;
        self.progress.fit(self.past.time, control, self.plan.every)?;
        self.progress.trials.under(control, System::<S, R, C, P>::CLOSED > 0);
        self.adapt(caused);
        if const { Self::CUTS } {
            self.settle_anew()?;
        }
        // An event where it stands was seen; what it has led to, another motion maybe, says nothing of the next step.
        if self.progress.at_event
            && let Control::Tolerance(tolerance) = control
        {
            (self.progress.size, self.progress.careful) = (self.progress.size.min(self.first_step(tolerance)), true);
        }
        self.value = if self.progress.at_event { None } else { self.value(Shown::Past)? };
        self.progress.stopped = false;
        Ok(())
    }

    /// Where scene, loads or motion are others than those that were saved, accelerations are: they jump. A method that has left others than
    /// those `caused` goes on from them after the same jump.
    pub(super) fn adapt(&mut self, caused: Option<&MotionOf<S, R, C, P>>) {
        let now = self.caused.insert(settled(self.plan.system, self.plan.loads, &self.past));
        let left = &mut self.past;
        let before = caused.map_or(&left.acceleration, |caused| &caused.acceleration);
        if before.all(&now.acceleration, &mut Scalar::is_identical) {
            if caused.is_none() {
                left.acceleration.set(&now.acceleration); // friction at rest changes with loads where no joint moves
            }
            return;
        }
        if let Some(caused) = caused {
            let (one, stepped) = (RealOf::<S>::one(), left.acceleration.clone());
            left.acceleration.mix_2(&stepped, (one, &now.acceleration), (-one, &caused.acceleration));
        } else {
            left.acceleration.set(&now.acceleration);
        }
        left.multipliers = now.multipliers;
    }

    /// The next step that is accepted; `false` where the run has ended, at its end or at an event.
    ///
    /// It begins with the accelerations that the last one has ended with: where loads are told otherwise between steps (by a `Cell`, say), go on by
    /// [`until`](Self::until).
    ///
    /// # Errors
    /// What kept it from a finite motion within the tolerance; the motion is then that before the step.
    pub fn step(&mut self) -> Result<bool, Error> {
        if self.progress.stopped || self.past.time >= self.end {
            return Ok(false);
        }
        let Taken { size, last, kink, switches, .. } = self.cut_short()?;
        if last {
            self.next.set_time(self.end);
        }
        let progress = self.progress;
        let mut next_value = self.value(Shown::Next)?;
        let outcome = self.shown(self.progress.start, size, [self.value, next_value])?;
        self.progress.steps += 1;
        if let Outcome::Stop = outcome {
            return Ok(self.stop());
        }
        self.progress.at_event = false;
        self.progress.mark.1 += 1;
        if const { Self::CUTS } && switches {
            let changed = self.switch(|run, due| run.pace(due, size)).and_then(|_| self.value(Shown::Next));
            let value = match changed {
                Ok(value) => value,
                Err(error) => {
                    self.progress = progress; // the step is not taken
                    return Err(self.jammed(error));
                }
            };
            self.progress.mark = (self.next.time, 0);
            let before = core::mem::replace(&mut next_value, value);
            if let (Outcome::Continue, Some(before), Some(after)) = (outcome, before, next_value)
                && crosses([before, after])
            {
                // A rate that has come to rest but for rounding is zero only now.
                self.show(Shown::Next, true);
                if self.plan.stop {
                    core::mem::swap(&mut self.past, &mut self.next);
                    return Ok(self.stop());
                }
            }
        }
        if const { Self::KINKS > 0 } && kink && !switches {
            self.stepper.restart();
            self.progress.mark = (self.next.time, 0);
        }
        self.value = next_value;
        core::mem::swap(&mut self.past, &mut self.next);
        Ok(true)
    }

    /// Stops at an event, where the motion stands; no step follows.
    fn stop(&mut self) -> bool {
        (self.progress.stopped, self.progress.at_event) = (true, true);
        self.progress.mark = (self.past.time, 0);
        false
    }

    /// Makes the step anew, of a size (s), with what the stepper carried after it.
    pub(super) fn make_anew(&mut self, memory: &K::Memory, size: RealOf<S>) -> Result<(), Error> {
        self.stepper.restore(memory);
        self.stepper.advance(&self.past, self.plan.loads, size, &mut self.next)
    }

    pub(super) fn interpolate(&mut self, size: RealOf<S>, theta: f64) {
        self.stepper.interpolate(&self.past, self.plan.loads, size, &self.next, theta, &mut self.between);
    }

    /// Shows what there is to see of an accepted step: samples, an event, its end.
    fn shown(&mut self, start: RealOf<S>, size: RealOf<S>, values: [Option<f64>; 2]) -> Result<Outcome, Error> {
        let crossing = match values {
            [before, Some(after)] => {
                let (from, before) = match before {
                    Some(before) if before == 0.0 || self.progress.steps == 0 => {
                        let rounding = RealOf::<S>::EPSILON.sqrt().as_f64();
                        departure([before, after], rounding, &mut |theta| self.value_at(size, theta))?
                    }
                    Some(before) => (0.0, before),
                    None => (DEPARTED, self.value_at(size, DEPARTED)?),
                };
                crosses([before, after]).then(|| self.crossing(size, from, [before, after])).transpose()?
            }
            _ => None,
        };
        if let Some(theta) = crossing {
            self.samples_until(start, size, theta);
            self.interpolate(size, theta);
            self.show(Shown::Between, true);
            if self.plan.stop {
                core::mem::swap(&mut self.past, &mut self.between);
                return Ok(Outcome::Stop);
            }
        }
        let outcome = if crossing.is_some() { Outcome::Event } else { Outcome::Continue };
        self.samples_until(start, size, 1.0);
        if self.plan.every.is_none() {
            self.show(Shown::Next, false);
        }
        Ok(outcome)
    }

    /// Shows the samples up to a share of the step.
    fn samples_until(&mut self, start: RealOf<S>, size: RealOf<S>, share: f64) {
        let Some(every) = self.plan.every else {
            return;
        };
        // A sample that falls on the end of a step but for rounding is its end.
        let rounding = RealOf::<S>::EPSILON * RealOf::<S>::of(4.0) * (self.past.time.abs() + size);
        let rounding = rounding.min(every * RealOf::<S>::of(0.25));
        let slack = 1e-9 * (every / size).as_f64().min(1.0) + (rounding / size).as_f64();
        // None is shown before an event that is earlier.
        let until = if share < 1.0 { share } else { 1.0 + slack };
        loop {
            let time = start + every * RealOf::<S>::of(self.progress.samples as f64);
            let theta = ((time - self.past.time) / size).as_f64();
            if theta > until {
                return;
            }
            self.progress.samples += 1;
            if share >= 1.0 && theta >= 1.0 - slack {
                self.show(Shown::Next, false);
            } else {
                self.interpolate(size, theta);
                self.show(Shown::Between, false);
            }
        }
    }

    /// The value of the event function at a share of the step.
    fn value_at(&mut self, size: RealOf<S>, theta: f64) -> Result<f64, Error> {
        self.interpolate(size, theta);
        Ok(self.value(Shown::Between)?.unwrap_or(0.0))
    }

    /// The share of the step at which the event function crosses zero, after a share at which and at the end of which it has these values.
    fn crossing(&mut self, size: RealOf<S>, from: f64, values: [f64; 2]) -> Result<f64, Error> {
        let share = |part: f64| from + (1.0 - from) * part;
        Ok(share(crossing(values, &mut |part| self.value_at(size, share(part)))?))
    }
}
