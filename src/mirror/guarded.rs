//! The mirror of a coordinate whose joint has modes: what the joint does, and what is told of it with an acceleration.

use super::fieldwise::fieldwise_rate;
use super::{Position, Rate, Retraction, Term};
use crate::lift::Lift;
use crate::scalar::{Elementary, Real, Scalar};
use num_traits::Zero;

/// What a joint with dry friction or with hard stops does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Mode {
    /// The joint does not move, for friction holds it.
    #[default]
    Sticks,
    /// A slip at positive rate.
    SlipsForward,
    /// A slip at negative rate.
    SlipsBack,
    /// The joint moves between its stops.
    Swings,
    /// The joint rests against its lower stop.
    RestsBelow,
    /// The joint rests against its upper stop.
    RestsAbove,
    /// The joint accelerates by one, whatever acts: what a shock does to all others is asked so.
    Struck,
    /// The joint comes to rest within the step under way ([`MoreauJean`](crate::time::MoreauJean)), for friction does it.
    Halts,
    /// The joint comes to its nearest stop within the step under way.
    Lands,
    /// The joint ends the step under way at the rate that its stop gives back.
    Rebounds,
}

impl Mode {
    /// The mode of a rate under friction; one that is zero sticks.
    pub(crate) fn of<T: Scalar>(rate: T) -> Self {
        match rate.real() {
            rate if rate > T::Real::zero() => Self::SlipsForward,
            rate if rate < T::Real::zero() => Self::SlipsBack,
            _ => Self::Sticks,
        }
    }

    /// The mode of a joint that breaks away from this friction: it goes where that does not hold it.
    pub(crate) fn broken_away<T: Scalar>(friction: T) -> Self {
        Self::of(-friction)
    }

    /// The sign of the rate, of a joint that slips.
    pub(crate) fn sign<T: Scalar>(self) -> T {
        match self {
            Self::SlipsForward => T::one(),
            Self::SlipsBack => -T::one(),
            _ => T::zero(),
        }
    }

    /// Where the joint rests against a stop: −1 at the lower one, 1 at the upper one.
    pub(crate) fn stop(self) -> Option<f64> {
        match self {
            Self::RestsBelow => Some(-1.0),
            Self::RestsAbove => Some(1.0),
            _ => None,
        }
    }

    /// Whether the joint's acceleration is given.
    pub(crate) fn is_locked(self) -> bool {
        !matches!(self, Self::SlipsForward | Self::SlipsBack | Self::Swings)
    }

    /// The mode of such a joint where it moves, with friction of whichever sign.
    pub(crate) fn moving(self) -> Self {
        match self {
            Self::Sticks | Self::Halts | Self::SlipsForward | Self::SlipsBack => Self::SlipsForward,
            _ => Self::Swings,
        }
    }

    /// The mode of such a joint of which nothing is known but its rate.
    pub(crate) fn forgotten(self) -> Self {
        match self {
            Self::Sticks | Self::Halts | Self::SlipsForward | Self::SlipsBack => Self::Sticks,
            _ => Self::Swings,
        }
    }

    /// Up to so far from its stop a joint touches it, as a share of 1 and where that is, and a rebound that rises no higher (rad, m) is none:
    /// some hundred roundings.
    pub(crate) fn touch<R: Real>() -> R {
        R::EPSILON * R::of(256.0)
    }

    /// A joint that would leave its stop at no more than this (rad/s², m/s²) stays: what leaves it for rounding comes back.
    pub(crate) fn reluctance<R: Real>() -> R {
        R::of(64.0 * Elementary::sqrt(R::EPSILON).as_f64())
    }

    /// All modes.
    const ALL: [Self; 10] = [
        Self::Sticks,
        Self::SlipsForward,
        Self::SlipsBack,
        Self::Swings,
        Self::RestsBelow,
        Self::RestsAbove,
        Self::Struck,
        Self::Halts,
        Self::Lands,
        Self::Rebounds,
    ];

    /// The mode as a number.
    pub(crate) fn number<T: Scalar>(self) -> T {
        T::literal(f64::from(self as u8))
    }

    /// The mode of a [`number`](Self::number).
    pub(crate) fn numbered<T: Scalar>(number: T) -> Self {
        let is = |mode: &&Self| mode.number::<T>().real() == number.real();
        Self::ALL.iter().find(is).copied().unwrap_or_default()
    }
}

/// Lets the last of the joints go whose acceleration is given; whether there is one.
pub(crate) fn let_last_go<T: Scalar, P: Position<T>>(position: &mut P, rate: &mut P::Rate, found: &P::Rate) -> bool {
    let (mut held, mut count) = (0, 0);
    position.each_mode(rate, found, &mut |mode, _, _| held += usize::from(mode.is_locked()));
    position.each_mode(rate, found, &mut |mode, _, _| {
        count += usize::from(mode.is_locked());
        if mode.is_locked() && count == held {
            *mode = mode.moving();
        }
    });
    held > 0
}

