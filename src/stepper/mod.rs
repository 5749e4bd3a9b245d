//! Steppers: what a rule needs for one scene, and the step itself.

mod adams;
mod auto;
mod between;
pub(crate) mod displace;
pub(crate) mod explicit;
mod implicit;
mod moreau_jean;
pub(crate) mod roots;
mod sdirk;
mod taylor;
mod vcabm;

use crate::error::{Cause, Error, Fault};
use crate::mirror::margin::margin;
use crate::mirror::{Mode, Position};
use crate::motion::Motion;
use crate::scalar::{Real, Scalar};
use crate::system::Dynamics;
use num_traits::{One, Zero};

pub use adams::{AdamsMemory, AdamsStepper};
pub use auto::{AutoMemory, AutoStepper, Chosen};
pub use explicit::ExplicitStepper;
pub use implicit::{ImplicitMemory, ImplicitStepper};
pub use moreau_jean::MoreauJeanStepper;
pub use sdirk::SdirkStepper;
pub use taylor::{TaylorMemory, TaylorStepper};
pub use vcabm::{VcabmMemory, VcabmStepper};

/// The motion of a scene described by `D`.
pub type MotionIn<D, L> =
    Motion<<D as Dynamics<L>>::Scalar, <D as Dynamics<L>>::Position, <D as Dynamics<L>>::Closures>;
/// Time in a scene described by `D`.
pub type TimeIn<D, L> = <<D as Dynamics<L>>::Scalar as Scalar>::Real;

/// The stepper of a method for scenes `D` with loads `L`, to be named in a struct.
pub type StepperOf<M, D, L> = <M as Method<D, L>>::Stepper;

/// Refuses motions of another scene, and steps that are none.
fn check<D: Dynamics<L>, L>(
    still: &MotionIn<D, L>,
    past: &MotionIn<D, L>,
    next: &MotionIn<D, L>,
    dt: TimeIn<D, L>,
) -> Result<(), Error> {
    if !(past.fits(still) && past.fits(next)) {
        return Err(Error::new(Fault::Shape));
    }
    advances(dt)
}

/// Refuses a step that does not go on.
pub(crate) fn advances<R: Real>(step: R) -> Result<(), Error> {
    if step.is_finite() && step > R::zero() {
        return Ok(());
    }
    Err(Error::new(Fault::NotPositive { parameter: "step size", value: step.as_f64() }))
}

/// Refuses a joint whose mode has another sign than its rate, which friction would drive, and one that is beyond the range between its stops. Of
/// `next` it makes a copy.
fn moves_as_modes_say<D: Dynamics<L>, L>(past: &MotionIn<D, L>, next: &mut MotionIn<D, L>) -> Result<(), Error> {
    if const { !D::Position::MODES } {
        return Ok(());
    }
    next.copy_state(past);
    let (mut wrong, touching) = (None, TimeIn::<D, L>::one() + Mode::touch());
    next.position.each_mode(&mut next.rate, &past.acceleration, &mut |mode, rate, told| {
        let moves = !mode.is_locked() || (told.guard * *rate).real() > Zero::zero();
        if told.stops && moves && told.guard.real().abs() > touching {
            wrong = wrong.or(Some("a step of a joint from beyond its hard stop: runs end steps there, single ones do not"));
        } else if (mode.sign::<D::Scalar>() * *rate).real() < Zero::zero() {
            wrong = wrong.or(Some("a step of a joint with dry friction that moves against its mode: runs change modes, single steps do not"));
        }
    });
    wrong.map_or(Ok(()), |what| Err(Error::new(Fault::Unsupported { what }).at_time(past.time.as_f64())))
}

/// Refuses the end of a step at which a joint is held by more than its friction, or pulled off the stop at which it rests.
fn holds_as_modes_say<D: Dynamics<L>, L>(next: &mut MotionIn<D, L>) -> Result<(), Error> {
    if const { !D::Position::MODES } {
        return Ok(());
    }
    let (mut let_go, rounding) = (false, Mode::reluctance::<TimeIn<D, L>>().as_f64());
    next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
        let_go |= mode.is_locked() && margin(*mode, *rate, &told) < -rounding;
    });
    let what = "a step of a joint that its friction holds no longer, or that leaves its stop: runs, and steps by `MoreauJean`, let it go, other single steps do not";
    if let_go { Err(Error::new(Fault::Unsupported { what }).at_time(next.time.as_f64())) } else { Ok(()) }
}

