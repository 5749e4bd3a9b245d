//! Steps by the predictor and corrector of Adams, Bashforth and Moulton.

use super::between::complete;
use super::displace::{displace, gather, mean_square};
use super::explicit::ExplicitStepper;
use super::{Method, MotionIn, Stepper, TimeIn};
use crate::error::{Error, Fault};
use crate::mirror::{Rate, Retraction};
use crate::motion::Motion;
use crate::scalar::{Elementary, Real};
use crate::system::Dynamics;
use crate::time::{Adams, Dopri5, Weights};

/// How many motions a predictor reads.
const DEPTH: usize = 4;

/// How near these motions may be to each other, as a share of the step.
const NEAREST: f64 = 0.05;

/// The weights of a step.
struct Pece {
    nodes: [f64; DEPTH + 1],
    predictor: Weights<DEPTH>,
    corrector: Weights<{ DEPTH + 1 }>,
    /// What the oldest motion changes: an estimate of the error.
    difference: Weights<{ DEPTH + 1 }>,
    /// By how much more a step of this size errs after steps of its size.
    growth: f64,
}

impl Pece {
    fn new(nodes: &[f64; DEPTH + 1]) -> Self {
        let ([_, known @ ..], [fewer @ .., _]) = (*nodes, *nodes);
        let (corrector, coarse) = (Weights::new(nodes, 1.0), Weights::new(&fewer, 1.0));
        let less = |fine: [f64; DEPTH + 1], coarse: [f64; DEPTH]| {
            core::array::from_fn(|j| fine[j] - coarse.get(j).unwrap_or(&0.0))
        };
        let (rate, position) = (less(corrector.rate, coarse.rate), less(corrector.position, coarse.position));
        // The estimate goes with ∫ (s − 1) s (s − s₁) (s − s₂) from 0 to 1, −19/30 for equal steps.
        let [_, _, one, two, _] = *nodes;
        let (sum, product) = (one + two, one * two);
        let own = 0.2 - 0.25 * (1.0 + sum) + (product + sum) / 3.0 - 0.5 * product;
        let growth = (19.0 / 30.0 / if own < 0.0 { -own } else { own }).max(1.0);
        let difference = Weights { rate, position };
        Self { nodes: *nodes, predictor: Weights::new(&known, 1.0), corrector, difference, growth }
    }

    /// Takes the weights of these nodes. Equal steps, whose times are rounded, share theirs.
    fn update(&mut self, nodes: &[f64; DEPTH + 1]) {
        const EQUAL: [f64; DEPTH + 1] = [1.0, 0.0, -1.0, -2.0, -3.0];
        let near = |(a, b): (&f64, &f64)| (-1e-11..=1e-11).contains(&(a - b));
        let nodes = if nodes.iter().zip(&EQUAL).all(near) { &EQUAL } else { nodes };
        if self.nodes != *nodes {
            *self = Self::new(nodes);
        }
    }
}

/// What [`AdamsStepper`] carries from step to step: the motions that it wrote.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AdamsMemory<M> {
    /// A ring: at `newest` and after it motions of the past, `known` of them, and before it what the last step wrote, if it did.
    ring: [M; DEPTH + 1],
    newest: usize,
    known: usize,
    written: bool,
}

impl<M> AdamsMemory<M> {
    /// Motions of the past, the newest one first.
    fn history(&self) -> impl Iterator<Item = &M> {
        self.ring[self.newest..].iter().chain(&self.ring)
    }
}

/// Steps by [`Adams`].
pub struct AdamsStepper<D: Dynamics<L>, L> {
    /// Steps where too little is remembered. It owns the scene.
    start: ExplicitStepper<D, L, Dopri5>,
    memory: AdamsMemory<MotionIn<D, L>>,
    /// Accelerations: predicted, and of the past motions.
    slopes: [D::Rate; DEPTH + 1],
    /// When the accelerations were, as shares of the step.
    nodes: [f64; DEPTH + 1],
    weights: Pece,
    /// Whether the weights of past accelerations made the last step.
    own: bool,
    stage: (D::Position, D::Rate),
    estimate: (D::Rate, D::Rate),
    zero: D::Rate,
}

impl<D: Dynamics<L>, L> Method<D, L> for Adams {
    type Stepper = AdamsStepper<D, L>;

    fn stepper(&self, scene: D) -> AdamsStepper<D, L> {
        let still = scene.still();
        let zero = still.rate.clone();
        AdamsStepper {
            start: Dopri5.stepper(scene),
            memory: AdamsMemory { ring: core::array::from_fn(|_| still.clone()), newest: 0, known: 0, written: false },
            slopes: core::array::from_fn(|_| zero.clone()),
            nodes: [0.0; DEPTH + 1],
            weights: Pece::new(&[1.0, 0.0, -1.0, -2.0, -3.0]),
            own: false,
            stage: (still.position, zero.clone()),
            estimate: (zero.clone(), zero.clone()),
            zero,
        }
    }
}

impl<D: Dynamics<L>, L> AdamsStepper<D, L> {
    /// Makes `past`, with the accelerations in the first row, the newest motion remembered. Where it is not the last one written, or
    /// accelerations have jumped since, nothing else is.
    fn recall(&mut self, past: &MotionIn<D, L>) {
        let first = &self.start.slopes.as_ref()[0];
        let is = |motion: &MotionIn<D, L>| {
            motion.has_state(past.time, &past.position, &past.rate) && motion.has_acceleration(first)
        };
        let AdamsMemory { ring, newest, known, written } = &mut self.memory;
        let before = (*newest + DEPTH) % (DEPTH + 1);
        if *written && is(&ring[before]) {
            *newest = before;
            *known = DEPTH.min(*known + 1);
        } else if *known == 0 || !is(&ring[*newest]) {
            ring[*newest].copy_state(past);
            ring[*newest].acceleration.set(first);
            *known = 1;
        }
        *written = false;
    }

