//! Running a scene through time: step control, dense output at requested times, events, observers; and single steps, of a [`Stepper`].
//! Many runs at once are an `ensemble` (feature `rayon`).

mod accept;
pub(crate) mod crossing;
mod cut;
mod drive;
#[cfg(feature = "rayon")]
mod ensemble;
pub(crate) mod limits;
mod margin;
mod now;
mod saved;
mod strike;
mod switch;
mod trials;

use crate::element::{Element, Loading, RealOf, Space, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::system::Dynamics;
use crate::system::{MotionOf, Runs, System};
use crate::time::{IntoRule, Rule};
use core::fmt;

pub use crate::observers::EnergyDrift;
#[cfg(feature = "std")]
pub use crate::observers::Trace;
pub use crate::stepper::{
    AdamsMemory, AdamsStepper, AutoMemory, AutoStepper, Chosen, ExplicitStepper, ImplicitMemory, ImplicitStepper,
    Method, MoreauJeanStepper, MotionIn, SdirkStepper, Stepper, StepperOf, TaylorStepper, TimeIn, VcabmMemory,
    VcabmStepper,
};
pub use drive::Running;
#[cfg(feature = "rayon")]
pub use ensemble::{Ensemble, ensemble};
pub use now::Now;
pub use saved::{Progress, Saved};

/// How a run ended.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Run<M> {
    /// The last motion, as the method has left it: an implicit rule and `Vcabm` go on from its accelerations, and forces to be read have those
    /// of [`System::with_accelerations`].
    pub motion: M,
    /// Steps accepted.
    pub steps: usize,
    /// Steps rejected by error control.
    pub rejected: usize,
    /// Sweeps made, without those of readings.
    pub sweeps: usize,
}

/// Why a run ended early, and how far it came.
#[derive(Clone, Debug)]
pub struct Interrupted<M> {
    /// What went wrong.
    pub error: Error,
    /// The last accepted motion.
    pub last: M,
}

impl<M> fmt::Display for Interrupted<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.fmt(f)
    }
}

impl<M: fmt::Debug> core::error::Error for Interrupted<M> {}

impl<M> From<Interrupted<M>> for Error {
    fn from(interrupted: Interrupted<M>) -> Self {
        interrupted.error
    }
}

/// A run to be made: a scene, a rule, and what to look at.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// let mut samples = 0;
/// let run = pendulum
///     .simulation(Dop853::tolerance(1e-10))
///     .every(0.1)
///     .event(|now| now.motion().rate().1.1) // when the second rod comes to rest
///     .run(start, 1.0, |now| samples += usize::from(!now.is_event()))?;
/// assert_eq!(samples, 11);
/// # Ok::<(), catena::Error>(())
/// ```
pub struct Simulation<'a, S: Space, R: Root<S>, C: Element<S>, P, L, M, E> {
    system: &'a System<S, R, C, P>,
    loads: &'a L,
    rule: Rule<M, RealOf<S>>,
    every: Option<RealOf<S>>,
    longest: Option<RealOf<S>>,
    event: E,
    stop: bool,
}

/// No event function.
pub struct NoEvent;

/// A function of the motion whose zeros are located.
pub trait EventFunction<N: ?Sized, T> {
    /// Whether there is one.
    const ON: bool;
    /// Value of the function; none where there is none.
    fn value(&mut self, now: &N) -> Option<T>;
}

impl<N: ?Sized, T> EventFunction<N, T> for NoEvent {
    const ON: bool = false;
    fn value(&mut self, _: &N) -> Option<T> {
        None
    }
}