/// Refuses scenes with joints that have modes over lanes, each of which would have changes of mode of its own.
pub(crate) fn modes_of_one<T: Scalar>(modes: bool) -> Result<(), Error> {
    let what = "lanes of a run in which joints stick and slip or strike stops";
    if modes && T::LANES { Err(Error::new(Fault::Unsupported { what })) } else { Ok(()) }
}

/// Modes that do not belong together, at a joint of those with modes.
pub(crate) fn inconsistent<R: Real>(joint: usize, time: R) -> Error {
    let cause = Cause::Modes { joint };
    Error::new(Fault::StepTooSmall { step: 0.0, cause }).at_time(time.as_f64())
}

/// Where an implicit step went wrong: at its start, whose accelerations `stage` has, or where its first geometry or springs are.
#[cold]
fn of_prediction<D: Dynamics<L>, L>(
    scene: &D,
    mut stage: MotionIn<D, L>,
    loads: &L,
    dt: TimeIn<D, L>,
    workspace: &mut D::Workspace,
) -> Error {
    if stage.is_finite() {
        let start = stage.position.clone();
        stage.time += dt;
        stage.position.drift_0(&start, (dt, &stage.rate));
    }
    of_stage(scene.diagnose(&stage, loads, workspace))
}

/// What is wrong with a stage of a step: one that leaps out of the range of angles says no more than that the step is too long.
fn of_stage(error: Error) -> Error {
    match error.fault {
        Fault::AngleOutOfRange { .. } => Error { fault: Fault::NonFiniteMotion, ..error },
        _ => error,
    }
}

/// A method that can make steppers for scenes `D` with loads `L`: `Rk4`, which is told the size of every step, rather than the rule
/// `Rk4::step(0.001)` of a run.
#[diagnostic::on_unimplemented(
    message = "`{Self}` makes no steps of `{D}` under loads `{L}`",
    label = "not a method for this scene",
    note = "as for `Taylor`: it knows rods, rigid bodies, point masses, pins, welds, sliders and rotary springs and dampers of the plane, and of space rods, rigid bodies, point masses, balls, welds and revolute joints with springs and dampers, in chains, trees and loops (closed by pins, balls and welds) on ground that rests, with tips that are free or held, under gravity, efforts in joints that are values or functions of time, and loads on bodies that are values or laws written for any number (`Loads::on_bodies_over_time`): `Taylor::<12>::knows(&scene)` names what it does not know; `AutoTaylor` knows the same",
    note = "as for `through_gains`: it goes by explicit rules over jets or dual numbers, through open chains and trees with free tips of shipped elements, but `Cylindrical`, linear springs of hinges, springs of balls, `Flange`, joints that are driven or have modes: without `.through_gains()` the rule itself goes through all of them",
    note = "of loads on bodies `Contacts` act on links of `catena::robot`: on bodies in inertial axes take `contacts.plain()`",
    note = "`Dop853` runs all scenes"
)]
pub trait Method<D: Dynamics<L>, L> {
    /// Stepper of the method.
    type Stepper: Stepper<D, L>;

    /// A stepper for a scene, or for a reference to one.
    fn stepper(&self, scene: D) -> Self::Stepper;
}

/// Advances the motion of one scene. It owns its workspace: a step allocates nothing, costs the same every time, reads one
/// motion and writes another, so that a step that fails loses nothing.
pub trait Stepper<D: Dynamics<L>, L> {
    /// Whether a step leaves the accelerations that positions, rates and loads cause at its end. Otherwise they are those of its last
    /// iteration, which the next step goes on with: [`System::accelerate`](crate::system::System::accelerate) finds the true ones,
    /// in a copy, and so do the readings of a run.
    const SETTLED: bool = true;
    /// Whether [`propose`](Self::propose) says how long the step after an accepted one should be: what a run finds from its error may be rough.
    const PLANS: bool = false;
    /// Whether steps change modes of joints with friction or hard stops themselves: a run then ends no step where a mode changes.
    const SWITCHES: bool = false;

