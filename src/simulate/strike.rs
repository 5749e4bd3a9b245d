//! Shocks in a run: joints that strike their stops, and what that does to all rates.

use super::drive::Running;
use super::jump::varied;
use super::{EventFunction, Now};
use crate::element::{Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::margin::{forward, nearness, touched};
use crate::mirror::{Mode, Position, Rate, let_all_go, with_joint};
use crate::scalar::{Real, Scalar};
use crate::stepper::{Stepper, inconsistent};
use crate::system::{Dynamics, MotionOf, RateOf, Runs, System};
use num_traits::{One, Zero};

/// Blows at one instant after which joints that touch their stops are brought to rest at once.
const BLOWS: usize = 256;
/// Rebounds at one instant that rise no higher than what touches, before it is clear that they do not end.
const REBOUNDS: usize = 10_000;
/// Up to so many roundings of the largest rate before a shock, and what touches once a second, the rate of a joint at its stop is none.
const ROUNDINGS: f64 = 64.0;

/// A joint that strikes: its number, its rate, and the share of that which it gets back.
pub(super) struct Blow<T> {
    pub(super) joint: usize,
    pub(super) rate: T,
    pub(super) restitution: T,
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
    /// Changes rates until no joint that touches its stop moves into it, and finds the modes that follow. Joints that strike at one instant do so
    /// one after another, the fastest first, as long as they are few; then all [at once](Self::hold_back). No finite force bears a shock, so that what
    /// sticks or rests moves meanwhile.
    pub(super) fn strike(&mut self) -> Result<(), Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let (mut workspace, next) = (Dynamics::<L>::workspace(system), &mut self.next);
        let_all_go(&mut next.position, &mut next.rate, &next.acceleration);
        let mut largest = 0.0_f64;
        next.rate.visit(&mut |rate| largest = largest.max(rate.real().as_f64().abs()));
        system.accelerate(next, loads, &mut workspace)?;
        self.stand();
        let rounding = largest * RealOf::<S>::EPSILON.as_f64() * ROUNDINGS;
        let still = rounding.max(Mode::touch::<RealOf<S>>().as_f64());
        let mut joint = 0;
        // After these all are brought to rest, and seen to be.
        for count in 0..BLOWS + 2 {
            let next = &mut self.next;
            system.accelerate(next, loads, &mut workspace)?;
            let Some(blow) = Self::fastest(next, still) else {
                next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
                    let rests = touched(*mode, &told).filter(|_| told.rubs && rate.real().is_zero());
                    *mode = rests.map_or(Mode::at(*rate, told.rubs), Mode::resting);
                });
                self.settle_modes(None)?;
                return self.end_rebounds();
            };
            joint = blow.joint;
            if count < BLOWS {
                self.give(&blow)?;
            } else if !self.hold_back(still)? {
                break;
            }
        }
        Err(inconsistent(joint, self.next.time))
    }

    /// Refuses a motion with a joint beyond its stop.
    ///
    /// # Errors
    /// [`Fault::OutOfRange`].
    pub(super) fn stands_between(&mut self) -> Result<(), Error> {
        let (system, loads, motion) = (self.plan.system, self.plan.loads, &mut self.next);
        system.accelerate(motion, loads, &mut Dynamics::<L>::workspace(system))?;
        let (most, mut beyond) = (1.0 + Mode::touch::<RealOf<S>>().as_f64(), None);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, _, told| {
            if nearness(*mode, &told).is_some_and(|near| near > most) {
                beyond = Some(told.apart.real().as_f64().abs());
            }
        });
        let Some(value) = beyond else { return Ok(()) };
        let (parameter, outside) = ("distance of a joint beyond its hard stop", "a hard stop does not yield");
        let fault = Fault::OutOfRange { parameter, value, least: 0.0, most: 0.0, outside };
        Err(Error::new(fault).at_time(motion.time.as_f64()))
    }

    /// Puts joints that touch a stop, or that a long step has brought beyond it by rounding, where that is.
    fn stand(&mut self) {
        let motion = &mut self.next;
        let mut step = motion.rate.clone();
        step.replace(&mut |_| S::Scalar::zero());
        motion.position.each_mode(&mut step, &motion.acceleration, &mut |mode, step, told| {
            if touched(*mode, &told).is_some() {
                *step = told.apart;
            }
        });
        motion.position.displace(&step);
    }

    /// Ends rebounds that rise no higher than what touches, now that it is known what rests and by how much others are pressed.
    fn end_rebounds(&mut self) -> Result<(), Error> {
        let mut joint = 0;
        for _ in 0..REBOUNDS {
            let Some(blow) = Self::lowest(&mut self.next) else { return Ok(()) };
            joint = blow.joint;
            self.give(&blow)?;
            // A joint that has all but come to rest may be turned round by it.
            let next = &mut self.next;
            next.position.each_mode(&mut next.rate, &next.acceleration, &mut |mode, rate, told| {
                if forward(*mode, *rate) < 0.0 {
                    *mode = Mode::at(*rate, told.rubs);
                }
            });
            self.settle_modes(None)?;
        }
        Err(inconsistent(joint, self.next.time))
    }

    /// Changes all rates by a blow.
    pub(super) fn give(&mut self, blow: &Blow<S::Scalar>) -> Result<(), Error> {
        let mut response = self.response(blow.joint)?;
        let [rate, restitution] = [blow.rate, blow.restitution].map(|x| x.real().as_f64());
        let (next, change) = (&mut self.next, -(1.0 + restitution) * rate);
        let before = next.rate.clone();
        next.rate.mix_1(&before, (RealOf::<S>::of(change), &response));
        let (mut after, mut count) = (S::Scalar::literal(-restitution * rate), 0);
        if const { Self::DERIVED } {
            let returned = blow.restitution * blow.rate;
            let change = -varied(blow.rate + returned);
            response.replace(&mut |x| x * change);
            next.rate.add(&response);
            after -= varied(returned);
        }
        next.position.each_mode(&mut next.rate, &next.acceleration, &mut |_, rate, _| {
            if count == blow.joint {
                *rate = after; // but for rounding it is
            }
            count += 1;
        });
        Ok(())
    }

    /// By how much all rates change where that of a joint with modes changes by one: the difference of two sweeps in which its
    /// acceleration is given.
    pub(super) fn response(&self, joint: usize) -> Result<RateOf<S, R, C>, Error> {
        let (system, loads) = (self.plan.system, self.plan.loads);
        let mut workspace = Dynamics::<L>::workspace(system);
        let mut under = |given: Mode| {
            let mut motion = self.next.clone();
            // What moves is not locked; that its rate is zero here changes both sweeps alike.
            with_joint(&mut motion.position, &mut motion.rate, &motion.acceleration, joint, &mut |mode, rate, _| {
                (*mode, *rate) = (given, S::Scalar::zero());
            });
            system.accelerate(&mut motion, loads, &mut workspace)?;
            Ok::<_, Error>(motion.acceleration)
        };
        let (one, struck, still) = (RealOf::<S>::one(), under(Mode::Struck)?, under(Mode::RestsBelow)?);
        let mut response = struck.clone();
        response.mix_1(&struck, (-one, &still));
        Ok(response)
    }

    /// The joint that moves into its stop fastest. What is `still` at its stop is put to rest.
    fn fastest(motion: &mut MotionOf<S, R, C, P>, still: f64) -> Option<Blow<S::Scalar>> {
        let touch = Mode::touch::<RealOf<S>>().as_f64();
        let (mut worst, mut blow, mut count) = (0.0, None, 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            let joint = count;
            count += 1;
            let Some(side) = touched(*mode, &told) else { return };
            let speed = side * rate.real().as_f64();
            if speed.abs() <= still {
                *rate = S::Scalar::zero();
            } else if speed > worst {
                let share = told.answer.real().as_f64();
                let rises = !is_low(share * speed, side * told.rate.real().as_f64(), touch);
                let restitution = if rises { told.answer } else { S::Scalar::zero() };
                (worst, blow) = (speed, Some(Blow { joint, rate: *rate, restitution }));
            }
        });
        blow
    }

    /// A joint whose rebound rises no higher than what touches, with the blow that ends it.
    fn lowest(motion: &mut MotionOf<S, R, C, P>) -> Option<Blow<S::Scalar>> {
        let touch = Mode::touch::<RealOf<S>>().as_f64();
        let (mut blow, mut count) = (None, 0);
        motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, rate, told| {
            let (joint, speed) = (count, rate.real().as_f64());
            count += 1;
            let Some(side) = touched(*mode, &told) else { return };
            if side * speed < 0.0 && is_low(speed, side * told.rate.real().as_f64(), touch) {
                blow = Some(Blow { joint, rate: *rate, restitution: S::Scalar::zero() });
            }
        });
        blow
    }
}

/// Whether a rebound at this rate, pressed back by this acceleration, rises no higher than that.
fn is_low(rate: f64, pressed: f64, height: f64) -> bool {
    0.5 * rate * rate <= pressed.max(0.0) * height
}