/// A coordinate whose joint has modes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Guarded<T> {
    /// The coordinate (rad, m).
    pub coordinate: T,
    /// What the joint does: kept through steps, changed between them.
    pub mode: Mode,
}

/// The rate of a coordinate whose joint has modes, or its acceleration.
///
/// What is told of the mode belongs to the acceleration: it is not counted, visited or replaced, and sums leave it as it is.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GuardedRate<T> {
    /// Of the coordinate.
    pub rate: T,
    /// With an acceleration, how near a change of mode is. Of a joint that sticks the friction that makes it stick, ON the outboard body, as a
    /// share of that at which it breaks away; of one between its stops −1 at the lower and 1 at the upper one, nearer to zero by the
    /// distance (rad, m) from the nearest as a share of 1 and where that is; of one that rests the acceleration with which it would leave.
    pub guard: T,
    /// With an acceleration, what the mode answers. Of a joint that does not move what is exerted ON the outboard body (N·m, N); of one
    /// between its stops the share of its rate that they give back.
    pub answer: T,
    /// With an acceleration, of a joint between its stops: from the coordinate to the nearest (rad, m).
    pub apart: T,
}

impl<T: Scalar> Guarded<T> {
    /// What the joint does at a rate: what moves does not stick or rest, whatever a motion says that was made by hand.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn mode_at(&self, rate: &GuardedRate<T>) -> Mode {
        match self.mode {
            Mode::Sticks => Mode::of(rate.rate),
            Mode::RestsBelow | Mode::RestsAbove if !rate.rate.is_zero() => Mode::Swings,
            mode => mode,
        }
    }
}

impl<T: Scalar> GuardedRate<T> {
    pub(crate) fn telling(rate: T, [guard, answer, apart]: [T; 3]) -> Self {
        Self { rate, guard, answer, apart }
    }

    pub(crate) fn none() -> Self {
        Self::telling(T::zero(), [T::zero(); 3])
    }
}

impl<T: Scalar> Rate<T> for GuardedRate<T> {
    const LENGTH: usize = 1;

    fieldwise_rate!([rate guard answer apart] [rate] [rate]);
}

impl<T: Scalar> Retraction<T> for Guarded<T> {
    type Rate = GuardedRate<T>;
}

impl<T: Scalar> Position<T> for Guarded<T> {
    const MODES: bool = true;

    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, GuardedRate<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_0(&from.coordinate, (time, &rate.rate));
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, GuardedRate<T>>, (u, a): Term<'_, T, GuardedRate<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_1(&from.coordinate, (time, &rate.rate), (u, &a.rate));
    }
    #[cfg_attr(optimised, inline(always))]
    fn drift_2(
        &mut self,
        from: &Self,
        (time, rate): Term<'_, T, GuardedRate<T>>,
        (u, a): Term<'_, T, GuardedRate<T>>,
        (v, b): Term<'_, T, GuardedRate<T>>,
    ) {
        self.mode = from.mode;
        self.coordinate.drift_2(&from.coordinate, (time, &rate.rate), (u, &a.rate), (v, &b.rate));
    }
    #[inline(always)]
    fn displace(&mut self, step: &GuardedRate<T>) {
        self.coordinate += step.rate;
    }
    #[inline(always)]
    fn apart(&self, from: &Self, displacement: &mut GuardedRate<T>) {
        displacement.rate = self.coordinate - from.coordinate;
    }
    #[inline(always)]
    fn measure(&self, displacement: &GuardedRate<T>, note: &mut impl FnMut(T, T)) {
        self.coordinate.measure(&displacement.rate, note);
    }
    #[inline(always)]
    fn square_shares(&self, displacement: &GuardedRate<T>, squares: &mut GuardedRate<T>) {
        Position::square_shares(&self.coordinate, &displacement.rate, &mut squares.rate);
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        visit(self.coordinate);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        self.coordinate = make(self.coordinate);
    }
    /// Of other modes is another motion.
    #[inline(always)]
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(self.coordinate, other.coordinate) && test(self.mode.number(), other.mode.number())
    }
    fn each_mode(
        &mut self,
        rate: &mut GuardedRate<T>,
        acceleration: &GuardedRate<T>,
        visit: &mut impl FnMut(&mut Mode, &mut T, GuardedRate<T>),
    ) {
        visit(&mut self.mode, &mut rate.rate, *acceleration);
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Guarded<T> {
    type Over = Guarded<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Guarded<U> {
        Guarded { coordinate: number(self.coordinate), mode: self.mode }
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for GuardedRate<T> {
    type Over = GuardedRate<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> GuardedRate<U> {
        GuardedRate::telling(number(self.rate), [self.guard, self.answer, self.apart].map(number))
    }
}