    /// One step of size `dt` (s) from `past` under `loads`, written to `next`.
    ///
    /// The accelerations at the start are found anew, because loads may have changed since they were.
    ///
    /// # Errors
    /// What kept the step from a finite motion, with time and station; `next` is then undefined and `past` as it was. An implicit
    /// method also refuses a step that is not positive and finite, and parameters that make no rule. [`Fault::Unsupported`] where a joint
    /// with dry friction has come to move against the mode that a run has left it in, where one is beyond its hard stop, and where at the end of the step one
    /// sticks that its friction cannot hold, or rests against a stop that it would leave: runs, and steps by `MoreauJean`, let it go.
    fn step(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.admit(past, loads, dt, next)?;
        if const { !Self::SWITCHES } {
            moves_as_modes_say::<D, L>(past, next)?;
        }
        self.begin(past, loads);
        self.make(past, loads, dt, next)?;
        if const { Self::SWITCHES } { Ok(()) } else { holds_as_modes_say::<D, L>(next) }
    }

    /// Advances by a step where `past` holds the accelerations that belong to it under these loads: one sweep less.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    fn advance(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.admit(past, loads, dt, next)?;
        self.resume(past);
        self.make(past, loads, dt, next)
    }

    /// Refuses loads that do not fit the scene, motions of another scene and what else makes no step.
    ///
    /// # Errors
    /// What is wrong with them.
    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error>;

    /// Finds the accelerations at the start of a step, if the method asks for them.
    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        let _ = (past, loads);
    }

    /// Takes those that the start has.
    fn resume(&mut self, past: &MotionIn<D, L>) {
        let _ = past;
    }

    /// The step from a start that [`begin`](Self::begin) or [`resume`](Self::resume) has met.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error>;

    /// The size (s) of a step from `past` that errs by `tolerance`, of a method that knows before it steps; none of one that has to try. A method that
    /// finds in a step that it has to leave it to another one may end it before half its size, as the time of its end says.
    fn propose(&mut self, past: &MotionIn<D, L>, loads: &L, tolerance: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        let _ = (past, loads, tolerance);
        None
    }

    /// Estimated error of the last step as a multiple of `tolerance` (absolute and relative), root of the mean square over
    /// positions and rates; `None` for a method without an estimate.
    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>>;

    /// Order of the error estimate: a step of half the size has an error 2^−order as large.
    fn error_order(&self) -> usize;

    /// Whether closures hold the end of the last step firmly: whether each keeps more than the `least` share of what a free body would
    /// yield to it. Where they are all but dependent, accelerations are lost in rounding, and a method that goes on from these should not
    /// end its step there.
    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        let _ = (next, least);
        true
    }

    /// Motion at the share `theta` of the last step, between `past` and `next`. Its accelerations are found by a sweep, so that
    /// forces belong to it. An implicit method steps there: between stiff joints an interpolation would strain them.
    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    );

    /// Sweeps made so far.
    fn sweeps(&self) -> usize;

    /// What the stepper carries from step to step besides the motion.
    type Memory: Clone;

    /// A copy of what the stepper carries. With it and the last motion, another stepper of the same method for the same scene goes on bit
    /// by bit as this one would.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let mut stepper = pendulum.stepper(Adams); // it remembers four motions
    /// let mut now = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let mut next = now;
    /// for _ in 0..10 {
    ///     stepper.step(&now, &Unloaded, 0.01, &mut next)?;
    ///     core::mem::swap(&mut now, &mut next);
    /// }
    /// let saved = (now, stepper.memory());
    /// stepper.step(&now, &Unloaded, 0.01, &mut next)?;
    ///
    /// let mut other = pendulum.stepper(Adams); // later, elsewhere
    /// let mut resumed = saved.0;
    /// other.restore(&saved.1);
    /// other.step(&saved.0, &Unloaded, 0.01, &mut resumed)?;
    /// assert_eq!(resumed, next);
    /// # Ok::<(), catena::Error>(())
    /// ```
    fn memory(&self) -> Self::Memory;

    /// Whether a memory is one that this stepper can go on from at a motion: one that was read as data may be of a scene with vectors of
    /// other lengths, or of none. [`Simulation::resume`](crate::simulate::Simulation::resume) refuses others.
    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        let _ = (memory, motion);
        true
    }

    /// Goes on from what another one carried.
    fn restore(&mut self, memory: &Self::Memory);

    /// Forgets what it carries that steps after a kink of a load must not read.
    fn restart(&mut self) {}
}
