//! Steppers: what a rule needs for one scene, and the step itself.

mod adams;
mod displace;
mod explicit;
mod implicit;
mod sdirk;

use crate::error::{Error, Fault};
use crate::motion::Motion;
use crate::scalar::{Real, Scalar};
use crate::system::Dynamics;
use num_traits::Zero;

pub use adams::AdamsStepper;
pub use explicit::ExplicitStepper;
pub use implicit::ImplicitStepper;
pub use sdirk::SdirkStepper;

/// The motion of a scene described by `D`.
pub type MotionIn<D, L> =
    Motion<<D as Dynamics<L>>::Scalar, <D as Dynamics<L>>::Position, <D as Dynamics<L>>::Closures>;
/// Time in a scene described by `D`.
pub type TimeIn<D, L> = <<D as Dynamics<L>>::Scalar as Scalar>::Real;

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
    if dt.is_finite() && dt > Zero::zero() {
        Ok(())
    } else {
        Err(Error::new(Fault::NotPositive { parameter: "step size", value: dt.as_f64() }))
    }
}

/// A method that can make steppers for scenes `D` with loads `L`.
pub trait Method<D: Dynamics<L>, L> {
    /// Its stepper.
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

    /// One step of size `dt` (s) from `past` under `loads`, written to `next`.
    ///
    /// The accelerations at the start are found anew, because loads may have changed since they were.
    ///
    /// # Errors
    /// What kept the step from a finite motion, with time and station; `next` is then undefined and `past` as it was. An implicit
    /// method also refuses a step that is not positive and finite, and parameters that make no rule.
    fn step(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error>;

    /// The same where `past` holds the accelerations that belong to it under these loads: one sweep less.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    fn advance(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error>;

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
    fn error_order(&self) -> f64;

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
}
