//! What a multistep method remembers: motions, differences of their accelerations, and what it makes of them next.

use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use crate::stepper::roots::{exp2, log2};
use crate::time::vcabm::{MOST, TERMS};
use num_traits::Zero;

/// How many differences are kept: those that the highest order reads, and one.
const KEPT: usize = MOST + 1;
/// How many motions: as many, and the one that was written.
const LENGTH: usize = KEPT + 1;
/// How near motions may be to each other, as a share of the step: differences multiply errors by as much as they are nearer.
const NEAREST: f64 = 0.05;
/// The largest step, as a multiple of the last one.
const GROWTH: f64 = 2.0;
/// By how much steps should be longer, if they are not left as they are.
const WORTH: f64 = 1.05;
/// By how much steps of the next higher order should be longer, if it is to be taken.
const WORTH_AN_ORDER: f64 = 1.1;
/// The share of the tolerance at which steps aim.
const AIM: f64 = 0.2;
/// So often a step may fail before all but the last motion is forgotten.
const FAILURES: usize = 3;
/// An error (as a multiple of the tolerance) that is no matter of the step's size: closures are all but dependent of each other nearby.
const STARTLING: f64 = 100.0;
/// So many steps another method makes then.
const BRIDGE: usize = 3;

/// What [`VcabmStepper`](super::VcabmStepper) carries from step to step.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VcabmMemory<M, V, R> {
    /// A ring: at `newest` and after it motions of the past, and before it what the last step wrote, if it did.
    ring: [M; LENGTH],
    newest: usize,
    /// How many differences are known, and motions in a scene whose positions are curved.
    pub(super) known: usize,
    /// Modified divided differences of accelerations, the newest motion first.
    pub(super) differences: [V; KEPT],
    /// Sizes of the steps that led to the newest motion and to those before (s).
    pub(super) sizes: [f64; LENGTH],
    written: bool,
    /// By how much the accelerations at the end of the last step are not those predicted, its size, its order and its scales.
    pub(super) change: V,
    size: f64,
    made: usize,
    scales: [f64; TERMS],
    /// The order that the next step should have, and its size (s).
    pub(super) order: usize,
    wanted: Option<R>,
    /// Whether orders rise from step to step, and for how many steps they have stayed.
    starting: bool,
    steady: usize,
    failures: usize,
    /// Steps that another method is still to make.
    bridge: usize,
}

impl<T: Scalar, P: Position<T>, C: Closures> VcabmMemory<Motion<T, P, C>, P::Rate, T::Real> {
    pub(super) fn new(still: &Motion<T, P, C>, zero: &P::Rate) -> Self {
        Self {
            ring: core::array::from_fn(|_| still.clone()),
            newest: 0,
            known: 0,
            differences: core::array::from_fn(|_| zero.clone()),
            sizes: [0.0; LENGTH],
            written: false,
            change: zero.clone(),
            size: 0.0,
            made: 0,
            scales: [0.0; TERMS],
            order: 1,
            wanted: None,
            starting: true,
            steady: 0,
            failures: 0,
            bridge: 0,
        }
    }

    /// Whether a method can go on from it at a motion.
    pub(super) fn sound(&self, motion: &Motion<T, P, C>) -> bool {
        let Self { ring, newest, known, differences, sizes, change, made, order, wanted, .. } = self;
        let fits = |rate: &P::Rate| motion.rate.all(rate, &mut |_, _| true);
        let counts = *newest < LENGTH && *known <= KEPT && *made <= MOST && (1..=MOST).contains(order);
        let advances = wanted.is_none_or(|size| size.is_finite() && size > Zero::zero());
        counts
            && advances
            && sizes.iter().all(|size| size.is_finite())
            && ring.iter().all(|past| motion.fits(past))
            && differences.iter().all(fits)
            && fits(change)
    }

    /// The place in the ring of what the last step wrote.
    fn before(&self) -> usize {
        (self.newest + LENGTH - 1) % LENGTH
    }

    /// The size (s) of the step that should follow the last one.
    pub(super) fn proposed(&self, past: &Motion<T, P, C>) -> Option<T::Real> {
        let known = self.written && self.ring[self.before()].has_state(past.time, &past.position, &past.rate);
        if known { self.wanted } else { None }
    }