impl<N: ?Sized, T, F: FnMut(&N) -> T> EventFunction<N, T> for F {
    const ON: bool = true;
    fn value(&mut self, now: &N) -> Option<T> {
        Some(self(now))
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// A stepper of a method for this scene. Its method is no rule: each step is told its size.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let mut stepper = pendulum.stepper(Rk4);
    /// let mut now = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let mut next = now; // a step reads one motion and writes another
    /// for _ in 0..100 {
    ///     stepper.step(&now, &Unloaded, 0.001, &mut next)?; // (s)
    ///     core::mem::swap(&mut now, &mut next);
    /// }
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn stepper<'s, M: Method<&'s Self, L>, L: Loading<S>>(&'s self, method: M) -> M::Stepper
    where
        Self: Dynamics<L>,
    {
        method.stepper(self)
    }

    /// A stepper with the scene inside: for a value that keeps its scene and its stepper.
    pub fn into_stepper<M: Method<Self, L>, L: Loading<S>>(self, method: M) -> M::Stepper
    where
        Self: Dynamics<L>,
    {
        method.stepper(self)
    }

    /// A run to be made by a rule: a method that says how long its steps are.
    pub fn simulation<K: IntoRule<RealOf<S>>>(
        &self,
        rule: K,
    ) -> Simulation<'_, S, R, C, P, Unloaded, K::Method, NoEvent> {
        let rule = rule.into_rule();
        Simulation { system: self, loads: &Unloaded, rule, every: None, longest: None, event: NoEvent, stop: false }
    }

    /// Runs from `start` to the time `end` (s) and shows every accepted step to `observe`, the start included.
    ///
    /// # Errors
    /// Why the run ended early, with the last accepted motion.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn simulate<'s, K: IntoRule<RealOf<S>, Method: Method<&'s Self, Unloaded>>>(
        &'s self,
        start: MotionOf<S, R, C, P>,
        rule: K,
        end: RealOf<S>,
        observe: impl FnMut(&Now<'_, S, R, C, P, Unloaded>),
    ) -> Result<Run<MotionOf<S, R, C, P>>, Interrupted<MotionOf<S, R, C, P>>>
    where
        Self: Runs<Unloaded, S, R, C, P>,
    {
        self.simulation(rule).run(start, end, observe)
    }
}

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E> Simulation<'a, S, R, C, P, L, M, E> {
    /// Under these loads.
    pub fn loads<N: Loading<S>>(self, loads: &'a N) -> Simulation<'a, S, R, C, P, N, M, E> {
        let Self { system, rule, every, longest, event, stop, .. } = self;
        Simulation { system, loads, rule, every, longest, event, stop }
    }

    /// Shown at multiples of an interval (s) from the start, by dense output, instead of at every step.
    #[must_use]
    pub fn every(self, interval: RealOf<S>) -> Self {
        Self { every: Some(interval), ..self }
    }

    /// With no step longer than this (s) where error control chooses them: loads that come and go within a step would not be seen, nor
    /// an event function that crosses zero twice.
    #[must_use]
    pub fn longest_step(self, longest: RealOf<S>) -> Self {
        Self { longest: Some(longest), ..self }
    }

    /// Also shown where a function of the motion crosses zero, once a step, past the first sixteenth where it begins at one. A run that begins
    /// at a zero but for rounding, as where an event has ended another, does not find that one. Not over lanes.
    pub fn event<F>(self, function: F) -> Simulation<'a, S, R, C, P, L, M, F>
    where
        F: FnMut(&Now<'_, S, R, C, P, L>) -> S::Scalar,
    {
        let Self { system, loads, rule, every, longest, stop, .. } = self;
        Simulation { system, loads, rule, every, longest, event: function, stop }
    }

    /// Stops where the event function crosses zero. Times are plain numbers: jets and dual numbers have there the derivatives at a fixed time.
    #[must_use]
    pub fn stopping(self) -> Self {
        Self { stop: true, ..self }
    }

    /// Runs from `start` to the time `end` (s).
    ///
    /// # Errors
    /// Why the run ended early, with the last accepted motion.
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn run(
        self,
        start: MotionOf<S, R, C, P>,
        end: RealOf<S>,
        observe: impl FnMut(&Now<'_, S, R, C, P, L>),
    ) -> Result<Run<MotionOf<S, R, C, P>>, Interrupted<MotionOf<S, R, C, P>>>
    where
        System<S, R, C, P>: Runs<L, S, R, C, P>,
        M: Method<&'a System<S, R, C, P>, L>,
        E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    {
        self.begin(start, end, observe)?.finish()
    }
}
