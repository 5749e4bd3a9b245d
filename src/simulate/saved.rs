//! Runs that are saved and go on later, bit by bit as if they had never stopped.

#[cfg(feature = "serde")]
mod data;

use super::drive::Running;
use super::limits::{MOST, at_least};
use super::now::settled;
use super::trials::Trials;
use super::{EventFunction, Interrupted, Now, Run, Simulation};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, ensure_finite};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::stepper::{Method, Stepper};
use crate::system::{MotionOf, Runs, System};
use crate::time::Control;
use num_traits::Zero;

/// How far a run has come, besides its motion and what its stepper carries.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Progress<R> {
    /// When the run began (s): samples count from there.
    pub(super) start: R,
    /// When the run began, or began anew after an event (s), and the number of steps since: fixed steps are multiples from there.
    pub(super) mark: (R, usize),
    /// The size (s) of the step that error control wants next, or of fixed steps.
    pub(super) size: R,
    /// Whether the last trial was rejected.
    pub(super) careful: bool,
    /// What has come of trials so far.
    pub(super) trials: Trials<R>,
    /// Whether an event has ended the run.
    pub(super) stopped: bool,
    /// Whether the motion is that of an event which did, wherever the run is to end now.
    pub(super) at_event: bool,
    /// Number of the next sample.
    pub(super) samples: usize,
    pub(super) steps: usize,
    pub(super) rejected: usize,
    /// Sweeps made before the run was saved.
    pub(super) sweeps: usize,
}

impl<R: Real> Progress<R> {
    /// The progress of a run which begins at a time (s), with the size of its first step (s).
    pub(super) fn at(start: R, size: R) -> Self {
        Self {
            start,
            mark: (start, 0),
            size,
            careful: false,
            trials: Trials::new(start),
            stopped: false,
            at_event: false,
            samples: 1,
            steps: 0,
            rejected: 0,
            sweeps: 0,
        }
    }

    /// Fits a progress to the motion that a run goes on from: fixed steps of another size, or samples at another interval, count from there.
    ///
    /// # Errors
    /// [`NotFinite`](crate::Fault::NotFinite) and [`OutOfRange`](crate::Fault::OutOfRange) for numbers from which no run goes on, as they may be read from data.
    pub(super) fn fit(&mut self, time: R, control: Control<R>, every: Option<R>) -> Result<(), Error> {
        let Self { start, mark, size, samples, steps, rejected, sweeps, .. } = self;
        let counts = [mark.1, *samples, *steps, *rejected, *sweeps].iter().all(|count| *count <= usize::MAX / 2);
        let times = [*start, mark.0, *size].iter().all(|time| time.is_finite());
        ensure_finite(counts && times && self.trials.is_sound(), "progress of a run")?;
        at_least("size of a saved run's next step", size.as_f64(), 0.0, "runs go on")?;
        at_least("time of a saved run", time.as_f64(), start.as_f64(), "it lies before the start")?;
        let count = |n: usize| R::of(n as f64);
        if let Control::Fixed(dt) = control {
            // A last step may have been cut to its end.
            let missed = mark.0 + dt * count(mark.1) - time;
            let rounding = (R::of(1e6) * R::EPSILON).min(R::of(1e-3));
            if *size != dt || missed.abs() > dt * rounding {
                (*mark, *size) = ((time, 0), dt);
            }
        }
        if let Some(every) = every {
            let next = *start + every * count(*samples) - time;
            let rounding = every * R::of(1e-9) + (start.abs() + time.abs() + every) * R::EPSILON * R::of(8.0);
            let rounding = rounding.min(every * R::of(0.25));
            if !(next >= -rounding && next <= every + rounding + rounding) {
                let passed = ((time - *start) / every).as_f64();
                ensure_finite(passed <= MOST, "progress of a run")?;
                *samples = (passed as usize).saturating_add(1);
            }
        }
        Ok(())
    }
}

/// Where a run stands between two steps: a value to clone, to keep, and to [`resume`](Simulation::resume) from.
///
/// With the feature `serde` it is data, as scenes, motions, rules and errors are: it can be written in any format that keeps all bits of
/// a number (of `serde_json` the feature `float_roundtrip`), and what is read goes on bit by bit as what was written. Scenes, motions and
/// memories begin with the names of their types, such as `(Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free)`: others are
/// refused by these names. A scene is checked as by [`System::new`], a saved run by [`resume`](Simulation::resume). Arrays have at most 32
/// items, tuples 16; longer chains are vectors. Functions (moving ground, laws that are closures) are no data: such a scene
/// is built anew, and its runs are data all the same. Names of elements and the words of errors are `&'static str`: what has any is
/// read from text that lives as long as the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved<M, K, R> {
    /// The last motion, with its accelerations as the method has left them.
    pub motion: M,
    /// That motion with the accelerations that scene and loads caused, where the method has left others: a run that goes on compares them with
    /// those that are caused then.
    pub caused: Option<M>,
    /// What the stepper carries.
    pub memory: K,
    /// Steps, samples and the size of the next step.
    pub progress: Progress<R>,
}

