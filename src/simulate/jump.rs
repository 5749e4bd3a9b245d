//! Jump terms: what a change of mode, whose time hangs on what is differentiated, does to derivatives.
//!
//! A guard g(y) is zero where a mode changes. Of numbers with derivatives it is zero but for these at the time t* that a run finds, and it
//! is zero altogether a little later, by a time δ that is zero but for derivatives. So
//!
//! ```text
//! δ = −dg / ġ      y → y + f⁻ δ      modes change, joints strike      y → y − f⁺ δ
//! ```
//!
//! with f⁻ and f⁺ the derivatives of the motion by time before and after; then derivatives are those at a fixed time again (M. A. Aizerman,
//! F. R. Gantmacher, On the stability of periodic motions, J. Appl. Math. Mech. 22, 1958).

use super::drive::Running;
use super::now::settled;
use super::strike::Blow;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, ensure_finite};
use crate::mirror::margin::{meets, touched};
use crate::mirror::{Mode, Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, PositionOf, RateOf, Runs, System};
use num_traits::{One, Zero};

/// How much later a guard is zero than at the time at which it is zero but for derivatives: by a time (s) that is zero but for these.
#[derive(Clone, Copy)]
pub(super) enum Delay<T> {
    /// Nothing hangs on anything.
    None,
    /// Of a joint that moves.
    Moving(T),
    /// Of a joint that does not move, by how fast its guard has changed: no number where that is rounding. Rates do not jump then.
    Locked(T),
}

#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
impl<T: Scalar> Delay<T> {
    /// By which time (s).
    pub(super) fn time(self) -> T {
        match self {
            Self::None => T::zero(),
            Self::Moving(delay) | Self::Locked(delay) => delay,
        }
    }
}

/// The slope at the end of four equal parts, by values from there back, of orders four and two.
const SLOPES: [[f64; 5]; 2] = [[25.0 / 12.0, -4.0, 3.0, -4.0 / 3.0, 0.25], [1.5, -2.0, 0.5, 0.0, 0.0]];
/// By such a share the two may differ of what grows steadily; beside a jump they differ by 0.28 of the first.
const STEADY: f64 = 0.1;

/// A number without what it is but for derivatives.
pub(super) fn varied<T: Scalar>(number: T) -> T {
    number - T::constant(number.real())
}

/// Goes on by a time that is zero but for derivatives.
pub(super) fn shifted<T: Scalar, Q: Position<T>, D: Closures>(motion: &mut Motion<T, Q, D>, delay: T) {
    let by = |rate: &Q::Rate| {
        let mut step = rate.clone();
        step.replace(&mut |x| x * delay);
        step
    };
    let (moved, faster) = (by(&motion.rate), by(&motion.acceleration));
    motion.position.displace(&moved);
    motion.rate.add(&faster);
}

