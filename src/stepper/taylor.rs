//! Steps by Taylor series.

mod reach;
mod sums;

use super::between::complete;
use super::{Method, MotionIn, Stepper, TimeIn};
use crate::element::{Element, Unloaded};
use crate::ends::{ExpandTip, Resting};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::mirror::{Position, Rate, Retraction};
use crate::motion::Motion;
use crate::scalar::{Powers, Real, Scalar};
use crate::series::{Expand, Expandable};
use crate::system::{Elements, SeriesDynamics, System};
use crate::time::Taylor;
use num_traits::{One, Zero};
use reach::order_for;

/// Steps by [`Taylor`].
pub struct TaylorStepper<D: SeriesDynamics<L, P>, L, const P: usize> {
    scene: D,
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
    /// For readings within a step.
    workspace: D::Workspace,
    sweeps: usize,
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Method<D, L> for Taylor<P> {
    type Stepper = TaylorStepper<D, L, P>;

    fn stepper(&self, scene: D) -> TaylorStepper<D, L, P> {
        const { Self::KNOWN };
        let still = scene.still();
        TaylorStepper {
            series: scene.series(),
            workspace: scene.workspace(),
            accelerations: core::array::from_fn(|_| still.rate.clone()),
            zero: still.rate.clone(),
            sums: (still.rate.clone(), still.rate.clone(), still.rate.clone()),
            origin: still.clone(),
            ahead: still,
            scene,
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

    /// Begins the series at the motion ahead.
    fn open(&mut self, loads: &L) {
        let Motion { time, position, rate, acceleration, multipliers } = &mut self.ahead;
        let (motion, series) = ((&*position, &*rate), &mut self.series);
        *multipliers = self.scene.begin(*time, motion, loads, self.order, series, acceleration);
        (self.begun, self.known) = (true, *time);
    }

    /// Makes the series that of a motion under loads, which may be others than before.
    fn expand(&mut self, past: &MotionIn<D, L>, loads: &L) -> Result<(), Error> {
        if D::LOADED
            && (self.begun || self.expanded)
            && !self.scene.agrees(self.known, loads, self.order, &mut self.series)
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
            if !self.scene.expand(self.known, loads, &mut self.series, others) {
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
        self.scene.admits(loads)?;
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
        if D::Position::CURVED && self.turned(dt.abs()) >= TimeIn::<D, L>::of(2.0) {
            // Coordinates of the step would stand for another attitude.
            return Err(Error::new(Fault::NonFiniteMotion).at_time((past.time + dt).as_f64()));
        }
        next.time = past.time + dt;
        self.sum(dt, next);
        if D::CLOSED {
            // Closed through gains of its own, as between steps.
            let Motion { time, position, rate, acceleration, .. } = &mut *next;
            self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
            self.scene.project(next, loads, &mut self.workspace);
            self.sweeps += 1;
        }
        self.ahead.copy_state(next);
        self.open(loads);
        next.acceleration.set(&self.ahead.acceleration);
        next.multipliers = self.ahead.multipliers;
        match self.scene.accept(next) {
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => {
                // Of a step that was too long the motion before it has nothing to say.
                let found = self.scene.diagnose(past, loads, &mut self.workspace);
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
        self.expand(past, loads).ok()?;
        Some(self.reach(tolerance))
    }

    fn error(
        &mut self,
        _: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        _: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        Some((dt / self.reach(tolerance)).powi(self.order as i32))
    }

    fn error_order(&self) -> usize {
        self.order
    }

    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        _: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        let time = TimeIn::<D, L>::of(theta) * dt;
        between.time = past.time + time;
        self.sum(time, between);
        self.sweeps += complete(&self.scene, between, loads, &mut self.workspace);
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        self.scene.independent(next, &self.workspace, least, &mut |_, _| ()).is_ok()
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }

    /// Nothing: a series is found from its motion alone.
    type Memory = ();

    fn memory(&self) {}

    fn restore(&mut self, (): &()) {}
}