    /// Finds when the remembered motions were, as shares of the step, and tells whether they lie far enough apart to be read.
    ///
    /// A polynomial through accelerations a share g of the step apart multiplies their errors by 1/g, by its square where three are so
    /// near. Nor does it look back where steps turned round.
    fn spread(&mut self, now: TimeIn<D, L>, dt: TimeIn<D, L>) -> bool {
        self.nodes[0] = 1.0;
        for (node, before) in self.nodes[1..].iter_mut().zip(self.memory.history()) {
            *node = ((before.time - now) / dt).as_f64();
        }
        self.nodes[1..].windows(2).all(|pair| pair[0] - pair[1] >= NEAREST)
    }

    /// Predicts, evaluates, corrects, evaluates.
    fn leap(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let Self { slopes, nodes, weights, start, stage: (position, rate), estimate, zero, .. } = self;
        for (slope, before) in slopes[1..].iter_mut().zip(self.memory.history()) {
            slope.set(&before.acceleration);
            if D::Position::CURVED {
                before.position.inverse_retract_acceleration(&past.position, &before.rate, slope);
            }
        }
        next.time = past.time + dt;
        weights.update(nodes);
        let Pece { predictor, corrector, .. } = &*weights;
        let predicted = (predictor.position.as_slice(), predictor.rate.as_slice());
        displace(past, &slopes[1..], 1.0, predicted, dt, (zero, &mut estimate.0), (position, rate));
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        start.scene.accelerations(next.time, position, rate, loads, &mut start.workspace, &mut slopes[0]);
        if D::Position::CURVED {
            position.inverse_retract_acceleration(&past.position, rate, &mut slopes[0]);
        }
        let corrected = (corrector.position.as_slice(), corrector.rate.as_slice());
        displace(past, slopes, 1.0, corrected, dt, (zero, &mut estimate.0), (&mut next.position, &mut next.rate));
        if D::Position::CURVED {
            next.position.retract_rate(&past.position, &mut next.rate);
        }
        start.scene.project(next, loads, &mut start.workspace);
        let Motion { time, position, rate, acceleration, multipliers } = next;
        *multipliers = start.scene.accelerations(*time, position, rate, loads, &mut start.workspace, acceleration);
        start.sweeps += 2;
        match start.scene.accept(next) {
            // Where the step goes wrong, Dopri5's does too.
            Err(error) if matches!(error.fault, Fault::NonFiniteMotion) => Err(start.diagnose(past, loads, dt, next)),
            outcome => outcome,
        }
    }
}

impl<D: Dynamics<L>, L> Stepper<D, L> for AdamsStepper<D, L> {
    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.start.admit(past, loads, dt, next)
    }

    fn begin(&mut self, past: &MotionIn<D, L>, loads: &L) {
        self.start.begin(past, loads);
    }

    fn resume(&mut self, past: &MotionIn<D, L>) {
        self.start.resume(past);
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        self.recall(past);
        self.own = self.memory.known == DEPTH && self.spread(past.time, dt);
        if self.own {
            self.leap(past, loads, dt, next)?;
        } else {
            self.start.make(past, loads, dt, next)?;
        }
        let AdamsMemory { ring, newest, written, .. } = &mut self.memory;
        let kept = &mut ring[(*newest + DEPTH) % (DEPTH + 1)];
        kept.copy_state(next);
        kept.acceleration.set(&next.acceleration);
        *written = true;
        Ok(())
    }

    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        if !self.own {
            return self.start.error(past, dt, next, tolerance);
        }
        let (position, rate) = &mut self.estimate;
        let Weights { rate: of_rate, position: of_position } = &self.weights.difference;
        gather(position, &self.zero, dt * dt, of_position, &self.slopes);
        gather(rate, &self.zero, dt, of_rate, &self.slopes);
        let square = mean_square(next, (position, rate), [tolerance; 2]);
        let growth = TimeIn::<D, L>::of(self.weights.growth);
        Some(Elementary::sqrt(TimeIn::<D, L>::of(square)) * growth)
    }

    fn error_order(&self) -> usize {
        5
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        self.start.firm(next, least)
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
        if !self.own {
            return self.start.interpolate(past, loads, dt, next, theta, between);
        }
        let Self { slopes, nodes, start, estimate, zero, .. } = self;
        let Weights { rate: of_rate, position: of_position } = Weights::<{ DEPTH + 1 }>::new(nodes, theta);
        let Motion { position, rate, .. } = between;
        displace(past, slopes, theta, (&of_position, &of_rate), dt, (zero, &mut estimate.0), (position, rate));
        if D::Position::CURVED {
            position.retract_rate(&past.position, rate);
        }
        between.time = past.time + TimeIn::<D, L>::of(theta) * dt;
        start.sweeps += complete(&start.scene, between, loads, &mut start.workspace);
    }

    fn sweeps(&self) -> usize {
        self.start.sweeps
    }

    type Memory = AdamsMemory<MotionIn<D, L>>;

    fn memory(&self) -> Self::Memory {
        self.memory.clone()
    }

    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        let AdamsMemory { ring, newest, known, .. } = memory;
        *newest <= DEPTH && *known <= DEPTH && ring.iter().all(|past| motion.fits(past))
    }

    fn restore(&mut self, memory: &Self::Memory) {
        self.memory.clone_from(memory);
    }

    fn restart(&mut self) {
        (self.memory.known, self.memory.written) = (0, false);
    }
}
