//! Steps by Taylor series.

mod bridge;
mod lead;
mod reach;
mod shown;
mod sums;

use super::between::complete;
use super::explicit::ExplicitStepper;
use super::{Method, MotionIn, Stepper, TimeIn};
use crate::element::{Element, Unloaded};
use crate::ends::{ExpandTip, Resting};
use crate::error::{Error, Fault};
use crate::mirror::{Rate, Retraction};
use crate::motion::Motion;
use crate::scalar::{Real, Scalar};
use crate::series::{Expand, Expandable};
use crate::system::{Elements, SeriesDynamics, System};
use crate::time::{Dop853, Taylor};
pub use bridge::TaylorMemory;
use lead::NEAR;
use num_traits::Zero;
use reach::order_for;

/// Steps by [`Taylor`].
pub struct TaylorStepper<D: SeriesDynamics<L, P>, L, const P: usize> {
    /// Steps over places where closures depend on each other. It owns the scene, and room for readings within a step.
    pub(super) stages: ExplicitStepper<D, L, Dop853>,
    /// Whether stages made the last step, and where they make the next ones.
    led: bool,
    /// Whether the last step by them was made in two.
    divided: bool,
    memory: TaylorMemory<TimeIn<D, L>>,
    series: D::Series,
    /// Motion at which the series was expanded.
    origin: MotionIn<D, L>,
    expanded: bool,
    /// A tolerance, and how far the series reaches for it (s).
    reached: Option<[TimeIn<D, L>; 2]>,
    /// Motion at which the next series has begun: the end of the last step.
    ahead: MotionIn<D, L>,
    begun: bool,
    /// The time around which the series knows the loads (s).
    known: TimeIn<D, L>,
    /// The largest rate of an attitude, and what the largest of its coefficients of each order add to coordinates of the step.
    turns: (TimeIn<D, L>, [TimeIn<D, L>; P]),
    /// How many coefficients are found: `P`, or fewer where a tolerance asks for no more.
    order: usize,
    /// The tolerance that asked for these.
    asked: Option<TimeIn<D, L>>,
    /// Coefficients of the accelerations.
    accelerations: [D::Rate; P],
    zero: D::Rate,
    /// Room for sums.
    sums: (D::Rate, D::Rate, D::Rate),
    sweeps: usize,
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Method<D, L> for Taylor<P> {
    type Stepper = TaylorStepper<D, L, P>;

    fn stepper(&self, scene: D) -> TaylorStepper<D, L, P> {
        const { Self::KNOWN };
        let still = scene.still();
        TaylorStepper {
            series: scene.series(),
            accelerations: core::array::from_fn(|_| still.rate.clone()),
            zero: still.rate.clone(),
            sums: (still.rate.clone(), still.rate.clone(), still.rate.clone()),
            origin: still.clone(),
            ahead: still,
            stages: Dop853.stepper(scene),
            led: false,
            divided: false,
            memory: TaylorMemory::new(),
            expanded: false,
            reached: None,
            begun: false,
            known: Zero::zero(),
            turns: (Zero::zero(), [Zero::zero(); P]),
            order: P,
            asked: None,
            sweeps: 0,
        }
    }
}

impl<const P: usize> Taylor<P> {
    /// Says nothing of a scene whose motion has a series of this order. Of any other the compiler says which element, end or space is to
    /// blame, where a run by this rule would only say that there is something.
    ///
    /// ```compile_fail,E0277
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let mount = ElasticHinge::rotary(1.0).with_linear(Spring::new(1e4), Spring::new(1e4));
    /// let scene = System::new(Pinned::origin(), (rod, mount, rod), Free)?;
    /// Taylor::<12>::knows(&scene); // no walk of a series goes through such a hinge
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn knows<S, R, C, E>(_: &System<S, R, C, E>)
    where
        S: Expandable,
        R: Resting<S>,
        C: Element<S>,
        E: ExpandTip<S>,
        Elements<S, R, C>: Expand<S, Unloaded, P, E::Closures>,
    {
    }
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> TaylorStepper<D, L, P> {
    /// Begins the series at the motion ahead.
    fn open(&mut self, loads: &L) {
        let Motion { time, position, rate, acceleration, multipliers } = &mut self.ahead;
        let (motion, series) = ((&*position, &*rate), &mut self.series);
        *multipliers = self.stages.scene.begin(*time, motion, loads, self.order, series, acceleration);
        (self.begun, self.known) = (true, *time);
    }

    /// Makes the series that of a motion under loads, which may be others than before.
    fn expand(&mut self, past: &MotionIn<D, L>, loads: &L) -> Result<(), Error> {
        if D::LOADED
            && (self.begun || self.expanded)
            && !self.stages.scene.agrees(self.known, loads, self.order, &mut self.series)
        {
            (self.begun, self.expanded) = (false, false);
        }
        if self.expanded && self.origin.has_state(past.time, &past.position, &past.rate) {
            return Ok(());
        }
        if !(self.begun && self.ahead.has_state(past.time, &past.position, &past.rate)) {
            if !past.fits(&self.ahead) {
                return Err(Error::new(Fault::Shape));
            }
            self.ahead.copy_state(past);
            self.open(loads);
        }
        core::mem::swap(&mut self.origin, &mut self.ahead);
        if let Some((first, others)) = self.accelerations[..self.order].split_first_mut() {
            first.set(&self.origin.acceleration);
            if !self.stages.scene.expand(self.known, loads, &mut self.series, others) {
                (self.begun, self.expanded) = (false, false);
                return Err(Error::new(Fault::NonFiniteLoad).at_time(self.known.as_f64()));
            }
        }
        if D::Position::CURVED {
            self.note_turns();
        }
        (self.begun, self.expanded, self.reached) = (false, true, None);
        self.sweeps += 1;
        Ok(())
    }
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Stepper<D, L> for TaylorStepper<D, L, P> {
    const PLANS: bool = true;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, _: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.stages.scene.admits(loads)?;
        if past.fits(&self.ahead) && past.fits(next) { Ok(()) } else { Err(Error::new(Fault::Shape)) }
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.expand(past, loads)?;
        self.led = D::CLOSED && self.memory.leads(past.time);
        if self.led {
            return self.lead(past, loads, dt, next);
        }
        if D::Position::CURVED && self.turned(dt.abs()) >= TimeIn::<D, L>::of(2.0) {
            // Coordinates of the step would stand for another attitude.
            return Err(Error::new(Fault::NonFiniteMotion).at_time((past.time + dt).as_f64()));
        }
        next.time = past.time + dt;
        self.sum(dt, next);
        if D::CLOSED && !self.close(past, loads, next) {
            self.led = true;
            return self.take_over(past, loads, dt, next);
        }
        self.ahead.copy_state(next);
        self.open(loads);
        next.acceleration.set(&self.ahead.acceleration);
        next.multipliers = self.ahead.multipliers;
        match self.stages.scene.accept(next) {
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => {
                // Of a step that was too long the motion before it has nothing to say.
                let found = self.stages.scene.diagnose(past, loads, &mut self.stages.workspace);
                Err(if matches!(found.fault, Fault::NonFiniteMotion) { error } else { found })
            }
            outcome => outcome,
        }
    }

    fn propose(&mut self, past: &MotionIn<D, L>, loads: &L, tolerance: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        if self.asked != Some(tolerance) {
            self.asked = Some(tolerance);
            let order = order_for(tolerance.as_f64()).min(P);
            if order != self.order {
                (self.order, self.begun, self.expanded) = (order, false, false);
            }
        }
        if D::CLOSED && self.memory.leads(past.time) {
            return None; // stages try how far they come
        }
        self.expand(past, loads).ok()?;
        let reach = self.reach(tolerance);
        Some(if D::CLOSED { self.beyond(past, reach, tolerance) } else { reach })
    }

    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        if self.led {
            return self.stages.error(past, dt, next, tolerance);
        }
        Some((dt / self.reach(tolerance)).powi(self.order as i32))
    }

    fn error_order(&self) -> usize {
        if self.led { self.stages.error_order() } else { self.order }
    }

    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        if self.led && !self.divided {
            return self.stages.interpolate(past, loads, dt, next, theta, between);
        }
        if self.led {
            // A step from the start knows no place where another one was divided.
            self.stages.begin(past, loads);
            // What fails is no number, which whoever looks says.
            let _ = self.stages.make(past, loads, dt * TimeIn::<D, L>::of(theta), between);
            return;
        }
        let time = TimeIn::<D, L>::of(theta) * dt;
        between.time = past.time + time;
        self.sum(time, between);
        self.sweeps += complete(&self.stages.scene, between, loads, &mut self.stages.workspace);
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        // What is held at the end of a step is known there.
        (least <= NEAR && self.memory.holds(next.time)) || self.stages.firm(next, least)
    }

    fn sweeps(&self) -> usize {
        self.sweeps + self.stages.sweeps
    }

    /// Where another rule leads. A series is found from its motion alone.
    type Memory = TaylorMemory<TimeIn<D, L>>;

    fn memory(&self) -> Self::Memory {
        self.memory
    }

    fn restore(&mut self, memory: &Self::Memory) {
        self.memory = *memory;
    }
}