/// What a run of a scene saves.
type SavedOf<S, R, C, P, K> = Saved<MotionOf<S, R, C, P>, K, RealOf<S>>;

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E> Simulation<'a, S, R, C, P, L, M, E> {
    pub(super) fn running<O>(
        self,
        past: MotionOf<S, R, C, P>,
        end: RealOf<S>,
        observe: O,
        progress: Progress<RealOf<S>>,
    ) -> Running<'a, S, R, C, P, L, M, E, M::Stepper, O>
    where
        System<S, R, C, P>: Runs<L, S, R, C, P>,
        M: Method<&'a System<S, R, C, P>, L>,
    {
        let stepper = self.rule.method.stepper(self.system);
        let (next, between) = (past.clone(), past.clone());
        Running { plan: self, end, stepper, past, next, between, observe, progress, value: None, caused: None }
    }

    /// A run from `start` to the time `end` (s), to be made step by step, and saved between steps.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let start = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let simulation = || pendulum.simulation(Dop853::tolerance(1e-9)).every(0.1);
    ///
    /// let mut run = simulation().begin(start, 2.0, |_| ())?;
    /// run.until(1.0)?; // to the first step that ends there or later
    /// let saved = run.save();
    /// let whole = run.finish()?;
    ///
    /// let resumed = simulation().resume(saved, 2.0, |_| ())?.finish()?; // in another process, say
    /// assert_eq!(resumed.motion, whole.motion);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// What makes no run, with the start as it was.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn begin<O>(
        self,
        start: MotionOf<S, R, C, P>,
        end: RealOf<S>,
        observe: O,
    ) -> Result<Running<'a, S, R, C, P, L, M, E, M::Stepper, O>, Interrupted<MotionOf<S, R, C, P>>>
    where
        System<S, R, C, P>: Runs<L, S, R, C, P>,
        M: Method<&'a System<S, R, C, P>, L>,
        E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
        O: FnMut(&Now<'_, S, R, C, P, L>),
    {
        let begun = Progress::at(start.time, Zero::zero());
        let mut run = self.running(start, end, observe, begun);
        match run.start() {
            Ok(()) => Ok(run),
            Err(error) => Err(Interrupted { error: run.jammed(error), last: run.past }),
        }
    }

    /// The rest of a run that was saved: the same, bit by bit, if scene, loads, rule, samples and end are. Only steps that follow are shown.
    ///
    /// After an event that ended it, it goes on from there: the event is not found again, and fixed steps count from it. Another event is
    /// looked for after the first thousandth of the first step, which error control chooses anew. A run to another end is the same up to its
    /// last step, which is cut to end there.
    ///
    /// Scene (gravity, for example), loads and motion (rates after an impact) may have changed, tolerance and step size too: steps begin with
    /// accelerations that belong to them, and methods that remember motions begin anew where these have jumped.
    ///
    /// # Errors
    /// As [`begin`](Self::begin); [`Shape`](crate::Fault::Shape) for a run of another scene, [`NotFinite`](crate::Fault::NotFinite) for data
    /// that no run has saved.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn resume<O>(
        self,
        saved: SavedOf<S, R, C, P, <M::Stepper as Stepper<&'a System<S, R, C, P>, L>>::Memory>,
        end: RealOf<S>,
        observe: O,
    ) -> Result<Running<'a, S, R, C, P, L, M, E, M::Stepper, O>, Interrupted<MotionOf<S, R, C, P>>>
    where
        System<S, R, C, P>: Runs<L, S, R, C, P>,
        M: Method<&'a System<S, R, C, P>, L>,
        E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
        O: FnMut(&Now<'_, S, R, C, P, L>),
    {
        let mut run = self.running(saved.motion, end, observe, saved.progress);
        match run.take_up(&saved.memory, saved.caused.as_ref()) {
            Ok(()) => Ok(run),
            Err(error) => Err(Interrupted { error: run.jammed(error), last: run.past }),
        }
    }
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
    /// The last motion.
    pub fn motion(&self) -> &MotionOf<S, R, C, P> {
        &self.past
    }

    /// That in which the last step began, with modes that have changed there.
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))] // for gradients
    pub(crate) fn began(&self) -> &MotionOf<S, R, C, P> {
        &self.next
    }

    /// The stepper, to be asked what its rule knows of itself.
    pub fn stepper(&self) -> &K {
        &self.stepper
    }

    /// The state of the run, to be gone on from.
    pub fn save(&self) -> SavedOf<S, R, C, P, K::Memory> {
        let progress = Progress { sweeps: self.sweeps(), ..self.progress };
        let caused = settled(self.plan.system, self.plan.loads, &self.past);
        let other = !caused.acceleration.all(&self.past.acceleration, &mut Scalar::is_identical);
        let caused = (other && caused.is_finite()).then_some(caused);
        Saved { motion: self.past.clone(), caused, memory: self.stepper.memory(), progress }
    }

    fn sweeps(&self) -> usize {
        self.progress.sweeps + self.stepper.sweeps()
    }

    /// All steps that are left.
    ///
    /// # Errors
    /// Why the run ended early, with the last accepted motion.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn finish(mut self) -> Result<Run<MotionOf<S, R, C, P>>, Interrupted<MotionOf<S, R, C, P>>> {
        loop {
            match self.step() {
                Ok(true) => (),
                Ok(false) => break,
                Err(error) => return Err(Interrupted { error, last: self.past }),
            }
        }
        let (sweeps, Progress { steps, rejected, .. }) = (self.sweeps(), self.progress);
        Ok(Run { motion: self.past, steps, rejected, sweeps, at_event: self.progress.stopped })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A last step cut to 0.095 s is no step of 0.1 s but for rounding, in any number.
    #[test]
    fn a_run_that_goes_on_after_a_shorter_last_step_counts_from_there() {
        fn mark<R: Real>() -> (f64, usize) {
            let [dt, time] = [0.1, 0.995].map(R::of);
            let mut progress = Progress { mark: (R::zero(), 10), ..Progress::at(R::zero(), dt) };
            assert_eq!(progress.fit(time, Control::Fixed(dt), None), Ok(()));
            (progress.mark.0.as_f64(), progress.mark.1)
        }
        assert_eq!(mark::<f64>(), (0.995, 0));
        assert_eq!(mark::<f32>(), (f64::from(0.995_f32), 0));
    }
}