    /// Makes `past`, with accelerations, the newest motion remembered. Where it is not the last one written, or accelerations have jumped
    /// since, nothing else is.
    pub(super) fn recall(&mut self, past: &Motion<T, P, C>, first: &P::Rate) {
        let is = |motion: &Motion<T, P, C>| {
            motion.has_state(past.time, &past.position, &past.rate) && motion.has_acceleration(first)
        };
        let before = self.before();
        if self.written && self.made == 0 && is(&self.ring[before]) {
            self.newest = before;
            self.differences[0].set(first);
            (self.known, self.order, self.starting, self.steady, self.failures) = (1, 1, true, 0, 0);
            self.bridge = self.bridge.saturating_sub(1);
        } else if self.written && is(&self.ring[before]) {
            self.newest = before;
            self.sizes.copy_within(..LENGTH - 1, 1);
            self.sizes[0] = self.size;
            self.advance(first);
            self.failures = 0;
        } else if self.known > 0 && is(&self.ring[self.newest]) {
            self.failures = self.failures.saturating_add(usize::from(self.written));
            if self.failures >= FAILURES {
                (self.known, self.order, self.starting, self.steady) = (1, 1, true, 0);
            }
        } else {
            let kept = &mut self.ring[self.newest];
            kept.copy_state(past);
            kept.acceleration.set(first);
            self.differences[0].set(first);
            (self.known, self.order, self.starting, self.steady, self.failures) = (1, 1, true, 0, 0);
            self.bridge = 0;
        }
        self.written = false;
    }

    /// Whether another method should make the step under way.
    pub(super) fn bridged(&self) -> bool {
        self.bridge > 0
    }

    /// Has another method make the next steps, if this error (as a multiple of the tolerance) is startling.
    pub(super) fn startled(&mut self, error: f64) {
        if error.is_nan() || error > STARTLING {
            self.bridge = BRIDGE;
        }
    }

    /// Has another method make the next steps, for closures are all but dependent nearby.
    pub(super) fn lead_over(&mut self) {
        self.bridge = BRIDGE;
    }

    /// Keeps a step of another method, after which nothing is remembered but its end.
    pub(super) fn write_bridge(&mut self, next: &Motion<T, P, C>) {
        self.write(next, 0.0, 0, &[0.0; TERMS]);
    }

    /// Wants a step of this size (s) after the last one of another method.
    pub(super) fn want(&mut self, size: T::Real) {
        self.wanted = (self.bridge == 1).then_some(size);
    }

    /// Counts no trials that failed before the step that was written: who takes up what it has left goes on from its end, or makes it anew,
    /// which is no failure.
    pub(super) fn forgive(&mut self) {
        if self.written {
            self.failures = 0;
        }
    }

    /// Forgets all motions.
    pub(super) fn forget(&mut self) {
        (self.known, self.written) = (0, false);
    }

    /// Differences after the step that was written. Those of curved positions are found anew for each step, in its coordinates.
    fn advance(&mut self, first: &P::Rate) {
        if P::CURVED {
            self.known = KEPT.min(self.known + 1);
            return;
        }
        let (order, real) = (self.made, T::Real::of);
        let more = self.known > order && order + 1 < KEPT;
        if more {
            let [.., last, next] = &mut self.differences[..order + 2] else { return };
            next.mix_1(&self.change, (-real(self.scales[order]), last));
        }
        self.differences[order].set(&self.change);
        for i in (1..order).rev() {
            let [difference, next] = &mut self.differences[i..i + 2] else { return };
            difference.scale_onto(real(self.scales[i]), next);
        }
        self.differences[0].set(first);
        self.known = KEPT.min(order + 1 + usize::from(more));
    }

