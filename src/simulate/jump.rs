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
use super::margin::meets;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, ensure_finite};
use crate::mirror::{Mode, Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Dynamics, MotionOf, PositionOf, RateOf, Runs, System};
use num_traits::{One, Zero};

/// When a guard is zero, after the time at which it is zero but for derivatives.
#[derive(Clone, Copy)]
pub(super) enum Delay<T> {
    /// At that time: nothing hangs on anything.
    None,
    /// Later by a time (s) that is zero but for derivatives.
    By(T),
    /// Later by a time that nothing tells, for how fast the guard changes is not known.
    Unknown,
}

/// A number without what it is but for derivatives.
pub(super) fn varied<T: Scalar>(number: T) -> T {
    number - T::constant(number.real())
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

    /// When the joint of a number changes its mode.
    ///
    /// # Errors
    /// [`Fault::Unsupported`] for higher derivatives, and where joints are driven; [`Fault::NotFinite`] where a guard rests as it becomes zero.
    pub(super) fn delay(motion: &mut MotionOf<S, R, C, P>, due: usize) -> Result<Delay<S::Scalar>, Error> {
        let (mut found, mut count) = (Delay::None, 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            if count == due {
                let (guard, speed) = match *mode {
                    Mode::Swings => (told.apart, -*rate),
                    Mode::SlipsForward | Mode::SlipsBack if meets(*mode, *rate, &told) => (told.apart, -*rate),
                    Mode::SlipsForward | Mode::SlipsBack => (*rate, told.rate),
                    _ => (told.guard, S::Scalar::zero()),
                };
                let (guard, known) = (varied(guard), !mode.is_locked());
                found = match guard.is_identical(S::Scalar::zero()) {
                    true => Delay::None,
                    false if known => Delay::By(guard.scale(-RealOf::<S>::one() / speed.real())),
                    false => Delay::Unknown,
                };
            }
            count += 1;
        });
        if let Delay::By(delay) = found {
            ensure_finite(delay.is_finite(), "derivative of the time at which a joint changes its mode")?;
            let refused = if const { PositionOf::<S, R, C>::CLOCKED } {
                "derivatives of a run in which joints are driven past a change of mode"
            } else if (delay * delay).is_identical(S::Scalar::zero()) {
                return Ok(found);
            } else {
                "derivatives above the first, or numbers side by side, of a run past a change of mode"
            };
            return Err(Error::new(Fault::Unsupported { what: refused }).at_time(motion.time.as_f64()));
        }
        Ok(found)
    }

    /// Goes on by a time that is zero but for derivatives.
    pub(super) fn shifted(motion: &mut MotionOf<S, R, C, P>, delay: S::Scalar) {
        let by = |rate: &RateOf<S, R, C>| {
            let mut step = rate.clone();
            step.replace(&mut |x| x * delay);
            step
        };
        let (moved, faster) = (by(&motion.rate), by(&motion.acceleration));
        motion.position.displace(&moved);
        motion.rate.add(&faster);
    }

    /// Ends the change of mode of a joint: back to the time at which it was found, from accelerations before.
    pub(super) fn returned(&mut self, delay: Delay<S::Scalar>, before: &RateOf<S, R, C>) -> Result<(), Error> {
        let (system, loads, next) = (self.plan.system, self.plan.loads, &mut self.next);
        match delay {
            Delay::None => Ok(()),
            Delay::By(delay) => {
                Self::shifted(next, -delay);
                system.accelerate(next, loads, &mut Dynamics::<L>::workspace(system))
            }
            Delay::Unknown => {
                // Where accelerations do not jump, it does not matter when.
                let (mut jump, [mut most, mut largest]) = (before.clone(), [0.0_f64; 2]);
                jump.mix_1(&next.acceleration, (-RealOf::<S>::one(), before));
                jump.visit(&mut |x| most = most.max(x.real().as_f64().abs()));
                before.visit(&mut |x| largest = largest.max(x.real().as_f64().abs()));
                let nothing = 2.0 * Mode::reluctance::<RealOf<S>>().as_f64() * (1.0 + largest);
                let what = "derivatives of a run past where a joint breaks away from more friction than it slips with";
                let refused = Error::new(Fault::Unsupported { what }).at_time(next.time.as_f64());
                if most <= nothing { Ok(()) } else { Err(refused) }
            }
        }
    }

    /// Refuses a start in which a joint strikes whose distance from its stop has derivatives: whether it strikes at all hangs on these.
    ///
    /// # Errors
    /// [`Fault::Unsupported`].
    pub(super) fn strikes_surely(&mut self) -> Result<(), Error> {
        let (mut unsure, motion) = (false, &mut self.next);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            let side = super::margin::touched(*mode, &told);
            let strikes = side.is_some_and(|side| side * rate.real().as_f64() > 0.0);
            unsure |= strikes && !varied(told.apart).is_identical(S::Scalar::zero());
        });
        let what = "derivatives by the distance of a joint from its stop of a run that begins where it strikes";
        let refused = Error::new(Fault::Unsupported { what }).at_time(motion.time.as_f64());
        if unsure { Err(refused) } else { Ok(()) }
    }
}
