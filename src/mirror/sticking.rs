//! The mirror of a coordinate with dry friction: whether it sticks or slips, and the friction that goes with its acceleration.

use super::fieldwise::fieldwise_rate;
use super::{Position, Rate, Term};
use crate::lift::Lift;
use crate::scalar::Scalar;
use num_traits::Zero;

/// What a joint with dry friction does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Mode {
    /// The joint does not move.
    #[default]
    Sticks,
    /// A slip at positive rate.
    SlipsForward,
    /// A slip at negative rate.
    SlipsBack,
}

impl Mode {
    /// The mode of a rate; one that is zero sticks.
    pub(crate) fn of<T: Scalar>(rate: T) -> Self {
        match rate.real() {
            rate if rate > T::Real::zero() => Self::SlipsForward,
            rate if rate < T::Real::zero() => Self::SlipsBack,
            _ => Self::Sticks,
        }
    }

    /// The sign of the rate.
    pub(crate) fn sign<T: Scalar>(self) -> T {
        match self {
            Self::Sticks => T::zero(),
            Self::SlipsForward => T::one(),
            Self::SlipsBack => -T::one(),
        }
    }
}

/// A coordinate that sticks or slips.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sticking<T> {
    /// The coordinate (rad, m).
    pub coordinate: T,
    /// What the joint does: kept through steps, changed between them.
    pub mode: Mode,
}

/// The rate of a coordinate that sticks or slips, or its acceleration.
///
/// The friction that makes it stick belongs to the acceleration: it is not counted, visited or replaced, and sums leave it as it is.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slip<T> {
    /// Of the coordinate.
    pub rate: T,
    /// With an acceleration: the friction that makes the coordinate stick, ON the outboard body, as a share of that at which it breaks away.
    pub friction: T,
}

impl<T: Scalar> Sticking<T> {
    /// What the joint does at a rate: what moves does not stick, whatever a motion says that was made by hand.
    #[inline(always)]
    pub(crate) fn mode_at(&self, rate: &Slip<T>) -> Mode {
        if self.mode == Mode::Sticks { Mode::of(rate.rate) } else { self.mode }
    }
}

impl<T: Scalar> Slip<T> {
    pub(crate) fn none() -> Self {
        Self { rate: T::zero(), friction: T::zero() }
    }
}

impl<T: Scalar> Rate<T> for Slip<T> {
    const LENGTH: usize = 1;

    fieldwise_rate!([rate friction] [rate] [rate]);
}

impl<T: Scalar> Position<T> for Sticking<T> {
    type Rate = Slip<T>;

    const STICKS: bool = true;

    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, Slip<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_0(&from.coordinate, (time, &rate.rate));
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, Slip<T>>, (u, a): Term<'_, T, Slip<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_1(&from.coordinate, (time, &rate.rate), (u, &a.rate));
    }
    #[inline(always)]
    fn drift_2(
        &mut self,
        from: &Self,
        (time, rate): Term<'_, T, Slip<T>>,
        (u, a): Term<'_, T, Slip<T>>,
        (v, b): Term<'_, T, Slip<T>>,
    ) {
        self.mode = from.mode;
        self.coordinate.drift_2(&from.coordinate, (time, &rate.rate), (u, &a.rate), (v, &b.rate));
    }
    #[inline(always)]
    fn displace(&mut self, step: &Slip<T>) {
        self.coordinate += step.rate;
    }
    #[inline(always)]
    fn apart(&self, from: &Self, displacement: &mut Slip<T>) {
        displacement.rate = self.coordinate - from.coordinate;
    }
    #[inline(always)]
    fn measure(&self, displacement: &Slip<T>, note: &mut impl FnMut(T, T)) {
        self.coordinate.measure(&displacement.rate, note);
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
        test(self.coordinate, other.coordinate) && test(self.mode.sign(), other.mode.sign())
    }
    fn each_mode(
        &mut self,
        rate: &mut Slip<T>,
        acceleration: &Slip<T>,
        visit: &mut impl FnMut(&mut Mode, &mut T, [T; 2]),
    ) {
        visit(&mut self.mode, &mut rate.rate, [acceleration.rate, acceleration.friction]);
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Sticking<T> {
    type Over = Sticking<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Sticking<U> {
        Sticking { coordinate: number(self.coordinate), mode: self.mode }
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for Slip<T> {
    type Over = Slip<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Slip<U> {
        Slip { rate: number(self.rate), friction: number(self.friction) }
    }
}