    /// Finds the first differences of curved positions, in coordinates of the step from `past`.
    pub(super) fn spread(&mut self, count: usize, past: &Motion<T, P, C>, room: &mut P::Rate) {
        if !P::CURVED {
            return;
        }
        let Self { ring, newest, differences, sizes, .. } = self;
        let history = ring[*newest..].iter().chain(&*ring);
        for (difference, before) in differences[..count].iter_mut().zip(history) {
            difference.set(&before.acceleration);
            before.position.inverse_retract_acceleration(&past.position, &before.rate, difference);
        }
        // φᵢ₊₁(n) = φᵢ(n) − βᵢ(n) φᵢ(n − 1).
        let mut ages = [0.0; LENGTH];
        for i in 1..count {
            ages[i] = ages[i - 1] + sizes[i - 1];
        }
        let mut scales = [1.0; LENGTH];
        for level in 1..count {
            for j in (level..count).rev() {
                let from = j - level;
                let [newer, older] = &mut differences[j - 1..=j] else { return };
                room.mix_1(newer, (-T::Real::of(scales[from]), older));
                older.set(room);
            }
            for from in 0..count - level - 1 {
                scales[from] *= (ages[from + level] - ages[from]) / (ages[from + 1 + level] - ages[from + 1]);
            }
        }
    }

    /// A size (s) as it is, or that of the last step where it differs from it as times are rounded.
    pub(super) fn size(&self, size: f64) -> f64 {
        let last = self.sizes[0];
        let near = self.known > 1 && (size - last).abs() <= 1e-11 * last.abs();
        if near { last } else { size }
    }

    /// How many differences may be read by a step of a size (s): motions lie far enough apart, and on one side.
    pub(super) fn usable(&self, size: f64) -> usize {
        let least = NEAREST * size * size;
        let far = |before: &&f64| **before * size >= least;
        // Nearly always all are far, and a loop without a way out is put in lanes.
        let (others, all) = (self.known - 1, self.sizes.iter().fold(true, |all, before| all & far(&before)));
        if all { 1 + others } else { 1 + self.sizes[..others].iter().take_while(far).count() }
    }

    /// Keeps what a step has made.
    pub(super) fn write(&mut self, next: &Motion<T, P, C>, size: f64, order: usize, scales: &[f64; TERMS]) {
        let before = self.before();
        let kept = &mut self.ring[before];
        kept.copy_state(next);
        kept.acceleration.set(&next.acceleration);
        (self.written, self.size, self.made, self.scales) = (true, size, order, *scales);
        self.wanted = None;
    }

    /// Whether the next step has a low order, and not because steps have just begun.
    pub(super) fn is_low(&self, order: usize) -> bool {
        !self.starting && self.order <= order
    }

    /// Whether the next step could have one order more.
    pub(super) fn may_rise(&self) -> bool {
        !self.starting && self.steady > self.made / 2 && self.known > self.made
    }

    /// Chooses order and size of the next step from errors (as multiples of the tolerance) of the last one, had it had this order, the one
    /// below, the one above.
    pub(super) fn choose(&mut self, [own, lower, higher]: [Option<f64>; 3], dt: T::Real, most: usize) {
        // After a step of another method, one that fails may be judged before it is kept: then no order has been made yet.
        let order = self.made.max(1);
        // By how much steps could be longer, of which most need the logarithm alone.
        let length = |error: Option<f64>, order: usize| {
            error.map_or(f64::NEG_INFINITY, |error| log2(AIM / error.clamp(1e-30, 1e30)) * ((order + 1) as f64).recip())
        };
        let (mut best, mut longest) = (order, length(own, order));
        let shorter = length(lower, order.saturating_sub(1));
        if shorter > longest {
            (best, longest) = (order - 1, shorter);
        }
        let mut longest = exp2(longest);
        if !own.is_some_and(|own| own <= 1.0) {
            (self.order, self.starting, self.steady) = (best, false, 0);
            return;
        }
        if self.starting {
            if longest < 1.0 || order == most {
                self.starting = false;
            } else {
                best = order + 1;
            }
        } else if best == order {
            let risen = exp2(length(higher, order + 1));
            if risen > longest * WORTH_AN_ORDER {
                (best, longest) = (order + 1, risen);
            }
        }
        self.steady = if best == order { self.steady.saturating_add(1) } else { 0 };
        let longer = if longest >= WORTH { longest.min(GROWTH) } else { longest.min(1.0) };
        self.order = best;
        self.wanted = Some(dt * T::Real::of(longer));
    }
}
