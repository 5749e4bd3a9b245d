//! Steps of a scene over jets, those of the rule itself.

use super::{Sensitivity, ThroughGains};
use crate::element::{Element, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::lift::Lift;
use crate::relation::Open;
use crate::sensitive::{Effort, Sensitive, Varied};
use crate::stepper::{ExplicitStepper, Method, Stepper};
use crate::system::{Elements, MotionOf, Runs, System};
use crate::time::Explicit;

/// Steps whose derivatives go through kept gains.
pub struct SensitiveStepper<'s, S, R, C, P, L, M>(ExplicitStepper<Sensitivity<'s, S, R, C, P>, L, M>)
where
    S: Varied,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S, Closures = Open>,
    L: Loading<S, InJoint: Effort<S>>,
    M: Explicit,
    Elements<S, R, C>: Sensitive<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>;

impl<'s, S, R, C, P, L, M> Method<&'s System<S, R, C, P>, L> for ThroughGains<M>
where
    S: Varied,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S, Closures = Open>,
    L: Loading<S, InJoint: Effort<S>>,
    M: Explicit,
    Elements<S, R, C>: Sensitive<S> + Lift<S::Scalar, S::Number, Over = <Elements<S, R, C> as Sensitive<S>>::Plain>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    type Stepper = SensitiveStepper<'s, S, R, C, P, L, M>;

    fn stepper(&self, scene: &'s System<S, R, C, P>) -> Self::Stepper {
        SensitiveStepper(Method::<Sensitivity<'s, S, R, C, P>, L>::stepper(&self.0, scene.sensitivity()))
    }
}

impl<'s, S, R, C, P, L, M> Stepper<&'s System<S, R, C, P>, L> for SensitiveStepper<'s, S, R, C, P, L, M>
where
    S: Varied,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S, Closures = Open>,
    L: Loading<S, InJoint: Effort<S>>,
    M: Explicit,
    Elements<S, R, C>: Sensitive<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    fn admit(
        &self,
        past: &MotionOf<S, R, C, P>,
        loads: &L,
        dt: RealOf<S>,
        next: &MotionOf<S, R, C, P>,
    ) -> Result<(), Error> {
        self.0.admit(past, loads, dt, next)
    }
    fn begin(&mut self, past: &MotionOf<S, R, C, P>, loads: &L) {
        self.0.begin(past, loads);
    }
    fn resume(&mut self, past: &MotionOf<S, R, C, P>) {
        self.0.resume(past);
    }
    fn make(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        loads: &L,
        dt: RealOf<S>,
        next: &mut MotionOf<S, R, C, P>,
    ) -> Result<(), Error> {
        self.0.make(past, loads, dt, next)
    }
    fn error(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        dt: RealOf<S>,
        next: &MotionOf<S, R, C, P>,
        tolerance: RealOf<S>,
    ) -> Option<RealOf<S>> {
        self.0.error(past, dt, next, tolerance)
    }
    fn error_order(&self) -> usize {
        self.0.error_order()
    }
    fn interpolate(
        &mut self,
        past: &MotionOf<S, R, C, P>,
        loads: &L,
        dt: RealOf<S>,
        next: &MotionOf<S, R, C, P>,
        theta: f64,
        between: &mut MotionOf<S, R, C, P>,
    ) {
        self.0.interpolate(past, loads, dt, next, theta, between);
    }
    fn sweeps(&self) -> usize {
        self.0.sweeps()
    }

    type Memory = ();

    fn memory(&self) {}

    fn restore(&mut self, (): &()) {}
}