impl<'a, S, R, C, P, L, M, E, K, O> Running<'a, S, R, C, P, L, M, E, K, O>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    K: Stepper<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    O: FnMut(&Now<'_, S, R, C, P, L>),
{
    /// Whether numbers have derivatives.
    pub(super) const DERIVED: bool = size_of::<S::Scalar>() > size_of::<RealOf<S>>();

    /// How much later the joint of a number changes its mode than at a motion with all its accelerations; `pace` tells how fast the guard of one that
    /// does not move changes (1/s).
    ///
    /// # Errors
    /// [`Fault::Unsupported`] for higher derivatives: where accelerations do not jump, their slopes do. Where it is a joint that moves, as
    /// [`jumps`](Self::jumps), and [`Fault::NotFinite`] where it does not pass on.
    pub(super) fn delay(
        &mut self,
        motion: &mut MotionOf<S, R, C, P>,
        due: usize,
        pace: impl FnOnce(&mut Self, usize) -> RealOf<S>,
    ) -> Result<Delay<S::Scalar>, Error> {
        let Some((mode, rate, told)) = Self::joint(motion, due) else { return Ok(Delay::None) };
        let (locked, strikes) = (mode.is_locked(), mode == Mode::Swings || meets(mode, rate, &told));
        let (guard, changes) = match (locked, strikes) {
            (true, _) => (told.guard, told.rate),
            (_, true) => (told.apart, -rate),
            _ => (rate, told.rate),
        };
        let guard = varied(guard);
        if guard.is_identical(S::Scalar::zero()) {
            return Ok(Delay::None);
        }
        if !(guard * guard).is_identical(S::Scalar::zero()) {
            let what = "derivatives above the first, or numbers side by side, of a run past a change of mode";
            return Err(Error::new(Fault::Unsupported { what }).at_time(motion.time.as_f64()));
        }
        let speed = if locked { pace(self, due) } else { changes.real() };
        let delay = guard.scale(-RealOf::<S>::one() / speed);
        if locked {
            return Ok(Delay::Locked(delay));
        }
        ensure_finite(delay.is_finite(), "derivative of the time at which a joint changes its mode")?;
        Self::jumps(delay, motion.time).map(|()| Delay::Moving(delay))
    }

    /// Whether there are jump terms for a delay.
    ///
    /// # Errors
    /// [`Fault::Unsupported`] where joints are driven, and for no number.
    fn jumps(delay: S::Scalar, time: RealOf<S>) -> Result<(), Error> {
        let what = if const { PositionOf::<S, R, C>::CLOCKED } {
            "derivatives of a run in which joints are driven past a change of mode"
        } else if delay.is_finite() {
            return Ok(());
        } else {
            "derivatives of a run past where a joint breaks away that was hardly, or not steadily, pulled before"
        };
        Err(Error::new(Fault::Unsupported { what }).at_time(time.as_f64()))
    }

    /// How fast what guards a joint that does not move changes (1/s) at the end of a step of a size (s), by what it was within, or, of a negative
    /// size, at the beginning of a step. No number where it has changed by rounding, or a slope of order two is another, as beside a load that jumps.
    pub(super) fn pace(&mut self, due: usize, size: RealOf<S>) -> RealOf<S> {
        let guards = [0, 1, 2, 3, 4].map(|part| {
            let share = f64::from(part) / 4.0;
            self.interpolate(size.abs(), if size < RealOf::<S>::zero() { share } else { 1.0 - share });
            let mut motion = settled(self.plan.system, self.plan.loads, &self.between);
            Self::joint(&mut motion, due).map_or(0.0, |(_, _, told)| told.guard.real().as_f64())
        });
        let [change, rough] =
            SLOPES.map(|weights| weights.iter().zip(guards).map(|(weight, guard)| weight * guard).sum::<f64>());
        let changes = (guards[0] - guards[4]).abs() > RealOf::<S>::EPSILON.sqrt().as_f64();
        let steadily = (change - rough).abs() <= STEADY * change.abs();
        RealOf::<S>::of(if changes && steadily { 4.0 * change } else { f64::NAN }) / size
    }

    /// Ends the change of mode of a joint: back to the time at which it was found, from accelerations before.
    pub(super) fn returned(&mut self, delay: Delay<S::Scalar>, before: &RateOf<S, R, C>) -> Result<(), Error> {
        let (system, loads, next) = (self.plan.system, self.plan.loads, &mut self.next);
        match delay {
            Delay::None => Ok(()),
            Delay::Moving(delay) => {
                shifted(next, -delay);
                system.accelerate(next, loads, &mut Dynamics::<L>::workspace(system))
            }
            Delay::Locked(delay) => {
                // Where accelerations do not jump, it does not matter when.
                let (mut jump, [mut most, mut largest]) = (before.clone(), [0.0_f64; 2]);
                jump.mix_1(&next.acceleration, (-RealOf::<S>::one(), before));
                jump.visit(&mut |x| most = most.max(x.real().as_f64().abs()));
                before.visit(&mut |x| largest = largest.max(x.real().as_f64().abs()));
                if most <= 2.0 * Mode::reluctance::<RealOf<S>>().as_f64() * (1.0 + largest) {
                    return Ok(());
                }
                Self::jumps(delay, next.time)?;
                jump.replace(&mut |x| -(x * delay));
                next.rate.add(&jump);
                system.accelerate(next, loads, &mut Dynamics::<L>::workspace(system))
            }
        }
    }

    /// Takes derivatives of their rates from joints that do not move, as a shock does: friction halts in no time what there is of them.
    pub(super) fn halted(&mut self) -> Result<(), Error> {
        let mut joint = 0;
        while let Some((mode, rate, _)) = Self::joint(&mut self.next, joint) {
            if mode.is_locked() && !rate.is_identical(S::Scalar::zero()) {
                self.give(&Blow { joint, rate, restitution: S::Scalar::zero() })?;
            }
            joint += 1;
        }
        let (system, loads) = (self.plan.system, self.plan.loads);
        system.accelerate(&mut self.next, loads, &mut Dynamics::<L>::workspace(system))
    }

    /// Refuses a start in which a joint strikes its stop, or stands at it, by what has derivatives: whether it strikes at all hangs on these. One that
    /// rests there may be `kept`: it begins at its stop, wherever that is.
    ///
    /// # Errors
    /// [`Fault::Unsupported`].
    pub(super) fn strikes_surely(&mut self, mut start: MotionOf<S, R, C, P>, kept: bool) -> Result<(), Error> {
        let (mut joint, sure) = (0, |x: S::Scalar| varied(x).is_identical(S::Scalar::zero()));
        while let Some((mode, rate, told)) = Self::joint(&mut start, joint) {
            let speed = touched(mode, &told).map_or(-1.0, |side| side * rate.real().as_f64());
            let rests =
                kept && speed == 0.0 && Self::joint(&mut self.next, joint).is_some_and(|(mode, ..)| mode.is_locked());
            if speed >= 0.0 && !rests && !(sure(told.apart) && (speed > 0.0 || sure(rate))) {
                let what = "derivatives of a run that begins where a joint touches its stop, by how it does: begin a little off it";
                return Err(Error::new(Fault::Unsupported { what }).at_time(start.time.as_f64()));
            }
            joint += 1;
        }
        Ok(())
    }
}
