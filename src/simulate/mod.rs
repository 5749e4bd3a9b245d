//! Running a scene through time: step control, dense output at requested times, events, observers; and single steps, of a [`Stepper`].
//! Many runs at once are an `ensemble` (feature `rayon`).

mod accept;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) mod anew;
pub(crate) mod crossing;
mod cut;
mod drive;
#[cfg(feature = "rayon")]
mod ensemble;
mod events;
mod jump;
mod kinks;
pub(crate) mod limits;
mod locate;
mod now;
mod prescribed;
mod saved;
mod settle;
mod shock;
mod shown;
mod strike;
mod surplus;
mod switch;
mod told;
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
    Method, MoreauJeanStepper, MotionIn, SdirkStepper, Stepper, StepperOf, TaylorMemory, TaylorStepper, TimeIn,
    VcabmMemory, VcabmStepper,
};
pub use drive::Running;
#[cfg(feature = "rayon")]
pub use ensemble::{Ensemble, ensemble};
pub use events::EventFunction;
use events::{Event, Kinks, Unwatched, Watched};
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
    /// Whether an event has ended it.
    #[cfg_attr(feature = "serde", serde(default))]
    pub at_event: bool,
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
    ) -> Simulation<'_, S, R, C, P, Unloaded, K::Method, Watched<Unwatched, Unwatched>> {
        let rule = rule.into_rule();
        let event = Watched { event: Unwatched, kinks: Unwatched };
        Simulation { system: self, loads: &Unloaded, rule, every: None, longest: None, event, stop: false }
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

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, M, E> Simulation<'a, S, R, C, P, Unloaded, M, E> {
    /// Under these loads.
    pub fn loads<N: Loading<S>>(self, loads: &'a N) -> Simulation<'a, S, R, C, P, N, M, E> {
        let Self { system, rule, every, longest, event, stop, .. } = self;
        Simulation { system, loads, rule, every, longest, event, stop }
    }
}

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E> Simulation<'a, S, R, C, P, L, M, E> {
    /// Shown at multiples of an interval (s) from the start, by dense output, instead of at every step.
    #[must_use]
    pub fn every(self, interval: RealOf<S>) -> Self {
        Self { every: Some(interval), ..self }
    }

    /// With no step longer than this (s) where error control chooses them: loads that come and go within a step would not be seen, nor
    /// an event function that crosses zero twice. Fixed steps that are longer are refused.
    #[must_use]
    pub fn longest_step(self, longest: RealOf<S>) -> Self {
        Self { longest: Some(longest), ..self }
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

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, K>
    Simulation<'a, S, R, C, P, L, M, Watched<Unwatched, K>>
{
    /// Also shown where a function of the motion crosses zero, once a step, past the first sixteenth where it begins at one. A rate that a shock
    /// turns round crosses it in the step after the shock, unless it is back by the end of that. The least of several functions that are positive crosses
    /// zero with the first of them. A run that begins at a zero but for rounding, as where an event has ended another, does not find that one. Not
    /// over lanes.
    pub fn event<F>(self, function: F) -> Simulation<'a, S, R, C, P, L, M, Watched<Event<F>, K>>
    where
        F: FnMut(&Now<'_, S, R, C, P, L>) -> S::Scalar,
    {
        let Self { system, loads, rule, every, longest, event: Watched { kinks, .. }, stop } = self;
        let event = Watched { event: Event(function), kinks };
        Simulation { system, loads, rule, every, longest, event, stop }
    }
}

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>, M, E>
    Simulation<'a, S, R, C, P, L, M, Watched<E, Unwatched>>
{
    /// With steps that end where one of several functions of the motion crosses zero, the earliest first, and begin anew there: where a load has a
    /// kink. A rule keeps its order across it, error control does not hunt for it, and rules that remember steps forget them.
    ///
    /// Functions change sign: `x - 1`, not the part of it that acts, which is nothing on one side and does not tell where that begins.
    ///
    /// A load itself must not jump there: what comes to a stop or sticks is a joint with modes ([`Coulomb`](crate::planar::Coulomb),
    /// [`HardStops`](crate::planar::HardStops)). One that crosses zero twice within a step is not seen
    /// ([`longest_step`](Self::longest_step)). Functions of positions and rates read [`Now::stepped`], for which no rule makes a sweep. Fixed steps
    /// count anew from the end of such a step. Not over lanes, each of which would have kinks of its own.
    ///
    /// ```
    /// use catena::planar::*;
    /// // A car (2 kg) on a line that meets a buffer (50 N/m) at 1 m.
    /// let body = RigidBody::new(2.0, 1.0, [0.0; 2], [0.0; 2]);
    /// let car = System::new(Clamped::origin(), (Slider::along(0.0), body), Free)?;
    /// let buffer = Loads::none().in_joints(|_, _, motion: &JointMotion<f64>| -50.0 * (motion.driven() - 1.0).max(0.0));
    /// let mut start = car.motion();
    /// start.set_rates(&[3.0])?; // (m/s)
    /// let run = car.simulation(Dop853::step(0.1)).loads(&buffer).kinks(|now| [now.stepped().position().1.0 - 1.0]);
    /// let end = run.run(start, 1.5, |_| ())?.motion; // it meets the buffer after 1/3 s, and is thrown back π/5 s later
    /// let exact = 1.0 - 3.0 * (1.5 - 1.0 / 3.0 - core::f64::consts::PI / 5.0);
    /// assert!((end.position().1.0 - exact).abs() < 1e-8); // 0.012 if kinks are not told
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn kinks<F, const COUNT: usize>(
        self,
        functions: F,
    ) -> Simulation<'a, S, R, C, P, L, M, Watched<E, Kinks<F, COUNT>>>
    where
        F: FnMut(&Now<'_, S, R, C, P, L>) -> [S::Scalar; COUNT],
    {
        let Self { system, loads, rule, every, longest, event: Watched { event, .. }, stop } = self;
        let event = Watched { event, kinks: Kinks::of(functions) };
        Simulation { system, loads, rule, every, longest, event, stop }
    }
}
