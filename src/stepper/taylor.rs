//! Steps by Taylor series.

use super::roots::{exp2, log2};
use super::{Method, MotionIn, Stepper, TimeIn};
use crate::element::Element;
use crate::ends::{Resting, Unheld};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Absent;
use crate::scalar::{Real, Scalar};
use crate::series::{Expand, Expandable};
use crate::system::{Elements, SeriesDynamics, System};
use crate::time::Taylor;
use num_traits::{One, Zero};

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
            sweeps: 0,
        }
    }
}

/// How large coordinates of a step of an attitude may become under error control: they end at 2, half a turn, and lose digits before.
const TURNED: f64 = 1.7;

/// The order whose steps to a tolerance take the least time: measured for two rods on pins and for twenty, flat within three orders.
fn order_for(tolerance: f64) -> usize {
    (3.5 - 0.48 * log2(tolerance.max(f64::MIN_POSITIVE))).max(8.0) as usize
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
        E: Unheld<S>,
        Elements<S, R, C>: Expand<S, Absent, P>,
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

    /// Begins the series at the motion ahead.
    fn open(&mut self, loads: &L) {
        let Motion { time, position, rate, acceleration, .. } = &mut self.ahead;
        self.scene.begin(*time, position, rate, loads, &mut self.series, acceleration);
        (self.begun, self.known) = (true, *time);
    }

    /// Makes the series that of a motion under loads, which may be others than before.
    fn expand(&mut self, past: &MotionIn<D, L>, loads: &L) -> Result<(), Error> {
        if D::LOADED && (self.begun || self.expanded) && !self.scene.recite(self.known, loads, &mut self.series) {
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
            self.scene.expand(&mut self.series, others);
        }
        if D::Position::CURVED {
            self.note_turns();
        }
        (self.begun, self.expanded, self.reached) = (false, true, None);
        self.sweeps += 1;
        Ok(())
    }

    /// Positions and rates at a time (s) after the origin of the series, by Horner's rule, four coefficients at a time.
    fn sum(&mut self, time: TimeIn<D, L>, to: &mut MotionIn<D, L>) {
        let Self { origin, accelerations, order, zero, sums: (position, rate, room), .. } = self;
        let (square, real) = (time * time, TimeIn::<D, L>::of);
        let powers = [TimeIn::<D, L>::one(), time, square, square * time];
        let fourth = square * square;
        position.set(zero);
        rate.set(zero);
        let (fours, few) = accelerations[..*order].as_chunks::<4>();
        for (k, coefficients) in (4 * fours.len()..).zip(few) {
            let (power, once) = (powers[k % 4], ((k + 1) as f64).recip());
            room.mix_1(position, (power * real(once / (k + 2) as f64), coefficients));
            position.set(room);
            room.mix_1(rate, (power * real(once), coefficients));
            rate.set(room);
        }
        for (block, [a, b, c, d]) in fours.iter().enumerate().rev() {
            let weights: [f64; 5] = core::array::from_fn(|i| ((4 * block + i + 1) as f64).recip());
            let of = |i: usize| powers[i] * real(weights[i] * weights[i + 1]);
            room.mix_3(zero, (fourth, position), (of(3), d), (of(2), c));
            position.mix_2(room, (of(1), b), (of(0), a));
            let of = |i: usize| powers[i] * real(weights[i]);
            room.mix_3(zero, (fourth, rate), (of(3), d), (of(2), c));
            rate.mix_2(room, (of(1), b), (of(0), a));
        }
        to.position.drift_1(&origin.position, (time, &origin.rate), (square, position));
        to.rate.mix_1(&origin.rate, (time, rate));
        if D::Position::CURVED {
            to.position.retract_rate(&origin.position, &mut to.rate);
        }
    }

    /// Finds the largest of the coefficients of each order in the displacements of attitudes.
    fn note_turns(&mut self) {
        let Self { origin, accelerations, turns, order, .. } = self;
        let largest = |rate: &D::Rate| {
            let mut largest = TimeIn::<D, L>::zero();
            origin.position.each_turn(rate, &mut |turn| {
                largest = largest.max(turn.iter().fold(TimeIn::<D, L>::zero(), |sum, x| sum + x.real() * x.real()));
            });
            largest.sqrt()
        };
        turns.0 = largest(&origin.rate);
        for (k, (turn, acceleration)) in turns.1[..*order].iter_mut().zip(&*accelerations).enumerate() {
            *turn = largest(acceleration) / TimeIn::<D, L>::of(((k + 1) * (k + 2)) as f64);
        }
    }

    /// How large coordinates of the step of an attitude are at most, from here to a time (s) after the origin of the series: the sum of
    /// the sizes of all terms.
    fn turned(&self, time: TimeIn<D, L>) -> TimeIn<D, L> {
        let terms = self.turns.1[..self.order].iter().rev();
        let sum = terms.fold(TimeIn::<D, L>::zero(), |sum, turn| sum * time + *turn);
        (sum * time + self.turns.0) * time
    }

    /// A time (s) up to a size, at which they are at most this large.
    fn turned_less(&self, most: TimeIn<D, L>, size: TimeIn<D, L>) -> TimeIn<D, L> {
        let turned = self.turned(size);
        let too_far = turned > most;
        if !too_far {
            return size;
        }
        // They grow at least in proportion to the time.
        let (mut within, mut beyond) = (size * (most / turned), size);
        for _ in 0..5 {
            let middle = (within + beyond) * TimeIn::<D, L>::of(0.5);
            if self.turned(middle) > most { beyond = middle } else { within = middle }
        }
        within
    }

    /// How long a step may be (s): as far as the last term of the series is a tolerance, by the radius of convergence that two last terms
    /// tell. Where they tell a radius of more than twice that of the two before, all four are asked: a motion from rest may have only
    /// every fourth term.
    fn reach(&mut self, tolerance: TimeIn<D, L>) -> TimeIn<D, L> {
        if let Some([known, size]) = self.reached
            && known == tolerance
        {
            return size;
        }
        // Four last coefficients of the rates, each by the size of its rate.
        let mut last = [TimeIn::<D, L>::zero(); 4];
        for (i, most) in last.iter_mut().enumerate() {
            let k = self.order - 4 + i;
            self.accelerations[k].all(&self.origin.rate, &mut |term, rate| {
                *most = most.max((term / (rate.abs() + D::Scalar::one())).real().abs());
                true
            });
            *most = *most / TimeIn::<D, L>::of((k + 1) as f64);
        }
        let mut inverse = last.map(|most| log2(most.as_f64()));
        for (i, inverse) in inverse.iter_mut().enumerate() {
            *inverse *= 1.0 / (self.order + i - 3) as f64;
        }
        let larger = |a: f64, b: f64| if a > b { a } else { b };
        let (before, newest) = (larger(inverse[0], inverse[1]), larger(inverse[2], inverse[3]));
        let inverse = if before > newest + 1.0 { before } else { newest };
        let mut size = TimeIn::<D, L>::of(exp2(log2(tolerance.as_f64()) / self.order as f64 - inverse));
        if D::Position::CURVED {
            let finite = size.min(TimeIn::<D, L>::of(2.0) / self.turns.0); // a first term of two is beyond in any case
            size = self.turned_less(TimeIn::<D, L>::of(TURNED), finite);
        }
        self.reached = Some([tolerance, size]);
        size
    }
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Stepper<D, L> for TaylorStepper<D, L, P> {
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
        self.ahead.copy_state(next);
        self.open(loads);
        next.acceleration.set(&self.ahead.acceleration);
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
        let order = order_for(tolerance.as_f64()).min(P);
        if order != self.order {
            (self.order, self.begun, self.expanded) = (order, false, false);
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

    fn error_order(&self) -> f64 {
        self.order as f64
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
        let Motion { time, position, rate, acceleration, multipliers } = between;
        *multipliers = self.scene.accelerations(*time, position, rate, loads, &mut self.workspace, acceleration);
        self.sweeps += 1;
    }

    fn sweeps(&self) -> usize {
        self.sweeps
    }

    /// Nothing: a series is found from its motion alone.
    type Memory = ();

    fn memory(&self) {}

    fn restore(&mut self, (): &()) {}
}
